#pragma once
/// Swing CSV: `# key: value` lines, a header of named columns in any order, one reading a row.
/// Keys, each once: aircraft, type, compass, site, operator, engines, electrics, configuration, datum, datum_serial_number,
/// datum_reader, cockpit_reader, adjuster, inspector, procedure, work_order, reason, note (text); date, datum_calibration_due
/// (YYYY-MM-DD); kind (check, correction, calibration, air, not_stated), stage (as_found, as_left, not_stated), radio (on, off, not_stated);
/// variation_deg (east positive; above the header); latitude_deg, longitude_deg and height_m (above the ellipsoid) of the
/// compass base, which with the date give the swing its field stamp (core/earth/FieldModel.h). Any other key is kept in the
/// note; a # line without a key is a comment. Columns: two of magnetic_heading_deg, compass_heading_deg, deviation_deg (east
/// positive, magnetic − compass); or true_heading_deg with `variation_deg` in place of the magnetic heading; or
/// indication_error_deg (indicated − actual, that is −deviation) in place of deviation_deg; optional pitch_deg, roll_deg,
/// nominal_deg, note, excluded (the reason). What a row says twice must agree to 0.05°. Unknown columns are kept with the
/// readings, by name and where they are not empty, and named in a warning. Headings and angles are taken in every form that the cells of
/// the window take (core/angle/AngleText.h); a comma is decimal where it stands in quotes or the cells are parted otherwise.
/// What spreadsheets write is taken: comma, semicolon or tab between cells, or what a first line "sep=;" tells; cells in double quotes,
/// which may hold separators, line breaks and "" for a quote; keys and columns in any case, key lines in quotes; empty cells and rows
/// behind the others, a last cell that is missing; no-break spaces; UTF-8 with or without BOM; CRLF, LF or CR; blank lines.
/// Headings: 0…360 (360 is 0; 000 and 360 listed with the same reading count once, and it is told). Errors name file, line, what is wrong
/// and what was expected; nothing is guessed. No cell that is written begins a formula (core/format/csv/TextCell.h).

#include <istream>
#include <string>
#include <utility>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/record/Fleet.h"

namespace lubberline {

struct SwingFile {
    Swing swing;          ///< record id derived from the content, so that a second import is told to be the same
    std::string aircraft; ///< registration, as in the file; empty if not stated (likewise below)
    std::string type;
    std::string compass;
    std::string site;
    std::string operatorName;
    std::optional<double> latitude_deg, longitude_deg, height_m; ///< of the compass base
    std::vector<std::pair<std::string, std::string>> otherKeys;  ///< keys that mean nothing to us, kept in the swing's note
    std::vector<Message> warnings;
};

/// Reads a stream with constant memory besides the readings. `name` is the file named in errors.
/// Errors: Io, Format (empty, binary, UTF-16, no header, no rows), InvalidInput (a cell), Cancelled.
Result<SwingFile> readSwingCsv(std::istream& input, const std::string& name, const Progress& progress = {});
/// Opens and reads ("-": standard input); a directory or a missing file is an Io error.
Result<SwingFile> readSwingCsvFile(const std::string& path, const Progress& progress = {});

/// The file as a record: its compass is read to the division that its figures speak of (core/swing/SwingResult.h), its site has the place
/// that the file states, or is none where it names none.
[[nodiscard]] SwingRecord recordOf(SwingFile file);

/// The file as a fleet of one swing: what `import` stores. Errors: InvalidInput when the aircraft is not named.
Result<Fleet> toFleet(const SwingFile& file);

/// Writes a swing with its particulars; readSwingCsv gives the same readings back. Readings that are not complete yet are left
/// out, and line breaks of the particulars become spaces. Deviation is derived, so it is not written.
[[nodiscard]] std::string writeSwingCsv(const SwingRecord& record);

} // namespace lubberline
