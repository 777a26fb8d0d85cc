#pragma once
/// What a guided swing is to be: procedure, points, datum instrument, site, configurations, people.

#include <QWidget>

#include "core/record/SwingJob.h"
#include "db/stores/Stores.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QVBoxLayout;

namespace lubberline::ui {

/// A datum that reads magnetic headings, where no instrument was entered.
[[nodiscard]] DatumInstrument plainDatum();

class GuidedStart : public QWidget {
    Q_OBJECT

public:
    GuidedStart(db::Stores& stores, QWidget* parent = nullptr);

    /// For a compass, on a day (ISO 8601, UTC). Errors: those of the stores.
    Result<void> begin(CompassId compass, Date today);
    [[nodiscard]] CompassId compass() const { return m_compassSystem.id; }
    [[nodiscard]] AircraftId aircraft() const { return m_compassSystem.aircraft; }
    /// What it begins with from now on, by RecordId; what is not there is left open.
    void setUsual(std::function<RecordId()> site, std::function<RecordId()> datum);
    [[nodiscard]] const QString& whose() const { return m_whose; } ///< aircraft and compass, for the page's head

signals:
    void started(lubberline::SwingId swing);
    void goOn(lubberline::SwingId swing); ///< with one that was begun
    void cancelled();

private:
    QLineEdit* addLine(QFormLayout& form, const QString& title, const char* name, const QString& placeholder = {});
    QComboBox* addBox(QFormLayout& form, const QString& title, const char* name, const QStringList& words = {});
    void build();
    void offerOpen(CompassId compass);
    void check(); ///< is the site, is the datum fit for that day?
    void start();
    [[nodiscard]] Message whyNot() const;
    [[nodiscard]] Result<Swing> particulars() const;
    [[nodiscard]] SwingJob job() const;
    [[nodiscard]] DatumInstrument datum() const;
    [[nodiscard]] const Site* site() const;
    [[nodiscard]] double paintedOffset_deg() const;

    db::Stores& m_stores;
    CompassSystem m_compassSystem;
    std::vector<Site> m_sites;
    std::vector<DatumInstrument> m_instruments;
    QString m_whose;
    QVBoxLayout* m_open; ///< a button for each that was begun
    std::function<RecordId()> m_usualSite, m_usualDatum;
    QComboBox *m_procedure, *m_points, *m_datum, *m_site, *m_radio;
    QLabel* m_meaning;
    QLineEdit *m_date, *m_engines, *m_electrics, *m_further, *m_datumReader, *m_cockpitReader, *m_adjuster, *m_reason, *m_workOrder,
        *m_override;
    QPlainTextEdit* m_checklist;
    QLabel* m_complaint;
    QPushButton* m_start;
};

} // namespace lubberline::ui
