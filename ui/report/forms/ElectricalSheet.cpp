#include "ui/report/forms/ElectricalSheet.h"

#include "core/format/exchange/ElectricalJson.h"
#include "core/procedure/ElectricalChecks.h"
#include "ui/report/forms/FormGrid.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/SheetDocument.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

QString stated(const std::string& text)
{
    const QString words = printable(text);
    return words.isEmpty() ? notStated() : words;
}

/// All digits that were written, with the minus sign of the other figures.
QString shortFigure(double value) { return QString::number(value).replace('-', QChar(0x2212)); }
QString volts(std::optional<double> value) { return value ? Words::tr("%1 V").arg(shortFigure(*value)) : notStated(); }
QString setting(std::optional<double> value) { return value ? Words::tr("%1°").arg(shortFigure(*value)) : notStated(); }

QString voltageWords(const FieldVoltage& voltage)
{
    return Words::tr("normal %1, reversed %2, mean %3").arg(volts(voltage.normal_V), volts(voltage.reversed_V), volts(voltage.mean_V()));
}

QString errorsWords(const FourPointTable& table)
{
    const auto errors = errorsOf(table);
    if (!errors)
        return printable(errors.error().message);
    return Words::tr("N–S %1°, E–W %2°, index %3°; pairs 0/180 %4°, 90/270 %5°: %6")
        .arg(signedFigure(errors->northSouth_deg, 2), signedFigure(errors->eastWest_deg, 2), signedFigure(errors->index_deg, 2),
            figure(errors->pair0_180_deg, 2), figure(errors->pair90_270_deg, 2),
            errors->pairsAgree ? Words::tr("agree within 0.2° (TM 11-4920-292-15)")
                               : Words::tr("DO NOT AGREE within 0.2° (TM 11-4920-292-15)"));
}

QString headingsWords(const ElectricalSwing& swing)
{
    const auto errors = electricalErrorsOf(swing);
    if (!errors)
        return notStated();
    return Words::tr("largest error %1° with %2° selected, mean %3°, of %n heading(s)", nullptr, errors->read)
        .arg(signedFigure(errors->largest_deg, 2), shortFigure(errors->largestAt_deg), signedFigure(errors->mean_deg, 2));
}

QString selfCheckWords(const ElectricalSwing& swing)
{
    if (swing.selfCheck.empty())
        return Words::tr("not made");
    const auto check = selfCheckOf(swing);
    if (!check)
        return printable(check.error().message);
    return Words::tr("largest %1′, mean %2′: %3")
        .arg(figure(check->largest_deg * 60, 1), figure(check->mean_deg * 60, 1),
            check->passed ? Words::tr("passed") : Words::tr("NOT PASSED"));
}

std::vector<Fact> electricalFacts(const ElectricalSheet& sheet)
{
    const ElectricalSwing& swing = sheet.swing;
    const auto open = openPoints(swing);
    QStringList points;
    for (const auto& point : open)
        points += printable(point);
    return {{Words::tr("Aircraft"), stated(sheet.aircraft.registration)},
        {Words::tr("Compass"),
            sheet.compass.name.empty()
                ? notStated()
                : joined({printable(sheet.compass.name), labelled(Words::tr("serial no."), printable(sheet.compass.serialNumber))})},
        {Words::tr("Date"), swing.date.empty() ? notStated() : Words::tr("%1 (UTC)").arg(printable(swing.date))},
        {Words::tr("North–south line"), stated(swing.line)},
        {Words::tr("Calibrator"),
            swing.calibrator.empty()
                ? notStated()
                : joined({printable(swing.calibrator), labelled(Words::tr("serial no."), printable(swing.calibratorSerial))})},
        {Words::tr("Sensor sheet"), stated(swing.sensorSheet)}, {Words::tr("E1"), voltageWords(swing.E1)},
        {Words::tr("E2"), voltageWords(swing.E2)},
        {Words::tr("Controls"),
            Words::tr("MISAL %1, δ180 %2, δ270 %3")
                .arg(setting(swing.misalignment_deg), setting(swing.delta180_deg), setting(swing.delta270_deg))},
        {Words::tr("Before"), errorsWords(swing.before)}, {Words::tr("After"), errorsWords(swing.after)},
        {Words::tr("The headings"), headingsWords(swing)}, {Words::tr("Self-check"), selfCheckWords(swing)},
        {Words::tr("Open"), points.isEmpty() ? Words::tr("nothing") : points.join(QStringLiteral("; "))},
        {Words::tr("Note"), swing.note.empty() ? dash() : printable(swing.note)}};
}

