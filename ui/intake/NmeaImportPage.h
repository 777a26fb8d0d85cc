#pragma once
/// A log of a slow turn as a swing: what of it is used, what is cut off and why, and the curve that it gives.

#include <memory>

#include "core/nmea/NmeaSwing.h"
#include "db/stores/Stores.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Page.h"
#include "ui/kit/Worker.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace lubberline::ui {

class SwingPlot;

class NmeaImportPage : public Page {
    Q_OBJECT

public:
    NmeaImportPage(db::Stores& stores, FileQuestions questions, QWidget* parent = nullptr);

    /// The compass that the swing is to be of. Errors: those of the stores.
    Result<void> showCompass(CompassId compass);
    void readLog(const QString& path);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] Shown shown() const override { return {m_compass.aircraft, m_compass.id}; }
    [[nodiscard]] Plot* plot() const override;

signals:
    void makeSwing(const lubberline::Swing& swing);

private:
    void build();
    void choose();
    void start();
    void take(Result<NmeaSwing> read);
    void showAnswer();
    void make();
    [[nodiscard]] Result<NmeaOptions> options() const;

    db::Stores& m_stores;
    FileQuestions m_questions;
    CompassSystem m_compass;
    QString m_path;
    NmeaOptions m_used;
    std::string m_datum; ///< what the answer was held against, in words
    std::shared_ptr<const NmeaSwing> m_swing;
    QLabel* m_summary;
    QComboBox *m_reference, *m_wind, *m_kind;
    QLineEdit *m_variation, *m_variationError, *m_speed, *m_rate, *m_talker, *m_date;
    QPushButton *m_read, *m_cancel, *m_make;
    SwingPlot* m_plot;
    Worker<NmeaSwing> m_worker; ///< reads the log
};

} // namespace lubberline::ui
