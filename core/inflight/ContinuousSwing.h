#pragma once
/// The continuous swing: A to E followed through flights against any heading reference,
///   δ = A + B sin ψ' + C cos ψ' + D sin 2ψ' + E cos 2ψ' + Σ I (b sin ψ' + c cos ψ'),   I the current of each electrical load [A]
/// (of a whole sensor model the row of ModelRow.h in place of the first five) by a Kalman filter, with an alarm when the iron changed: χ² of what the last 10, 20, 40 and 80 whitened innovations say of it
/// (InnovationWatch.h), at a chance that gives a false alarm in one of twenty series of 1400 updates, in one of five where the air turns rough for a while (simulated). Innovations that resemble
/// their neighbours are whitened by their own correlation first, with room for what that correlation is not known by, and the errors that
/// are told widened by (1 + ρ)/(1 − ρ): with correlations of 0.5 to 0.99 no more than 12 % of series have a false alarm (simulated on legs
/// of 20 updates), and 1° in B is found after 40 to 180 updates instead of 11. A leg that is named counts as one update.
/// The error of a pair of headings that nobody states is found from how the first 100 updates scatter, and followed; a stated one that the
/// innovations contradict is not trusted by the alarm (HeadingNoise.h).

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/inflight/HeadingNoise.h"
#include "core/inflight/InnovationWatch.h"
#include "core/inflight/ModelRow.h"
#include "core/inflight/StateFilter.h"

namespace lubberline {

struct ContinuousSample {
    double time_s = 0;
    double compassHeading_deg = 0;
    double deviation_deg = 0; ///< reference (magnetic) − compass
    std::optional<double> referenceError_deg;
    std::optional<std::string> leg;
    std::vector<double> current_A; ///< of each load
    FlownAt at = {};               ///< of a whole model
};

/// A log that is in a state already: taken once more it would count twice.
struct TakenLog {
    std::uint64_t print = 0, beginning = 0; ///< of its times, headings and deviations, all and the first of them; 52 bits
    double from_s = 0, to_s = 0;
    std::int64_t samples = 0;
};

/// What is kept with a compass from flight to flight.
struct ContinuousState {
    double time_s = 0; ///< of the last update, as the log had it
    std::int64_t updates = 0;
    std::vector<std::string> loads;
    std::optional<double> horizontal_nT; ///< of a whole model: that P, Q and R are counted over
    StateFilter::State state_deg;
    StateFilter::Covariance covariance;
    std::vector<TakenLog> logs = {};
};

/// What a log has in common with those of a state.
enum class TakenBefore {
    Nothing,
    Whole,     ///< it is one of them
    Beginning, ///< one of them begins with the same readings
    Time,      ///< one of them was written at the same time, by a clock that both have
};
[[nodiscard]] TakenBefore takenBefore(const TakenLog& log, const std::vector<TakenLog>& before);

struct ContinuousOptions {
    std::optional<double> noise_deg; ///< of a heading pair where the log states none; none: it is found from the log
    double drift_deg = 0;            ///< random walk of each coefficient over √day
    std::vector<std::string> loads;
    /// The whole sensor model is followed in place of A to E; P, Q and R are counted over this H.
    std::optional<double> wholeModelOver_nT;
    std::optional<ContinuousState> start;
};

struct ContinuousAlarm {
    double time_s = 0, since_s = 0;  ///< when it was raised, and since when what it names explains most
    int window = 0;                  ///< innovations
    double p = 1;                    ///< of the window
    std::string coefficient;         ///< that explains most of it
    std::vector<std::string> orElse; ///< others that explain next to as much on the headings that were flown since
    double change_deg = 0, standardError_deg = 0;
    double from_s = 0, to_s = 0; ///< between which it happened, at 95 % or more
};

struct ContinuousPoint {
    double time_s = 0;
    StateFilter::State state_deg, standardError_deg;
};

struct LegMean {
    std::string leg;
    double time_s = 0, compassHeading_deg = 0, deviation_deg = 0;
    int samples = 0;
};

struct ContinuousResult {
    std::vector<std::string> names; ///< of the states: A … E, "B per A of NAME", …
    std::int64_t updates = 0, gated = 0;
    std::vector<std::optional<double>> state_deg, standardError_deg; ///< none where the headings do not tell it
    std::optional<double> nisMean, whitenessP, correlation;
    std::optional<double> noise_deg; ///< of a heading pair whose error was stated nowhere, as it was found
    double noiseRatio = 1; ///< of the variance that the innovations show to the one that is stated, where they contradict it; in the above
    double widened = 1;    ///< (1 + ρ)/(1 − ρ) in the variances above, where neighbours resemble each other
    std::vector<Message> nullDirections;
    std::vector<ContinuousAlarm> alarms;
    std::vector<ContinuousPoint> history;  ///< at most some 500
    std::vector<std::string> historyNames; ///< of its figures: those of the states; of a whole model A to E, level in the field of the time
    std::vector<LegMean> legs;             ///< headings of 10° together where the log names no legs
    /// Of a whole model: it, and what it makes of A to E level in the field of the last update.
    struct Whole {
        std::optional<SensorModel> model; ///< where all of it is told; k is 0
        std::array<std::optional<double>, 5> level_deg, levelError_deg;
        MeridianField field;
    };
    std::optional<Whole> whole;
    ContinuousState state; ///< only where told
    TakenLog log;          ///< what was added; it is the last one of the state
    bool told = false;
    std::vector<Message> warnings;
};

/// 1, sin ψ', cos ψ', sin 2ψ', cos 2ψ', and I sin ψ', I cos ψ' of each load.
[[nodiscard]] StateFilter::State continuousRow(double compass_deg, const std::vector<double>& current_A, std::size_t loads);
/// States before those of loads.
[[nodiscard]] inline int coreStates(bool wholeModel) { return wholeModel ? kModelStates : 5; }

/// A state that knows no loads, before a log that has some: of these nothing is known yet.
[[nodiscard]] ContinuousState withLoads(const ContinuousState& state, const std::vector<std::string>& loads);

class ContinuousSwing {
public:
    explicit ContinuousSwing(const ContinuousOptions& options);
    /// In order of time; the caller checks that.
    void add(const ContinuousSample& sample);
    [[nodiscard]] ContinuousResult finish();

