#pragma once
/// A guided swing in work: every step is stored before it counts, and where the swing stands is computed from what is stored.

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

#include "core/deviation/SlipCheck.h"
#include "core/earth/EarthField.h"
#include "core/procedure/DatumHeading.h"
#include "core/procedure/JobState.h"
#include "core/record/Fleet.h"
#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

/// What a guided swing needs from outside.
struct GuidedServices {
    std::function<Result<void>(const SwingJob& job, const JobEvent& event)> store; ///< on disk when it returns ok
    std::function<std::string()> nowUtc;                                           ///< ISO 8601
};

/// The figures of one entry of the crew: one to three of each.
struct Entry {
    std::vector<double> datum_deg, astern_deg, compass_deg;
};

/// "178", "178 178.5 178", "178°30'": one to three headings, apart by spaces or slashes. Errors: InvalidInput, naming the text.
Result<std::vector<double>> parseFigures(const QString& text);

class GuidedJob : public QObject {
    Q_OBJECT

public:
    explicit GuidedJob(GuidedServices services, QObject* parent = nullptr);

    /// Takes up a job where it stands. @param record the swing that it belongs to, with aircraft, compass and limits.
    /// @param siblings what is expected where there is no swing before (db::JobStore::siblingsOf()).
    /// Errors: those of stateOf(): nothing is changed then.
    Result<void> open(SwingJob job, const SwingRecord& record, std::shared_ptr<const Analysis> previous, const QString& previousLabel,
        const std::optional<ExpectedCurve>& siblings = {});
    void close() { m_open = false; }

    [[nodiscard]] bool isOpen() const { return m_open; }
    [[nodiscard]] const SwingJob& job() const { return m_job; }
    [[nodiscard]] const JobState& state() const { return m_state; }
    [[nodiscard]] const SwingRecord& record() const { return m_record; }
    [[nodiscard]] const DatumInstrument& datum() const { return m_state.datum; } ///< of the next reading
    /// What the instrument should show about when the aircraft stands on a heading [deg]; none: the sun tells.
    [[nodiscard]] std::optional<double> datumShould_deg(double magnetic_deg) const;
    /// The station to be worked on; null in other phases.
    [[nodiscard]] const StationState* station() const;

    /// Stores an event and goes on from it. Errors: what the state refuses, and those of the store: nothing is changed then.
    Result<void> tell(job::What what);

    /// A reading at the current station: checked and judged before it is stored.
    struct Prepared {
        job::ReadingTaken reading;
        SlipJudgement judgement;
        double datumSpread_deg = 0, compassSpread_deg = 0;
        Message note; ///< the aircraft stands more than 5° from the nominal heading; ahead and astern differ
        /// What is stored with the reading where it is kept in spite of that: in English, whatever the window's language.
        [[nodiscard]] std::string keptNote() const;
    };
    Result<Prepared> prepare(const Entry& entry) const;

    /// The station that was read or skipped last and can be read again; −1: none.
    [[nodiscard]] int lastRead() const;
    /// A station is read again, or after all where it was skipped. Errors: those of tell().
    Result<void> readAgain(int station);
    /// What it costs to leave out the station to be worked on, in words; empty where nothing can be told.
    [[nodiscard]] QString skipCostWords() const;

    /// The swing as it is so far, for the live plot: the check swing once it has begun, as found before.
    [[nodiscard]] SwingPicture picture() const;

    /// What the readings of a swing that it makes share by the sun or the model's variation, where nobody stated it.
    void tellDatumErrors(Swing& swing) const;

    /// By the sun: that the clock seems an hour wrong; empty: it does not, or nothing tells it.
    [[nodiscard]] Message clockDoubt() const;
    /// What an astrocompass is set to now; empty for another datum, or where the base's place is not known.
    [[nodiscard]] QString astroSetting() const;

signals:
    void changed();

private:
    [[nodiscard]] std::optional<Place> placeOfSun() const;
    [[nodiscard]] Result<DatumHeading> headingOf(const RawFigures& raw, Message& note) const;

    GuidedServices m_services;
    SwingJob m_job;
    JobState m_state;
    SwingRecord m_record;
    std::shared_ptr<const Analysis> m_previous;
    QString m_previousLabel;
    std::optional<ExpectedCurve> m_siblings;
    bool m_open = false;
};

} // namespace lubberline::ui
