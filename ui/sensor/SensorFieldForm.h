#pragma once
/// The Earth's field in which a model is looked at: of a site on a date, or typed. It is no part of the model and is not
/// stored.

#include <QWidget>

#include <vector>

#include "core/base/Clock.h"
#include "core/record/Site.h"
#include "core/sensor/SensorSetup.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace lubberline::ui {

class ParameterCell;

class SensorFieldForm : public QWidget {
    Q_OBJECT

public:
    /// It begins with the field of today.
    explicit SensorFieldForm(const Clock& clock, QWidget* parent = nullptr);

    /// Sites without latitude and longitude are left out. What was typed stays; a site that is no more becomes what it gave.
    void setSites(const std::vector<Site>& sites);
    void showSite(SiteId site, Date date);
    void showTyped(const MeridianField& field);

    /// Errors: no such date, outside the years of every model, blackout zone.
    [[nodiscard]] const Result<MeridianField>& field() const { return m_field; }
    /// As a Model JSON states it: place and date where a site is chosen.
    [[nodiscard]] std::variant<MeridianField, PlaceAndDate, TotalField> stated() const;

signals:
    void played();  ///< a slider moves
    void changed(); ///< at rest

private:
    QWidget* buildCells();
    void playHorizontal(double horizontal_nT);
    void playDip(double dip_deg);
    void playDown(double down_nT);
    void playTyped(const MeridianField& field);
    void compute();
    void showField();
    [[nodiscard]] const Site* site() const; ///< null: typed

    std::vector<Site> m_sites;
    QComboBox* m_choice;
    QLineEdit* m_date;
    ParameterCell *m_horizontal = nullptr, *m_dip = nullptr, *m_down = nullptr;
    QLabel* m_words;
    QString m_source; ///< the model's name and its cautions
    Result<MeridianField> m_field;
    MeridianField m_last; ///< the last that existed
};

} // namespace lubberline::ui
