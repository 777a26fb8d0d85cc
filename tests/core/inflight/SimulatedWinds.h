#pragma once
/// Wind reports of aircraft with a known indication error e = c + a sin ψ' + b cos ψ', beside a reference wind whose errors a flight shares.

#include <functional>
#include <random>
#include <string>

#include "core/inflight/WindStudy.h"
#include "core/inflight/WindVector.h"

namespace lubberline::test {

struct SimulatedAircraft {
    std::string name = "SP-LRA";
    double c_deg = 0.4, a_deg = 2.0, b_deg = -1.0, d_deg = 0, e_deg = 0;
    int flights = 20, reports = 20, legs = 3;
    int changesAfter = -1; ///< the flight after which a and b are others
    double aAfter_deg = 0, bAfter_deg = 0;
};

struct SimulatedReference {
    double shared_kt = 2, wandering_kt = 2; ///< of each component: of a flight, and along it (correlation 0.9)
    double biasEast_kt = 0, biasNorth_kt = 0;
};

class SimulatedWinds {
public:
    explicit SimulatedWinds(std::uint64_t seed) : m_engine(seed) {}

    /// Calls `take` with every report.
    void fly(const SimulatedAircraft& aircraft, const SimulatedReference& reference, const std::function<void(WindReport&)>& take)
    {
        for (int flight = 0; flight < aircraft.flights; ++flight)
            flyOnce(aircraft, reference, flight, take);
    }
    double normal() { return m_normal(m_engine); }
    double unit() { return m_unit(m_engine); }

private:
    void flyOnce(
        const SimulatedAircraft& aircraft, const SimulatedReference& reference, int flight, const std::function<void(WindReport&)>& take)
    {
        const bool after = aircraft.changesAfter >= 0 && flight > aircraft.changesAfter;
        const double a = after ? aircraft.aAfter_deg : aircraft.a_deg, b = after ? aircraft.bAfter_deg : aircraft.b_deg;
        // In braces, draws come in the order in which they are written; arguments of a call are evaluated in any.
        const Eigen::Vector2d bias{
            reference.biasEast_kt + reference.shared_kt * normal(), reference.biasNorth_kt + reference.shared_kt * normal()};
        Eigen::Vector2d wandering{reference.wandering_kt * normal(), reference.wandering_kt * normal()};
        const double direction_deg = 360 * unit(), speed_kt = 15 + 20 * unit();
        const Eigen::Vector2d wind = velocityOf(direction_deg, speed_kt);
        const double first_deg = 360 * unit();
        const std::string name = "F" + std::to_string(100 + flight);
        for (int i = 0; i < aircraft.reports; ++i) {
            const double true_deg = first_deg + 360.0 / aircraft.legs * (i * aircraft.legs / aircraft.reports) + 2 * normal();
            double read_deg = true_deg;
            for (int round = 0; round < 8; ++round) {
                const double read = toRadians(read_deg);
                read_deg = true_deg + aircraft.c_deg + a * std::sin(read) + b * std::cos(read) + aircraft.d_deg * std::sin(2 * read)
                    + aircraft.e_deg * std::cos(2 * read);
            }
            wandering = 0.9 * wandering + std::sqrt(1 - 0.81) * reference.wandering_kt * Eigen::Vector2d{normal(), normal()};
            const double airspeed_kt = 430 + 10 * normal();
            const Eigen::Vector2d ground = velocityOf(true_deg, airspeed_kt) + wind;
            const double tas_kt = airspeed_kt + 3 + normal();
            const Eigen::Vector2d reported = ground - velocityOf(read_deg + 0.2 * normal(), tas_kt);
            const Eigen::Vector2d held = wind + bias + wandering;
            WindReport report;
            report.groundSpeed_kt = ground.norm();
            report.track_deg = directionOf_deg(ground);
            report.tas_kt = tas_kt;
            report.wind_kt = reported.norm();
            report.windFrom_deg = directionOf_deg(-reported);
            report.reference_kt = held.norm();
            report.referenceFrom_deg = directionOf_deg(-held);
            report.time_s = 1.7e9 + 86400.0 * flight + 300.0 * i;
            report.aircraft = aircraft.name;
            report.flight = name;
            take(report);
        }
    }

    std::mt19937_64 m_engine;
    std::normal_distribution<double> m_normal;
    std::uniform_real_distribution<double> m_unit;
};

} // namespace lubberline::test
