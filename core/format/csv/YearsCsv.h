#pragma once
/// Records of years on paper, typed into one table of many swings, in one of two forms. A row a swing: its particulars, and a column for each
/// heading ("0", "45", "045°", "H045", …) in whose cells stands what YearsTable::cells says. A row a reading: the reading's columns as in
/// the Swing CSV (core/format/csv/SwingCsv.h), with the particulars of its swing beside it in each row; rows of one swing stand together and
/// have the same particulars, or none at all below the first. Particulars are the keys of the Swing CSV, by a column of that name or of the
/// name that YearsTable::columns gives it; what all swings share may stand in `# key: value` lines above the header. `swing` tells swings of
/// one compass and day apart. Registration and date must be there. Other columns are kept: in the note of a swing, or with the readings.
/// One swing is in memory at a time; of each swing of a table of readings eight bytes stay, by which one that goes on later is found.

#include <istream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/DateText.h"
#include "core/base/Progress.h"
#include "core/format/csv/SwingCsv.h"

namespace lubberline {

enum class YearsCells { Compass, Magnetic, Deviations, IndicationErrors }; ///< of heading columns

/// How a table is to be read.
struct YearsTable {
    std::map<std::string, std::string> columns = {}; ///< key, or column of the Swing CSV → the column's name in this table
    std::map<std::string, std::string> common = {};  ///< key → what every swing has that has no cell of its own for it
    std::optional<YearsCells> cells = {};            ///< must be said where headings are columns: nothing is guessed
    bool byCompass = false;                          ///< the headings of the columns are compass headings, else magnetic ones
    DateOrder dates = DateOrder::YearMonthDay;
};

/// Keys that a column may have, in the order in which they are offered: particulars of a swing, then columns of a reading.
[[nodiscard]] std::vector<std::string> yearsKeys();

[[nodiscard]] std::optional<YearsCells> yearsCellsNamed(std::string_view word); ///< compass, magnetic, deviation, indication_error
[[nodiscard]] std::optional<DateOrder> dateOrderNamed(std::string_view word);   ///< ymd, dmy, mdy

/// The heading that a column of this name is of [deg, 0…360]; none where it is no heading.
[[nodiscard]] std::optional<double> headingOfColumn(std::string_view name);

/// What a table has, before anybody has said how it is to be read.
struct YearsHeader {
    std::vector<std::string> columns;          ///< in small letters, underscores for spaces
    std::vector<std::string> headings;         ///< those of them that are headings
    [[nodiscard]] bool looksLikeYears() const; ///< registration and date are columns: it is no file of one swing
};
/// Errors: as below.
Result<YearsHeader> yearsHeader(std::istream& input, const std::string& name);

/// A swing, as if it had been a file of its own, and the row that it begins in.
struct YearsSwing {
    SwingFile file;
    std::int64_t line = 0;
};

class YearsReader {
public:
    /// @param progress is told how much of the file is read.
    YearsReader(std::istream& input, std::string name, YearsTable table, const Progress& progress = {});
    ~YearsReader();
    YearsReader(const YearsReader&) = delete;
    YearsReader& operator=(const YearsReader&) = delete;

    /// The next swing; none at the end. Errors name file and line: Format, InvalidInput, Io, Cancelled; after one nothing more is read.
    Result<std::optional<YearsSwing>> next();
    /// What is to be told of the whole table, once it was read.
    [[nodiscard]] const std::vector<Message>& warnings() const;
    [[nodiscard]] const std::string& name() const;

private:
    class Table;
    std::unique_ptr<Table> m_table;
};

} // namespace lubberline
