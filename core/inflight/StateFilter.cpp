#include "core/inflight/StateFilter.h"

#include <Eigen/Core>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Spectra.h"
#include "core/base/Contract.h"

namespace lubberline {

namespace {

/// The state is told when no direction of the (scaled) information is so much weaker than the strongest.
constexpr double kToldRatio = 1e-4;

} // namespace

StateFilter::StateFilter(int states)
    : m_states(states)
    , m_state(State::Zero(states))
    , m_right(State::Zero(states))
    , m_covariance(Covariance::Zero(states, states))
    , m_root(Covariance::Zero(states, states))
    , m_waiting(State::Zero(states))
{
    LUBBERLINE_EXPECT(states > 0 && states <= kMostStates, "1 to 24 states");
}

StateFilter::StateFilter(State state, Covariance covariance) : StateFilter(static_cast<int>(state.size()))
{
    m_state = std::move(state);
    m_covariance = std::move(covariance);
    m_told = true;
}

void StateFilter::gather(const State& h, double z, double variance)
{
    State row = h / std::sqrt(variance);
    double right = z / std::sqrt(variance);
    for (int i = 0; i < m_states; ++i) {
        if (row(i) == 0.0)
            continue;
        const double length = std::hypot(m_root(i, i), row(i)), c = m_root(i, i) / length, s = row(i) / length;
        for (int j = i; j < m_states; ++j) {
            const double upper = m_root(i, j);
            m_root(i, j) = c * upper + s * row(j);
            row(j) = c * row(j) - s * upper;
        }
        const double upper = m_right(i);
        m_right(i) = c * upper + s * right;
        right = c * right - s * upper;
    }
    if (m_root.diagonal().cwiseAbs().minCoeff() == 0.0)
        return;
    const Covariance information = product(m_root.transpose(), m_root);
    const State scale = information.diagonal().cwiseSqrt().cwiseInverse();
    const Covariance scaled = scale.asDiagonal() * information * scale.asDiagonal();
    const Eigen::VectorXd values = symmetricValues(scaled);
    if (values(0) < kToldRatio * values(m_states - 1))
        return;
    m_state = m_root.triangularView<Eigen::Upper>().solve(m_right);
    const Covariance inverse = m_root.triangularView<Eigen::Upper>().solve(Covariance::Identity(m_states, m_states));
    m_covariance = inverse * inverse.transpose();
    m_covariance.diagonal() += m_waiting;
    m_told = true;
}

StateFilter::Innovation StateFilter::update(const State& h, double z, double variance, double gate)
{
    if (!m_told) {
        gather(h, z, variance);
        return {};
    }
    const State gained = m_covariance * h;
    Innovation innovation{z - h.dot(m_state), h.dot(gained) + variance, true, true};
    if (gate > 0 && innovation.value * innovation.value > gate * gate * innovation.variance) {
        innovation.taken = false;
        return innovation;
    }
    const State gain = gained / innovation.variance;
    m_state += gain * innovation.value;
    // (I − K h) P (I − K h)ᵀ + K R Kᵀ, multiplied out for one measurement; the upper triangle is computed and mirrored.
    for (int i = 0; i < m_states; ++i)
        for (int j = i; j < m_states; ++j) {
            const double value = m_covariance(i, j) - gain(i) * gained(j) - gained(i) * gain(j) + gain(i) * gain(j) * innovation.variance;
            m_covariance(i, j) = value;
            m_covariance(j, i) = value;
        }
    return innovation;
}

void StateFilter::widen(const State& variances)
{
    if (m_told)
        m_covariance.diagonal() += variances;
    else
        m_waiting += variances;
}

StateFilter::Covariance StateFilter::information() const
{
    if (!m_told)
        return product(m_root.transpose(), m_root);
    const SymmetricParts parts = symmetricParts(m_covariance);
    return composed(parts.vectors, parts.values.cwiseMax(1e-30).cwiseInverse());
}

StateFilter::State StateFilter::partial() const
{
    if (m_told)
        return m_state;
    const Covariance information = product(m_root.transpose(), m_root);
    const SymmetricParts parts = symmetricParts(information);
    const double least = kToldRatio * parts.values(m_states - 1);
    State solution = State::Zero(m_states);
    const State right = m_root.transpose() * m_right;
    for (int i = 0; i < m_states; ++i)
        if (parts.values(i) > least && least > 0)
            solution += parts.vectors.col(i) * (parts.vectors.col(i).dot(right) / parts.values(i));
    return solution;
}

} // namespace lubberline