    static constexpr double kGate = 4.0;

private:
    struct Kept { ///< of the last innovations
        StateFilter::State h, before;
        double z = 0, variance = 1, noise = 1, time_s = 0; ///< variance: of the innovation; noise: of z
    };
    void keepPrint(const ContinuousSample& sample);
    void endLeg();
    void update(const ContinuousSample& sample, std::optional<double> variance);
    void learnNoise();
    void take(const ContinuousSample& sample, double variance);
    [[nodiscard]] StateFilter::State rowOf(const ContinuousSample& sample) const;
    [[nodiscard]] double measured(const ContinuousSample& sample, const StateFilter::State& row) const;
    [[nodiscard]] double noiseRatio() const; ///< of variances
    [[nodiscard]] StateFilter::Covariance keptCovariance(double ratio) const;
    void watch(const Kept& kept, double white);
    void raise(int window, double p);
    void nameChange();
    void placeChange(Eigen::Index coefficient, double most);
    void keepPoint(double time_s);
    [[nodiscard]] double correlation() const;
    [[nodiscard]] double widening() const; ///< of variances: (1 + ρ)/(1 − ρ)
    [[nodiscard]] double whitening() const;
    [[nodiscard]] double leftOfCorrelation(double rho) const;

    ContinuousOptions m_options;
    StateFilter m_filter;
    std::vector<std::string> m_names;
    std::optional<double> m_last_s, m_firstDeviation_deg;
    TakenLog m_log;
    // The first updates, until they have shown how they scatter.
    struct Waiting {
        ContinuousSample sample;
        std::optional<double> variance; ///< that is stated
    };
    std::vector<Waiting> m_waiting;
    bool m_learnt = false, m_unstated = false;
    double m_noiseFound = kUsualNoise_deg * kUsualNoise_deg; ///< variance of updates that state none
    NoiseScale m_scale;
    double m_turnSine = 0, m_turnCosine = 0; ///< sums, of the deviations
    std::int64_t m_updates = 0, m_gated = 0, m_whitened = 0, m_before = 0;
    std::deque<Kept> m_kept;
    InnovationWatch m_watch;
    StateFilter::State m_previousRow; ///< of the innovation before, standardised
    double m_nis = 0, m_previous = 0, m_product = 0, m_square = 0;
    std::int64_t m_pairs = 0;
    std::array<double, 10> m_lags{}; ///< Σ of products of innovations so many updates apart
    std::deque<double> m_recent;
    std::vector<ContinuousAlarm> m_alarms;
    std::vector<Kept> m_naming;  ///< from before the window of the last alarm on, until what changed is named for good
    std::size_t m_namedFrom = 0; ///< those that came after the alarm
    int m_namedHeadings = 0;     ///< headings since that alarm, one after the other
    StateFilter::State m_namedOn;
    std::vector<ContinuousPoint> m_history;
    std::int64_t m_stride = 1;
    std::vector<LegMean> m_legs;
    // The leg that is being flown.
    std::string m_leg;
    double m_legSine = 0, m_legCosine = 0, m_legDeviation = 0, m_legVariance = 0, m_legTime = 0, m_legFirst = 0;
    bool m_legStated = true;
    std::vector<double> m_legCurrent;
    FlownAt m_legAt; ///< sums
    FlownAt m_lastAt;
    int m_legSamples = 0;
    std::array<LegMean, 36> m_sectors{};
    std::array<double, 36> m_sectorOff{}, m_sectorDeviation{}; ///< sums, from the first of the sector
};

} // namespace lubberline
