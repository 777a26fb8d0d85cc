#pragma once
/// A state that is followed from one scalar measurement to the next, z = h·x + error: a Kalman filter (Joseph's form, P kept symmetric) that
/// starts from nothing. Until the measurements tell the whole state it gathers their information exactly (by Givens rotations); the first
/// solution is then that of least squares, and what follows stays it: without process noise the state is the batch solution at any time.

#include <Eigen/Core>

namespace lubberline {

inline constexpr int kMostStates = 24;

class StateFilter {
public:
    using State = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostStates, 1>;
    using Covariance = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostStates, kMostStates>;

    struct Innovation {
        double value = 0, variance = 0;
        bool told = false; ///< the state was told before this measurement
        bool taken = true; ///< not beyond the gate
    };

    explicit StateFilter(int states);
    /// From an earlier flight.
    StateFilter(State state, Covariance covariance);

    /// @param gate in standard deviations, beyond which a measurement is not taken; 0: all are
    Innovation update(const State& h, double z, double variance, double gate = 0);
    /// The state may have moved: process noise, or a change that was found.
    void widen(const State& variances);

    [[nodiscard]] int states() const { return m_states; }
    [[nodiscard]] bool told() const { return m_told; } ///< all of the state
    [[nodiscard]] const State& state() const { return m_state; }
    [[nodiscard]] const Covariance& covariance() const { return m_covariance; }
    /// Of measurements so far: the inverse of the covariance, also where it has none.
    [[nodiscard]] Covariance information() const;
    /// What the measurements tell of a state that they do not tell whole: the shortest solution.
    [[nodiscard]] State partial() const;

private:
    void gather(const State& h, double z, double variance);

    int m_states;
    bool m_told = false;
    State m_state, m_right;          ///< R x = right
    Covariance m_covariance, m_root; ///< R, upper triangle
    State m_waiting;                 ///< process noise that came before the state was told
};

} // namespace lubberline