QString errorFigure(std::optional<double> indicated_deg, double selected_deg)
{
    return indicated_deg ? signedFigure(wrap180(*indicated_deg - selected_deg), 2) : dash();
}

TableColumn degreesColumn(const QString& head, const QString& argument)
{
    return {head, argument, QStringLiteral("°"), 24, TableColumn::Align::Point};
}

Table fourPoints(const ElectricalSwing& swing)
{
    Table table{Words::tr("Table F1"),
        {{Words::tr("Selected"), {}, QStringLiteral("°"), 20}, degreesColumn(Words::tr("Before"), Words::tr("indicated")),
            degreesColumn(Words::tr("Before"), Words::tr("error")), degreesColumn(Words::tr("After"), Words::tr("indicated")),
            degreesColumn(Words::tr("After"), Words::tr("error"))},
        {}};
    for (std::size_t i = 0; i < 4; ++i) {
        const double selected = 90.0 * static_cast<double>(i);
        const auto &before = swing.before.indicated_deg[i], &after = swing.after.indicated_deg[i];
        table.rows.push_back({{QStringLiteral("%1").arg(selected, 3, 'f', 0, QChar('0')), figure(before, 2), errorFigure(before, selected),
            figure(after, 2), errorFigure(after, selected)}});
    }
    return table;
}

Table allHeadings(const ElectricalSwing& swing)
{
    Table table{Words::tr("The headings"),
        {{Words::tr("Selected"), {}, QStringLiteral("°"), 20}, degreesColumn(Words::tr("Electrical"), Words::tr("indicated")),
            degreesColumn(Words::tr("Electrical"), Words::tr("error")), degreesColumn(Words::tr("Turntable"), Words::tr("indicated")),
            degreesColumn(Words::tr("Turntable"), Words::tr("error"))},
        {}};
    const std::size_t rows = std::max(swing.headings.size(), swing.selfCheck.size());
    for (std::size_t i = 0; i < rows; ++i) {
        const auto of = [i](const std::vector<SelectedHeading>& list) { return i < list.size() ? list[i] : SelectedHeading{}; };
        const SelectedHeading electrical = of(swing.headings), turntable = of(swing.selfCheck);
        const double selected = i < swing.headings.size() ? electrical.selected_deg : turntable.selected_deg;
        table.rows.push_back({{QStringLiteral("%1").arg(selected, 3, 'f', 0, QChar('0')), figure(electrical.indicated_deg, 2),
            errorFigure(electrical.indicated_deg, electrical.selected_deg), figure(turntable.indicated_deg, 2),
            errorFigure(turntable.indicated_deg, turntable.selected_deg)}});
    }
    return table;
}

std::vector<Block> electricalBlocks(const ElectricalSheet& sheet, const QString& family, double width)
{
    std::vector<Block> blocks = factBlocks(electricalFacts(sheet), {family, 8, mm(30)}, width);
    append(blocks, tableBlocks(fourPoints(sheet.swing), width, family));
    append(blocks, tableBlocks(allHeadings(sheet.swing), width, family, kDenseTableRow));
    append(blocks,
        formGrid(Words::tr("Signed by hand; performer and inspector are two people"),
            {{Words::tr("role"), 30}, {Words::tr("name, licence"), 60}, {Words::tr("signature"), 50}, {Words::tr("date (UTC)"), 30}},
            {{Words::tr("Performer"), printable(sheet.swing.by), {}, {}}, {Words::tr("Inspector"), {}, {}, {}}}, width, family, mm(9)));
    return blocks;
}

PageFrame electricalFrame(const ElectricalSheet& sheet)
{
    SwingRecord record;
    record.aircraft = sheet.aircraft;
    record.compass = sheet.compass;
    record.swing.record = sheet.swing.record;
    record.swing.date = sheet.swing.date;
    PageFrame frame = frameFor(record, Words::tr("Electrical swing: record"), sheet.madeAtUtc);
    QStringList marks;
    if (sheet.aircraft.demonstration)
        marks += Words::tr("DEMONSTRATION DATA");
    if (!openPoints(sheet.swing).empty())
        marks += Words::tr("NOT FINISHED: OPEN POINTS");
    frame.banner = joined(marks);
    frame.convention
        = Words::tr("On this sheet error = indicated − selected; deviation (magnetic − compass, easterly positive) is its negative.");
    frame.hash = hashOfText(writeElectricalJson(sheet.swing));
    return frame;
}

} // namespace

Result<void> writeElectricalSheet(const ElectricalSheet& sheet, const QString& path)
{
    return writeSheet(
        electricalFrame(sheet), [&sheet](const QString& family, QSizeF room) { return electricalBlocks(sheet, family, room.width()); },
        path);
}

} // namespace lubberline::ui
