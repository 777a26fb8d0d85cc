#include "ui/report/forms/WindSheet.h"

#include <cmath>

#include "core/format/results/WindsJson.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/SheetDocument.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

QString toldFigure(bool told, double value, int decimals) { return told ? signedFigure(value, decimals) : dash(); }

QString factorWords(TableFactor factor)
{
    switch (factor) {
    case TableFactor::Paper: return Words::tr("1.05 (Jacobs et al. 2014)");
    case TableFactor::Exact: return Words::tr("1.0530 (exact: straight lines between eight points hold the sine)");
    case TableFactor::None: return Words::tr("1 (none: the points lie on the curve)");
    }
    return {};
}

std::vector<Fact> windFacts(const WindSheet& sheet)
{
    const WindResult& result = sheet.result;
    std::vector<Fact> facts{
        {Words::tr("Reports"), Words::tr("%1, %2 used; %3").arg(result.observations).arg(result.used).arg(sheet.source)},
        {Words::tr("Method"),
            Words::tr(
                "e = dir(Vg − wind reported) − dir(Vg − reference wind) = offset + in phase · sin + quadrature · cos of the heading read, weighted "
                "with airspeed squared; standard errors by flights (each left out in turn); winds after: each flight corrected by what the others tell")},
        {Words::tr("Table factor"), factorWords(sheet.factor)}};
    if (const auto& common = result.common)
        facts.push_back({Words::tr("In common"),
            Words::tr("%1 aircraft: in phase %2°, quadrature %3° — as a constant error of the reference wind of %4 kt would look")
                .arg(common->aircraft)
                .arg(signedFigure(common->value_deg(1), 2), signedFigure(common->value_deg(2), 2), figure(common->asWind_kt(), 1))});
    QStringList bins, outliers;
    for (const auto& bin : result.bins)
        bins += std::isfinite(bin.to_deg) ? Words::tr("%1–%2°: %3").arg(bin.from_deg).arg(bin.to_deg).arg(bin.aircraft)
                                          : Words::tr("above %1°: %2").arg(bin.from_deg).arg(bin.aircraft);
    for (const std::size_t row : result.outliers)
        outliers += printable(result.aircraft[row].aircraft);
    facts.push_back({Words::tr("By size of error"), bins.join(QStringLiteral("; "))});
    facts.push_back({Words::tr("Out of line"), outliers.isEmpty() ? Words::tr("none") : outliers.join(QStringLiteral(", "))});
    if (result.sourcesApart_kt)
        facts.push_back(
            {Words::tr("References"), Words::tr("two of one report are %1 kt apart (rms)").arg(figure(*result.sourcesApart_kt, 1))});
    for (const auto& warning : result.warnings)
        facts.push_back({Words::tr("Note"), printable(warning)});
    return facts;
}

Table windTable(const WindResult& result)
{
    const QString degrees = QStringLiteral("°"), knots = QStringLiteral("kt");
    Table table{Words::tr("Indication error (read − true) of each aircraft"),
        {{Words::tr("Aircraft"), {}, {}, 26, TableColumn::Align::Left}, {Words::tr("Flights"), {}, {}, 14}, {Words::tr("Used"), {}, {}, 16},
            {Words::tr("In phase"), {}, degrees, 18}, {Words::tr("Quadr."), {}, degrees, 18}, {Words::tr("Offset"), {}, degrees, 18},
            {Words::tr("±"), Words::tr("1 se"), degrees, 14}, {Words::tr("Across"), Words::tr("before"), knots, 16},
            {Words::tr("Across"), Words::tr("after"), knots, 16}, {Words::tr("Along"), Words::tr("before"), knots, 16}},
        {}};
    for (const auto& one : result.aircraft) {
        const ClusteredFit& fit = one.fit.fit;
        table.rows.push_back(
            {{printable(one.aircraft), QString::number(one.flights), QString::number(one.used), toldFigure(fit.told[1], fit.value(1), 2),
                 toldFigure(fit.told[2], fit.value(2), 2), toldFigure(fit.told[0], fit.value(0), 2),
                 fit.told[1] && fit.errorsTold ? figure(fit.standardError(1), 2) : dash(), figure(one.before.transverse_kt, 1),
                 one.after ? figure(one.after->transverse_kt, 1) : dash(), figure(one.before.longitudinal_kt, 1)},
                one.changes.empty() ? TableRow::Look::Plain : TableRow::Look::Marked});
    }
    return table;
}

Table groupTable(const WindResult& result)
{
    const QString knots = QStringLiteral("kt");
    Table table{Words::tr("Error of reported winds by source of heading"),
        {{Words::tr("Group"), {}, {}, 46, TableColumn::Align::Left}, {Words::tr("Aircraft"), {}, {}, 16},
            {Words::tr("Total"), Words::tr("before"), knots, 20}, {Words::tr("Along"), Words::tr("before"), knots, 20},
            {Words::tr("Across"), Words::tr("before"), knots, 20}, {Words::tr("Total"), Words::tr("after"), knots, 20},
            {Words::tr("Across"), Words::tr("after"), knots, 20}},
        {}};
    const auto add = [&table](const QString& name, const WindGroup& group) {
        const WindRmse before = group.before.rmse(), after = group.after.rmse();
        const bool told = group.after.count > 0;
        table.rows.push_back({{name, QString::number(group.aircraft), figure(before.total_kt, 1), figure(before.longitudinal_kt, 1),
            figure(before.transverse_kt, 1), told ? figure(after.total_kt, 1) : dash(), told ? figure(after.transverse_kt, 1) : dash()}});
    };
    for (const auto& group : result.groups)
        add(printable(group.group), group);
    if (result.control)
        add(Words::tr("held against: %1").arg(printable(result.control->group)), *result.control);
    return table;
}

