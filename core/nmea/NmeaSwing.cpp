#include "core/nmea/NmeaSwing.h"

#include <algorithm>
#include <array>

#include "core/base/WholeFile.h"
#include "core/nmea/NmeaLines.h"
#include "core/nmea/SwingOfLog.h"

namespace lubberline {

namespace {

/// Every other byte of a Windows editor's "Unicode" is zero.
bool isUtf16(std::string_view bytes)
{
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
    const std::size_t half = bytes.size() / 2;
    return half >= 4 && std::max(zeros[0], zeros[1]) > half - half / 10 && std::min(zeros[0], zeros[1]) < half / 10;
}

Result<NmeaSwing> swingOf(const NmeaLog& log, const NmeaOptions& options)
{
    if (log.sentences > 0)
        return makeSwing(log, options);
    return Error{ErrorCode::InvalidInput,
        log.badChecksums ? MARKED("core", "holds no NMEA 0183 sentence ($ talker, type, fields): every checksum is wrong")
                         : MARKED("core", "holds no NMEA 0183 sentence ($ talker, type, fields)")};
}

} // namespace

Result<NmeaSwing> readNmeaSwing(std::istream& input, const std::string& name, const NmeaOptions& options, const Progress& progress)
{
    NmeaLog log;
    NmeaLines lines;
    const auto take = [&log](std::string_view line) { log.take(line); };
    std::vector<char> buffer(std::size_t{1} << 16);
    for (bool first = true; input; first = false) {
        if (progress && !progress(0.0))
            return Error{ErrorCode::Cancelled, MARKED("core", "reading was cancelled"), name};
        input.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        const std::string_view bytes(buffer.data(), static_cast<std::size_t>(input.gcount()));
        if (first && isUtf16(bytes))
            return Error{ErrorCode::InvalidInput,
                MARKED("core",
                    "is UTF-16 text (a Windows editor's or shell's \"Unicode\"); expected plain text: save it once more as UTF-8 or ASCII"),
                name};
        lines.feed(bytes, take);
        if (log.headings > static_cast<std::int64_t>(kMaxReadings))
            return Error{ErrorCode::InvalidInput,
                {MARKED("core", "there are more than %1 headings; expected the log of one swing"), kMaxReadings}, name};
    }
    if (input.bad())
        return Error{ErrorCode::Io, MARKED("core", "cannot be read to its end"), name};
    lines.finish(take);
    auto swing = swingOf(log, options);
    if (swing)
        return swing;
    Error error = swing.error();
    error.file = name;
    return error;
}

Result<NmeaSwing> readNmeaSwingFile(const std::string& path, const NmeaOptions& options, const Progress& progress)
{
    const auto file = openInput(path, MARKED("core", "an NMEA log"));
    return file ? readNmeaSwing(**file, nameOfInput(path), options, progress) : Result<NmeaSwing>(file.error());
}

Swing toSwing(const NmeaSwing& nmea)
{
    Swing swing;
    swing.date = nmea.date;
    swing.kind = SwingKind::Calibration;
    swing.stage = SwingStage::NotStated;
    swing.datum.instrument = "NMEA 0183 log";
    if (nmea.variation)
        swing.variation_deg = nmea.variation->degrees();
    swing.note = together(nmea.limits).english();
    std::vector<CompassHeading> compass;
    for (const auto& pair : nmea.pairs) {
        if (!pair.used)
            continue;
        Reading reading;
        reading.magnetic = pair.magnetic;
        reading.compass = pair.compass;
        reading.timeUtc = pair.timeUtc;
        reading.note = pair.timeUtc; // a Swing CSV has no other place for it
        swing.readings.push_back(std::move(reading));
        compass.push_back(pair.compass);
    }
    swing.sharedErrors = sharedErrorsOf(compass, nmea.doubts);
    return swing;
}

} // namespace lubberline
