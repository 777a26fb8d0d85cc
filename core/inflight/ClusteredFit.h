#pragma once
/// Coefficients from flights whose reports share errors: the flight is what counts, not the report.
///   model of a flight: e = X(β + b) + ε,  b ~ N(0, T) its own (an error of the reference wind is a sine of the heading),  ε ~ N(0, σ²/w);
///   each flight tells M = (I + N T/σ²)⁻¹ N/σ² of β, N = Σ w x xᵀ; T and σ² by restricted maximum likelihood over the fleet.
/// Standard errors are those of the flights left out one by one (the jackknife of clusters, CR3), never less than those of the model.

#include <span>
#include <vector>

#include "core/inflight/FlightSums.h"

namespace lubberline {

/// The errors that reports of a flight share, as standard deviations [deg].
struct SharedError {
    double offset_deg = 0; ///< of c
    double sine_deg = 0;   ///< of a and of b; a tenth of it stands in each of the second order
    double freedom = 0;    ///< of its estimate: how many more coefficients the flights tell than they have in common; 0: none is known
};

/// What a flight tells of the coefficients.
struct FlightTold {
    WindMatrix information = WindMatrix::Zero(); ///< [1/deg²]
    WindRow score = WindRow::Zero();
};

/// σ² of one report of weight 1 [deg²]: what is left within the flights when each has coefficients of its own.
[[nodiscard]] double scatterWithin(std::span<const FlightSums* const> flights, int columns);

[[nodiscard]] FlightTold toldByFlight(const FlightSums& sums, double scatter, const SharedError& shared, int columns);

/// Flights of one aircraft in order of time, and σ² of its reports.
struct AircraftFlights {
    std::vector<const FlightSums*> flights;
    double scatter = 0;
};
/// Over a fleet, from short runs of flights: a change between two of them hardly tells in it.
[[nodiscard]] SharedError sharedErrorOf(std::span<const AircraftFlights> fleet);

struct ClusteredFit {
    int columns = 3; ///< 3 or 5: up to which order
    bool told[kWindColumns] = {};
    WindRow value = WindRow::Zero(); ///< [deg]; zero where not told
    WindMatrix covariance = WindMatrix::Zero();
    int flights = 0;
    WindMatrix information = WindMatrix::Zero(); ///< of all flights
    WindRow score = WindRow::Zero();
    WindMatrix directions = WindMatrix::Zero(); ///< that the headings tell, in its first columns
    int rank = 0;
    bool errorsTold = false; ///< more flights than one, or the errors that flights share are known
    [[nodiscard]] double standardError(int column) const;
};

/// @param sums of all the flights together: which coefficients their headings tell
[[nodiscard]] ClusteredFit fitFlights(std::span<const FlightTold> flights, const FlightSums& sums, int columns, bool sharedKnown);
/// Without one of the flights: for what is held out.
[[nodiscard]] WindRow valueWithout(const ClusteredFit& fit, const FlightTold& left);

/// Whether the second order is there: Wald's statistic on its two coefficients against F with flights − 1.
[[nodiscard]] double chanceOfNoSecondOrder(const ClusteredFit& fit);

} // namespace lubberline
