#pragma once
/// Declination of very many places and times (reports of aircraft): between nodes of 1°, kept as they are asked for. Within 0.05° of the
/// model up to 75° of latitude where a compass points (H above 8000 nT); beyond 75° the model itself is asked.

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "core/earth/FieldModel.h"

namespace lubberline {

class DeclinationNodes {
public:
    /// [deg, east positive] at the height of aircraft, by the default model of the year (core/earth/FieldModel.h); none outside the years of
    /// the models, for a place that is none, and where H < 2000 nT.
    /// @param year decimal
    [[nodiscard]] std::optional<double> at(double latitude_deg, double longitude_deg, double year);

private:
    struct Node {
        float declination_deg = 0, rate_deg = 0; ///< in the middle of its year, and a year
        bool told = false;
    };
    const Node& node(int latitude, int longitude, int year);
    [[nodiscard]] std::optional<double> fromModel(double latitude_deg, double longitude_deg, double year);

    std::unordered_map<std::uint32_t, Node> m_nodes;
    // The cell of the last report: the next one is mostly in it, too.
    int m_latitude = 1000, m_longitude = 1000, m_year = 0;
    Node m_corner[4];
};

} // namespace lubberline
