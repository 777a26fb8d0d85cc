#pragma once
/// As RoundTrip.h, for what is read and not written again by the same code: reading ends, and an error is one clear line.
/// @return whether the bytes could be read.

#include <string_view>

namespace lubberline::test {

bool checkModelJson(std::string_view bytes);
bool checkAirframeJson(std::string_view bytes);
bool checkElectricalJson(std::string_view bytes);
bool checkScenario(std::string_view bytes);
bool checkRows(std::string_view bytes); ///< documents in columns of the database, and the lines of the recovery file
bool checkNmea(std::string_view bytes);
bool checkCoefficients(std::string_view bytes);
bool checkAngle(std::string_view bytes);
bool checkWindCsv(std::string_view bytes);
bool checkSensorLog(std::string_view bytes);
bool checkInflightCsv(std::string_view bytes);  ///< legs, continuous swings, actions
bool checkReferenceCsv(std::string_view bytes); ///< pairs of compasses, the sun
/// The first three bytes choose a cell of a small database, the rest is what it holds; then everything is read.
bool checkDatabaseRow(std::string_view bytes);
bool checkPdf(std::string_view bytes); ///< the attachment of a report

} // namespace lubberline::test
