#pragma once
/// Swing CSV: `# key: value` lines, a header of named columns in any order, one reading a row.
/// Keys: aircraft, type, compass, site, date, kind, stage, operator, datum, engines, electrics, radio, variation_deg, note, …
/// Columns: two of magnetic_heading_deg, compass_heading_deg, deviation_deg (east positive, magnetic − compass); or
/// true_heading_deg with `variation_deg` in place of the magnetic heading; optional pitch_deg, roll_deg, nominal_deg, note,
/// excluded (the reason). Unknown columns are kept with the readings and named in a warning.
/// Decimal point or comma; comma, semicolon or tab between cells; UTF-8 with or without BOM; CRLF or LF.
/// Headings: 0…360 (360 is 0). Errors name file, line, what is wrong and what was expected; nothing is guessed.

#include <istream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/deviation/Smith.h"
#include "core/record/Fleet.h"

namespace lubberline {

struct SwingFile {
    Swing swing;              ///< record id derived from the content, so that a second import is told to be the same
    std::string aircraft;     ///< registration, as in the file; empty if not stated (likewise below)
    std::string type;
    std::string compass;
    std::string site;
    std::string operatorName;
    std::vector<std::pair<std::string, std::string>> otherKeys; ///< keys that mean nothing to us, kept in the swing's note
    std::vector<std::string> warnings;
};

/// A swing of more readings than this is refused: it is not a swing, and memory must not be taken for it.
inline constexpr std::size_t kMaxReadings = 1'000'000;

/// Reads a stream with constant memory besides the readings. `name` is the file named in errors.
/// Errors: Io, Format (empty, binary, UTF-16, no header, no rows), InvalidInput (a cell), Cancelled.
Result<SwingFile> readSwingCsv(std::istream& input, const std::string& name, const Progress& progress = {});
/// Opens and reads; a directory or a missing file is an Io error.
Result<SwingFile> readSwingCsvFile(const std::string& path, const Progress& progress = {});

/// What the fits take: the complete readings that are not excluded.
[[nodiscard]] std::vector<Observation> observationsOf(const Swing& swing);

/// The file as a fleet of one swing: what `import` stores. Errors: InvalidInput when the aircraft is not named.
Result<Fleet> toFleet(const SwingFile& file);

/// Writes a swing with its particulars; readSwingCsv gives the same readings back.
[[nodiscard]] std::string writeSwingCsv(const SwingRecord& record);

} // namespace lubberline
