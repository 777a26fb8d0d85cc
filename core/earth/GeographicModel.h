#pragma once
/// A table of Gauss coefficients, summed by GeographicLib:
///   V = a Σ_n Σ_m (a/r)^(n+1) (g_nm cos mλ + h_nm sin mλ) P_nm(sin φ'),  B = −grad V     (WMM2025 report, section 1.2)
/// with Schmidt's semi-normalised P, geocentric latitude φ', a = 6371.2 km, and g, h linear in time within an epoch. Its own
/// MagneticModel does the same but reads only files.

#include <deque>
#include <vector>

#include <GeographicLib/CircularEngine.hpp>
#include <GeographicLib/SphericalHarmonic.hpp>
#include <GeographicLib/SphericalHarmonic1.hpp>

#include "core/earth/EarthField.h"
#include "core/earth/FieldTables.h"

namespace lubberline {

/// The field [nT] and its change [nT a year] in geodetic axes.
struct FieldAndRate {
    EarthField field, rate;
};

/// The field on a circle of latitude: the sums over degree are done once for all its longitudes.
class FieldCircle {
public:
    [[nodiscard]] EarthField at(double longitude_deg) const;

private:
    friend class GeographicModel;
    double m_sinLatitude = 0, m_cosLatitude = 1; ///< geodetic
    GeographicLib::CircularEngine m_sums;
};

/// May be used by several threads at once.
class GeographicModel {
public:
    explicit GeographicModel(const FieldTable& table);
    /// @param year decimal; before the first epoch and after the last one their own change goes on.
    /// @param place any height [m] outside the Earth's core: makePlace() keeps to those of aircraft.
    [[nodiscard]] FieldAndRate at(double year, const Place& place) const;
    [[nodiscard]] FieldCircle circle(double year, double latitude_deg, double height_m) const;

private:
    /// In GeographicLib's order: by columns of order, degree 0 too; of h without order 0.
    struct Columns {
        std::vector<double> g, h;
    };
    /// GeographicLib points into the columns, so an epoch stays where it was made.
    struct Epoch {
        Epoch(Columns main, Columns change, int degree);
        Epoch(const Epoch&) = delete;
        Epoch& operator=(const Epoch&) = delete;
        const Columns main, change; ///< [nT], [nT a year]
        const GeographicLib::SphericalHarmonic1 field;
        const GeographicLib::SphericalHarmonic rate;
    };
    static Columns columnsOf(const GaussSet& set, int degree);
    [[nodiscard]] std::size_t epochAt(double year) const;
    [[nodiscard]] double yearsSince(std::size_t epoch, double year) const;

    double m_firstEpoch, m_epochStep;
    std::deque<Epoch> m_epochs;
};

} // namespace lubberline
