#include "ui/report/forms/JobCard.h"

#include <QPainter>

#include <cmath>

#include "core/procedure/Plan.h"
#include "ui/report/forms/FormGrid.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/QrCode.h"
#include "ui/report/page/SheetDocument.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

namespace {

constexpr double kQr = mm(30);

QString phaseWord(const Station& station, const SwingJob& job)
{
    switch (station.phase) {
    case StationPhase::AsFound: return Words::tr("as found");
    case StationPhase::Correct: return Words::tr("correct");
    case StationPhase::Check: return Words::tr("check");
    case StationPhase::Configuration: break;
    }
    return printable(job.plan.configurations[static_cast<std::size_t>(station.configuration - 1)]);
}

/// To take a term T of d = magnetic − compass out on a heading, the compass is made to read C + T(heading).
QString formula(const Turn& turn, double nominal_deg)
{
    if (turn.removal == HowMuch::All)
        return Words::tr("take out all: make compass read = compass + d");
    if (turn.removal == HowMuch::Half)
        return Words::tr("take out half: make compass read = compass + d/2");
    const double heading_rad = toRadians(nominal_deg);
    if (turn.control == Control::Index)
        return Words::tr("A = (dN + dE + dS + dW)/4 = ____ ; make compass read = compass + A = ____");
    const bool north = turn.control == Control::NorthSouth;
    const bool plus = (north ? std::cos(heading_rad) : std::sin(heading_rad)) > 0;
    return (north ? Words::tr("C = (dN − dS)/2 = ____ ; N–S screw: make compass read = compass %1 C = ____")
                  : Words::tr("B = (dE − dW)/2 = ____ ; E–W screw: make compass read = compass %1 B = ____"))
        .arg(plus ? QStringLiteral("+") : QStringLiteral("−"));
}

std::vector<Fact> factsFor(const JobCardInput& input)
{
    std::vector<Fact> facts = factsOf(input.record);
    std::erase_if(facts, [](const Fact& fact) { return fact.value == notStated(); }); // to be filled by hand, further below
    facts.push_back({Words::tr("Signs"),
        Words::tr("d = magnetic − compass, easterly positive. Datum: %1")
            .arg(input.job.datum.name.empty() ? QStringLiteral("____") : printable(input.job.datum.name))});
    return facts;
}

/// What nobody has stated yet, with room to write; people have a table of their own.
std::vector<QStringList> linesToFill(const JobCardInput& input)
{
    std::vector<QStringList> rows;
    for (const auto& fact : factsOf(input.record))
        if (fact.value == notStated() && fact.name != Words::tr("People"))
            rows.push_back({fact.name, {}});
    return rows;
}

Block qrBlock(const QrMatrix& matrix, const JobCardInput& input, const QString& family, double width)
{
    const std::vector<Block> facts = factBlocks(factsFor(input), {family, 8, mm(26)}, width - kQr - mm(4));
    double height = 0;
    for (const auto& fact : facts)
        height += fact.height;
    return {std::max(height, kQr + mm(5)), [=](QPainter& painter, const QRectF& rect) {
                double top = rect.top();
                for (const auto& fact : facts) {
                    fact.paint(painter, QRectF(rect.left(), top, width - kQr - mm(4), fact.height));
                    top += fact.height;
                }
                paintQr(painter, QRectF(rect.right() - kQr, rect.top(), kQr, kQr), matrix);
            }};
}

std::vector<QStringList> stationRows(const JobCardInput& input)
{
    std::vector<QStringList> rows;
    const auto plan = planOf(input.job.plan);
    const QStringList formulas = stationFormulas(input.job);
    for (std::size_t i = 0; i < plan.size(); ++i)
        rows.push_back({QString::number(i + 1), phaseWord(plan[i], input.job),
            QStringLiteral("%1").arg(plan[i].nominal_deg, 3, 'f', 0, QChar('0')), {}, {}, {}, {}, {}, {}, {},
            formulas[static_cast<qsizetype>(i)].isEmpty()
                ? QString()
                : Words::tr("%1 ; it read after: ____").arg(formulas[static_cast<qsizetype>(i)])});
    return rows;
}

/// Checklists that were made before say two things that do not belong there: a compensator that is zeroed before it was read as found,
/// and a variation setter that a compass in liquid has not.
bool belongsBefore(const std::string& item, const CompassSystem& compass)
{
    const bool zero = item.starts_with("compensator at zero");
    const bool setter = item.starts_with("variation setter") && compass.kind == CompassKind::DirectReading;
    return !zero && !setter;
}

/// Zeroing loses what was found: it is read first, and what is read afterwards is not as found.
std::vector<Block> zeroGrid(double width, const QString& family)
{
    std::vector<QStringList> rows;
    for (const char* heading : {"000", "090", "180", "270"})
        rows.push_back({Words::tr("read as found"), QString::fromLatin1(heading), {}, {}, {}});
    rows.push_back(
        {Words::tr("then zero the compensator: dots on the screws in line with those on the case; from here on nothing is as found"), {},
            {}, {}, Words::tr("done ____")});
    return formGrid(Words::tr("Only where the compensator is to be zeroed: after the readings as found"),
        {{Words::tr("what"), 84}, {Words::tr("to °"), 14}, {Words::tr("datum °"), 26}, {Words::tr("compass °"), 26},
            {Words::tr("d °"), 26}},
        rows, width, family, mm(6));
}

std::vector<Block> jobCardBlocks(const JobCardInput& input, const QrMatrix& matrix, const QString& family, double width)
{
    std::vector<Block> blocks{qrBlock(matrix, input, family, width)};
    if (const auto open = linesToFill(input); !open.empty())
        append(blocks, formGrid(Words::tr("To be filled in"), {{Words::tr("what"), 30}, {{}, 150}}, open, width, family, mm(7)));
    std::vector<QStringList> checklist;
    for (const auto& item : input.job.checklist)
        if (belongsBefore(item, input.record.compass))
            checklist.push_back({printable(item), {}});
    if (!checklist.empty())
        append(blocks,
            formGrid(Words::tr("Before the first reading"), {{Words::tr("check"), 150}, {Words::tr("done"), 20}}, checklist, width, family,
                mm(6)));
    if (input.record.compass.compensator != Compensator::None && input.job.plan.kind != ProcedureKind::CheckOnly)
        append(blocks, zeroGrid(width, family));
    std::vector<QStringList> interference;
    for (const char* heading : {"000", "090", "180", "270"})
        interference.push_back({QString::fromLatin1(heading), {}, {}, {}, {}});
    append(blocks,
        formGrid(Words::tr("Interference: compass with engines and electrics off and on"),
            {{Words::tr("heading °"), 18}, {Words::tr("load"), 60}, {Words::tr("off °"), 25}, {Words::tr("on °"), 25},
                {Words::tr("change °"), 25}},
            interference, width, family, mm(6)));
    append(blocks,
        formGrid(Words::tr("Stations"),
            {{Words::tr("no."), 8}, {Words::tr("phase"), 17}, {Words::tr("to °"), 11}, {Words::tr("datum 1"), 15}, {Words::tr("2"), 15},
                {Words::tr("3"), 15}, {Words::tr("comp. 1"), 15}, {Words::tr("2"), 15}, {Words::tr("3"), 15}, {Words::tr("d °"), 13},
                {Words::tr("do here, and what it read after"), 64}},
            stationRows(input), width, family, mm(9)));
    if (indexAfterCheck(input.job.plan.kind))
        append(blocks,
            formGrid(Words::tr("After the check swing"), {{Words::tr("index"), 160}},
                {{Words::tr(
                    "A = (dN + dE + dS + dW)/4 of the check swing = ____ ; turn the compass in its mount until it reads compass + A = ____ ; it read ____")}},
                width, family, mm(9)));
    append(blocks,
        formGrid(Words::tr("People"),
            {{Words::tr("datum read by"), 36}, {Words::tr("compass read by"), 36}, {Words::tr("adjusted by (performer)"), 38},
                {Words::tr("date and times (UTC)"), 60}},
            {{{}, {}, {}, {}}}, width, family, mm(10)));
    append(blocks,
        formGrid(Words::tr("Inspector: another person than who adjusted"),
            {{Words::tr("inspected by"), 50}, {Words::tr("licence, stamp"), 40}, {Words::tr("signature"), 50},
                {Words::tr("date (UTC)"), 30}},
            {{{}, {}, {}, {}}}, width, family, mm(10)));
    return blocks;
}

PageFrame jobCardFrame(const JobCardInput& input) { return frameFor(input.record, Words::tr("Compass swing: job card"), input.madeAtUtc); }

QString codeOf(const JobCardInput& input) { return printable(input.record.swing.record); }

} // namespace

QStringList stationFormulas(const SwingJob& job)
{
    QStringList formulas;
    for (const auto& station : planOf(job.plan)) {
        QStringList here;
        for (const auto& turn : station.corrections)
            here += formula(turn, station.nominal_deg);
        formulas += here.join(QStringLiteral("; "));
    }
    return formulas;
}

Result<void> writeJobCard(const JobCardInput& input, const QString& path)
{
    const auto matrix = qrOf(codeOf(input));
    if (!matrix)
        return matrix.error();
    return writeSheet(
        jobCardFrame(input), [&](const QString& family, QSizeF room) { return jobCardBlocks(input, *matrix, family, room.width()); }, path);
}

Result<void> printJobCard(const JobCardInput& input, QPagedPaintDevice& device)
{
    const auto matrix = qrOf(codeOf(input));
    if (!matrix)
        return matrix.error();
    return printSheet(
        jobCardFrame(input), [&](const QString& family, QSizeF room) { return jobCardBlocks(input, *matrix, family, room.width()); },
        device);
}

} // namespace lubberline::ui