Table altitudeTable(const WindResult& result)
{
    const QString knots = QStringLiteral("kt");
    Table table{Words::tr("Error of reported winds by altitude, before and after the correction"),
        {{Words::tr("From"), {}, QStringLiteral("m"), 20}, {Words::tr("To"), {}, QStringLiteral("m"), 20},
            {Words::tr("Reports"), {}, {}, 20}, {Words::tr("Total"), {}, knots, 20}, {Words::tr("Along"), {}, knots, 20},
            {Words::tr("Across"), {}, knots, 20}, {Words::tr("Total"), Words::tr("after"), knots, 20},
            {Words::tr("Along"), Words::tr("after"), knots, 20}, {Words::tr("Across"), Words::tr("after"), knots, 20}},
        {}};
    for (const auto& band : result.altitudes) {
        const WindRmse rmse = band.before.rmse(), after = band.after.rmse();
        const auto corrected = [&](double figure_kt) { return band.after.count > 0 ? figure(figure_kt, 1) : dash(); };
        table.rows.push_back({{figure(band.from_m, 0), figure(band.to_m, 0), QString::number(band.before.count), figure(rmse.total_kt, 1),
            figure(rmse.longitudinal_kt, 1), figure(rmse.transverse_kt, 1), corrected(after.total_kt), corrected(after.longitudinal_kt),
            corrected(after.transverse_kt)}});
    }
    return table;
}

Table sourceTable(const WindResult& result)
{
    Table table{Words::tr("Reported winds against each reference"),
        {{Words::tr("Source"), {}, {}, 46, TableColumn::Align::Left}, {Words::tr("Reports"), {}, {}, 24},
            {Words::tr("Offset"), {}, QStringLiteral("°"), 24}, {Words::tr("Across"), {}, QStringLiteral("kt"), 24}},
        {}};
    for (const auto& source : result.sources)
        table.rows.push_back({{printable(source.source), QString::number(source.observations), signedFigure(source.meanError_deg, 2),
            figure(source.transverse_kt, 1)}});
    return table;
}

Table uploadTable(const WindSheet& sheet)
{
    Table table{Words::tr("Corrections to upload (deviation's sign, easterly positive)"),
        {{Words::tr("Aircraft"), {}, {}, 26, TableColumn::Align::Left}}, {}};
    for (int heading = 0; heading < 360; heading += 45)
        table.columns.push_back({QStringLiteral("%1").arg(heading, 3, 10, QChar('0')), {}, QStringLiteral("°"), 18});
    for (const auto& one : sheet.result.aircraft) {
        const ClusteredFit& fit = one.fit.fit;
        if (!one.fitted || !fit.told[0] || !fit.told[1] || !fit.told[2])
            continue;
        QStringList cells{printable(one.aircraft)};
        for (const double correction_deg : one.table_deg(sheet.factor))
            cells += signedFigure(correction_deg, 2);
        table.rows.push_back({cells});
    }
    return table;
}

std::vector<Fact> remarks(const WindResult& result)
{
    std::vector<Fact> facts;
    for (const auto& one : result.aircraft)
        for (const auto& warning : one.warnings)
            facts.push_back({printable(one.aircraft), printable(warning)});
    return facts;
}

} // namespace

Result<void> writeWindSheet(const WindSheet& sheet, const QString& path, const Progress& progress)
{
    PageFrame frame;
    frame.title = Words::tr("Deviation from winds");
    frame.subject = sheet.source;
    frame.convention = Words::tr(
        "Indication error = read − true heading; corrections and deviation (magnetic − compass, easterly positive) are its negative.");
    frame.hash = hashOfText(toJson(sheet.result, sheet.factor));
    frame.made = madeWords(sheet.madeAtUtc);
    return writeSheet(
        frame,
        [&sheet](const QString& family, QSizeF room) {
            std::vector<Block> blocks = factBlocks(windFacts(sheet), {family, 8, mm(34)}, room.width());
            append(blocks, tableBlocks(windTable(sheet.result), room.width(), family, kDenseTableRow));
            append(blocks, tableBlocks(uploadTable(sheet), room.width(), family, kDenseTableRow));
            for (const Table& table : {groupTable(sheet.result), altitudeTable(sheet.result), sourceTable(sheet.result)})
                if (!table.rows.empty())
                    append(blocks, tableBlocks(table, room.width(), family, kDenseTableRow));
            blocks.push_back(titleBlock(Words::tr("What has to be said of each"), family));
            append(blocks, factBlocks(remarks(sheet.result), {family, 7.5, mm(34)}, room.width()));
            return blocks;
        },
        path, progress);
}

} // namespace lubberline::ui
