#include "tests/fuzz/Parsers.h"

#include <fstream>
#include <sstream>

#include <sys/mman.h>
#include <unistd.h>

#include "core/angle/AngleText.h"
#include "core/base/FileText.h"
#include "core/earth/FieldTables.h"
#include "core/format/csv/ActionsCsv.h"
#include "core/format/csv/InflightCsv.h"
#include "core/format/csv/SensorLogCsv.h"
#include "core/format/csv/WindCsv.h"
#include "core/format/exchange/BenchJson.h"
#include "core/format/exchange/CoilJson.h"
#include "core/format/exchange/ElectricalJson.h"
#include "core/format/exchange/JobJson.h"
#include "core/format/exchange/LostJson.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/exchange/RowJson.h"
#include "core/format/exchange/SiteJson.h"
#include "core/format/reference/PairCsv.h"
#include "core/format/reference/ScenarioCsv.h"
#include "core/format/reference/ScenarioJson.h"
#include "core/format/reference/SunCsv.h"
#include "core/nmea/NmeaSwing.h"

namespace lubberline::test {

namespace {

const std::string kName = "fuzz";

/// @return whether there is a value.
template <class Value>
bool isClear(const Result<Value>& result)
{
    if (result)
        return true;
    const std::string words = result.error().message.english();
    LUBBERLINE_EXPECT(!words.empty() && words.find('\n') == std::string::npos, "an error is one line");
    LUBBERLINE_EXPECT(isUtf8(words), "an error can be shown");
    return false;
}

std::istringstream streamOf(std::string_view bytes) { return std::istringstream(std::string(bytes)); }

} // namespace

bool checkModelJson(std::string_view bytes)
{
    const bool model = isClear(readModelJson(bytes, kName));
    return isClear(readSensorModelJson(bytes, kName)) || model;
}

bool checkAirframeJson(std::string_view bytes)
{
    const auto bench = readBenchJson(bytes, kName);
    if (!isClear(bench))
        return false;
    const std::string written = writeBenchJson(*bench);
    const auto again = readBenchJson(written, kName);
    LUBBERLINE_EXPECT(again.ok() && writeBenchJson(*again) == written, "what is written can be read");
    return true;
}

bool checkElectricalJson(std::string_view bytes)
{
    const auto swing = readElectricalJson(bytes, kName);
    if (!isClear(swing))
        return false;
    const std::string written = writeElectricalJson(*swing);
    const auto again = readElectricalJson(written, kName);
    LUBBERLINE_EXPECT(again.ok() && writeElectricalJson(*again) == written, "what is written can be read");
    return true;
}

bool checkScenario(std::string_view bytes)
{
    const auto json = scenarioCsvToJson(bytes, kName);
    const bool table = isClear(json) && isClear(readScenarioJson(*json, kName));
    return isClear(readScenarioJson(bytes, kName)) || table;
}

bool checkRows(std::string_view bytes)
{
    bool any = isClear(readExtraRow(bytes));
    any = isClear(readRawRow(bytes)) || any;
    any = isClear(readStatesRow(bytes)) || any;
    any = isClear(readSurvey(bytes, kName)) || any;
    any = isClear(readJobPlan(bytes, kName)) || any;
    any = isClear(readCoilBenchJson(bytes, kName)) || any;
    any = isClear(readJobEvent(bytes, kName)) || any;
    return isClear(readLostEntry(bytes)) || any;
}

bool checkNmea(std::string_view bytes)
{
    auto stream = streamOf(bytes);
    return isClear(readNmeaSwing(stream, kName, NmeaOptions{}));
}

bool checkCoefficients(std::string_view bytes)
{
    const int file = ::memfd_create("coefficients", 0); // they are read by name
    LUBBERLINE_EXPECT(file >= 0 && ::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()), "memory is a file");
    const bool read = isClear(readFieldTable("/proc/self/fd/" + std::to_string(file)));
    ::close(file);
    return read;
}

bool checkAngle(std::string_view bytes)
{
    bool any = false;
    for (const auto& angle :
        {parseSignedAngle_deg(bytes), parsePlainAngle_deg(bytes, 180), parseLatitude_deg(bytes), parseHeading_deg(bytes)}) {
        any = isClear(angle) || any;
        LUBBERLINE_EXPECT(!angle || (*angle >= -360 && *angle <= 360), "an angle is one");
    }
    return isClear(parseWrittenHeading(bytes)) || any;
}

bool checkWindCsv(std::string_view bytes)
{
    auto stream = streamOf(bytes);
    return isClear(readWindCsv(stream, kName, WindOptions{}));
}

bool checkSensorLog(std::string_view bytes)
{
    auto stream = streamOf(bytes), header = streamOf(bytes);
    static_cast<void>(isClear(readSensorLogHeader(header, kName)));
    return isClear(readSensorLog(stream, kName));
}

bool checkInflightCsv(std::string_view bytes)
{
    auto legs = streamOf(bytes), log = streamOf(bytes), actions = streamOf(bytes);
    bool any = isClear(readLegsCsv(legs, kName));
    any = isClear(readContinuousCsv(log, kName, ContinuousOptions{})) || any;
    return isClear(readActions(actions, kName)) || any;
}

bool checkReferenceCsv(std::string_view bytes)
{
    const bool pairs = isClear(readPairCsv(bytes, kName));
    return isClear(readSunCsv(bytes, kName)) || pairs;
}

} // namespace lubberline::test
