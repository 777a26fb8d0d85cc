#include "ui/intake/YearsWork.h"

#include <QFileInfo>

#include "core/base/WholeFile.h"
#include "core/fleet/SwingCurve.h"
#include "core/format/csv/FigureCsv.h"
#include "core/record/RecordWords.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr Pattern kTable = MARKED("ui", "a table of swings (CSV)");
constexpr std::size_t kExampleRows = 3;

YearsGlance glanceOf(const YearsSwing& swing)
{
    YearsGlance glance;
    const auto& file = swing.file;
    glance.line = swing.line;
    glance.type = toText(file.type);
    glance.aircraft = toText(file.aircraft);
    glance.compass = toText(file.compass);
    glance.date = toText(file.swing.date);
    glance.stage = toText(Message(shownWord(file.swing.stage)));
    std::vector<double> magnetic, compass;
    for (const auto& reading : file.swing.readings)
        if (reading.used()) {
            magnetic.push_back(reading.magnetic->degrees());
            compass.push_back(reading.compass->degrees());
        }
    glance.readings = static_cast<int>(magnetic.size());
    const SwingCurve curve = fitCurve(magnetic, compass);
    for (std::size_t c = 0; c < glance.coefficient_deg.size(); ++c)
        if (curve.known(c))
            glance.coefficient_deg[c] = curve.value_deg[c];
    glance.maxAbs_deg = curve.maxAbs_deg;
    return glance;
}

} // namespace

Result<YearsColumnsShown> columnsShown(const QString& path)
{
    const std::string name = path.toStdString();
    auto input = openInput(name, kTable);
    if (!input)
        return input.error();
    auto header = yearsHeader(**input, name);
    if (!header)
        return header.error();
    YearsColumnsShown shown{std::move(header.value()), {}};
    shown.examples.resize(shown.header.columns.size());
    auto rows = openInput(name, kTable);
    if (!rows)
        return rows.error();
    const Progress none;
    FigureCsv csv(**rows, name, kTable, none);
    const std::vector<std::string> names = shown.header.columns;
    if (const auto begun = csv.readHeader(std::vector<std::string_view>(names.begin(), names.end())); !begun)
        return begun.error();
    for (std::size_t row = 0; row < kExampleRows; ++row) {
        const auto more = csv.next();
        if (!more || !*more)
            break; // what is wrong with a row is told with the swings
        for (std::size_t place = 0; place < shown.examples.size(); ++place)
            if (const auto cell = csv.cell(place); !cell.empty())
                shown.examples[place] += toText(std::string(cell));
    }
    return shown;
}

Result<std::vector<YearsGlance>> firstSwings(const QString& path, const YearsTable& table, int most)
{
    auto input = openInput(path.toStdString(), kTable);
    if (!input)
        return input.error();
    YearsReader reader(**input, path.toStdString(), table);
    std::vector<YearsGlance> glances;
    while (static_cast<int>(glances.size()) < most) {
        const auto swing = reader.next();
        if (!swing)
            return swing.error();
        if (!*swing)
            break;
        glances.push_back(glanceOf(**swing));
    }
    return glances;
}

Result<db::YearsOutcome> yearsWork(
    const db::Stores& stores, const QString& path, const YearsTable& table, db::YearsStep step, const Progress& progress)
{
    auto own = stores.openForWorker();
    if (!own)
        return own.error();
    auto input = openInput(path.toStdString(), kTable);
    if (!input)
        return input.error();
    YearsReader reader(**input, QFileInfo(path).fileName().toStdString(), table, progress);
    return db::importYears((*own)->database(), reader, step, (*own)->clock().today());
}

} // namespace lubberline::ui
