#pragma once
/// What one flight of one aircraft tells of the indication error e = read − true of its heading, as sums: reports are not kept.
///   e = c + a sin ψ' + b cos ψ' + d sin 2ψ' + f cos 2ψ',  ψ' the heading that was read                                   [M 6]

#include <array>
#include <cstdint>

#include <Eigen/Core>

namespace lubberline {

inline constexpr int kWindColumns = 5; ///< 1, sin ψ', cos ψ', sin 2ψ', cos 2ψ'
using WindRow = Eigen::Matrix<double, kWindColumns, 1>;
using WindMatrix = Eigen::Matrix<double, kWindColumns, kWindColumns>;

struct FlightSums {
    std::int64_t count = 0;
    WindMatrix normal = WindMatrix::Zero(); ///< Σ w x xᵀ, w robust and by airspeed squared
    WindRow product = WindRow::Zero();      ///< Σ w x e [deg]
    double squares = 0;                     ///< Σ w e² [deg²]
    // Airspeed reported less the airspeed in the reference wind [kt].
    double airspeedOffset = 0, airspeedSquares = 0, airspeed = 0;
    double windOnReference = 0, referenceSquares = 0; ///< Σ W W_ref, Σ W_ref² ahead [kt²]: their ratio shows the unit of the winds
    double declination = 0;                           ///< Σ [deg]
    std::int64_t declined = 0;
    std::int64_t withoutTold = 0; ///< reports whose declination is not known

    FlightSums& operator+=(const FlightSums& other);
    /// One report more; only the lower triangles are kept.
    struct Report;
    void add(const Report& report);
};

struct FlightSums::Report {
    std::array<double, kWindColumns> row{}; ///< x
    double weight = 0, error_deg = 0;
    double turned = 0, turnedAcross = 0;   ///< k² + d·V_A
    double product = 0, productAcross = 0; ///< k d
    double squaredError = 0, squaredAcross = 0;
    double airspeedOffset = 0, airspeed = 0;
};

/// Of the wind's error [kt]: a correction by β [rad] turns the air velocity, so across the track it is d + k xᵀβ.
struct WindForms {
    std::int64_t count = 0;
    WindMatrix turned = WindMatrix::Zero(), turnedAcross = WindMatrix::Zero(); ///< Σ (k² + d·V_A) x xᵀ
    WindRow error = WindRow::Zero(), errorAcross = WindRow::Zero();            ///< Σ k d x
    double squaredError = 0, squaredAcross = 0;                                ///< Σ d²

    WindForms& operator+=(const WindForms& other);
    void add(const FlightSums::Report& report);
};

struct WindRmse {
    double total_kt = 0, longitudinal_kt = 0, transverse_kt = 0;
};
struct WindSquares {
    double total = 0, across = 0;
    std::int64_t count = 0;
    WindSquares& operator+=(const WindSquares& other);
    [[nodiscard]] WindRmse rmse() const;
};
/// Of wind errors once β [deg] of indication error is taken out of the headings; zero: as they are.
[[nodiscard]] WindSquares windSquares(const WindForms& forms, const WindRow& beta_deg);

} // namespace lubberline
