#include "ui/report/fleet/FleetTables.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/angle/PrintedHeading.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

using Align = TableColumn::Align;

QString letterAt(std::size_t c) { return QString(QLatin1Char(letterOf(kCoefficients[c]))); }
QString dayText(int day) { return QString::fromStdString(dateOfDay(day)); }
QString heading(double heading_deg) { return QStringLiteral("%1").arg(printedHeading_deg(heading_deg, 1), 5, 'f', 1, QChar('0')); }
QString percent(double share, int decimals = 1) { return figure(100 * share, decimals); }

QString headings(const std::vector<double>& all_deg)
{
    QStringList words;
    for (const double each : all_deg)
        words += QStringLiteral("%1°").arg(each, 3, 'f', each == std::round(each) ? 0 : 1, QChar('0'));
    return words.isEmpty() ? Words::tr("none") : words.join(QStringLiteral(", "));
}

TableColumn words(const QString& head, double width_mm) { return {head, {}, {}, width_mm, Align::Left}; }
TableColumn angle(const QString& head, const QString& argument = {}) { return {head, argument, QStringLiteral("°"), 20, Align::Point}; }
TableColumn plain(const QString& head, const QString& argument = {}, double width_mm = 16)
{
    return {head, argument, {}, width_mm, Align::Point};
}

const FleetCompass& compassAt(const FleetSwings& fleet, std::int32_t compass) { return fleet.compasses[static_cast<std::size_t>(compass)]; }

QString probabilityText(double probability) { return probability < 0.001 ? QStringLiteral("<0.1") : percent(probability); }

/// What the core says in small letters, as a sentence of a list.
QString sentence(const Message& message)
{
    QString text = printable(message);
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text + QChar('.');
}

QString pText(double p) { return p < 1e-4 ? QStringLiteral("%1").arg(p, 0, 'e', 0) : figure(p, 4); }

} // namespace

QString wordsFor(const FleetSelection& selection, const FleetOptions& options)
{
    QStringList parts{printable(selection.type), printable(selection.aircraft), printable(selection.compass)};
    parts += labelled(Words::tr("swung at"), printable(selection.site));
    parts += labelled(Words::tr("based at"), printable(selection.base));
    parts += labelled(Words::tr("from"), printable(selection.from));
    parts += labelled(Words::tr("to"), printable(selection.to));
    if (selection.radio)
        parts += labelled(Words::tr("radio"), wordFor(*selection.radio));
    if (options.stage)
        parts += wordFor(*options.stage);
    const QString all = joined(parts);
    return all.isEmpty() ? Words::tr("all swings") : all;
}

QStringList fleetSummary(const FleetReport& report, const FleetSwings& fleet)
{
    QStringList lines{Words::tr("%1 swings of %2 aircraft are used, of %3 in the selection.")
                          .arg(report.counts.used)
                          .arg(report.counts.aircraft)
                          .arg(report.counts.swings)};
    const auto& pattern = report.pattern;
    lines += Words::tr("The mean deviation is highest at %1 and lowest at %2.")
                 .arg(headings(pattern.maxima_deg), headings(pattern.minima_deg));
    if (pattern.largestSpread_deg)
        lines += Words::tr("Aircraft differ most at %1.").arg(headings({*pattern.largestSpread_deg}));
    const auto& e = report.exceedance;
    if (e.pairs > 0)
        lines += Words::tr(
            "Of %1 pairs of swings (as left, next as found) %2 were beyond the limit when found: %3 % (%4 to %5 % at 95 % confidence).")
                     .arg(e.pairs)
                     .arg(e.exceeded)
                     .arg(percent(static_cast<double>(e.exceeded) / static_cast<double>(e.pairs)), percent(e.share95->low),
                         percent(e.share95->high));
    if (report.plants.training)
        for (const auto& each : inWords(*report.plants.training))
            lines += sentence(each);
    lines += report.changes.jumps.empty()
        ? Words::tr("No jump is told at a false discovery rate of 10 %.")
        : Words::tr("%n jump(s) told at a false discovery rate of 10 %.", nullptr, static_cast<int>(report.changes.jumps.size()));
    if (!report.ranking.compasses.empty()) {
        const auto& first = report.ranking.compasses.front();
        const auto& compass = compassAt(fleet, first.compass);
        lines += Words::tr("Swing next: %1 · %2, %3 % to be out of limits by %4 (%5).")
                     .arg(printable(compass.aircraft), printable(compass.compass), probabilityText(first.probability),
                         dayText(first.by_day), printable(inWords(first)));
    }
    for (const auto& warning : report.warnings)
        lines += sentence(warning);
    return lines;
}

QStringList fleetMethods(const FleetReport& report)
{
    QStringList lines{report.options.vote == FleetVote::Aircraft
            ? Words::tr("One aircraft has one vote: the mean of its swings.")
            : Words::tr("Each swing has one vote; aircraft with many swings weigh more."),
        Words::tr(
            "A reading enters a heading of the grid moved along its own swing's curve, its residual kept; a swing without a reading within half a step enters by its curve."),
        Words::tr("Spread as found: standard deviation of what was read. Between aircraft: the same with the fits' own error taken out."),
        Words::tr(
            "Exceedance is told from pairs: a compass as left, and the same compass as found next. The interval is exact (Clopper and Pearson)."),
        Words::tr(
            "Expected share: chance that the largest deviation over all headings of the next swing is beyond the limit, by Student's prediction from those that were found."),
        Words::tr(
            "Three-sigma share: mean and standard deviation of the worst single heading taken as if they were known, as in the source paper; too small for few swings and for many headings."),
        Words::tr("Variance components by restricted maximum likelihood; intervals by profile of the likelihood at 95 %."),
        Words::tr("A jump's date is the interval between two swings. One in ten of the jumps that are told may be false."),
        Words::tr(
            "Who next: chance of being out of limits at some time up to the date, by level, drift and wander of each coefficient since the last swing, shrunk to its type.")};
    return lines;
}

Table patternTable(const FleetReport& report)
{
    Table table{Words::tr("Pattern of the population by magnetic heading"),
        {{Words::tr("heading"), {}, QStringLiteral("°"), 16, Align::Point},
            plain(report.options.vote == FleetVote::Aircraft ? Words::tr("aircraft") : Words::tr("swings")), angle(Words::tr("mean")),
            angle(Words::tr("sd"), Words::tr("as found")), angle(Words::tr("sd"), Words::tr("between aircraft")), angle(Words::tr("5 %")),
            angle(Words::tr("50 %")), angle(Words::tr("95 %"))},
        {}};
    const auto marked = [&](double at) {
        const auto in = [at](const std::vector<double>& all) { return std::find(all.begin(), all.end(), at) != all.end(); };
        return in(report.pattern.maxima_deg) || in(report.pattern.minima_deg);
    };
    for (const auto& p : report.pattern.points)
        table.rows.push_back({{heading(p.heading_deg), QString::number(p.units), signedFigure(p.mean_deg, 2),
                                  figure(p.standardDeviation_deg, 2), figure(p.between_deg, 2), signedFigure(p.percentile5_deg, 2),
                                  signedFigure(p.percentile50_deg, 2), signedFigure(p.percentile95_deg, 2)},
            marked(p.heading_deg) ? TableRow::Look::Marked : TableRow::Look::Plain});
    return table;
}

Table fleetCoefficientTable(const FleetReport& report, const FleetSwings& fleet)
{
    Table table{Words::tr("Coefficients of the population"),
        {words(Words::tr("coefficient"), 18), plain(Words::tr("votes")), angle(Words::tr("mean")), angle(Words::tr("standard error")),
            angle(Words::tr("sd"), Words::tr("as found")), angle(Words::tr("sd"), Words::tr("between aircraft")),
            words(Words::tr("far from the others"), 60)},
        {}};
    for (std::size_t c = 0; c < kCoefficientCount; ++c) {
        const auto& s = report.pattern.coefficients[c];
        QStringList outliers;
        for (std::size_t i = 0; i < s.outliers.size() && i < 3; ++i)
            outliers += QStringLiteral("%1 %2°").arg(
                printable(compassAt(fleet, fleet.swings[s.outliers[i].row].compass).aircraft), signedFigure(s.outliers[i].value_deg, 1));
        if (s.outliers.size() > 3)
            outliers += Words::tr("and %n more", nullptr, static_cast<int>(s.outliers.size() - 3));
        table.rows.push_back({{letterAt(c), QString::number(s.units), signedFigure(s.mean_deg, 2), figure(s.standardError_deg, 3),
            figure(s.standardDeviation_deg, 2), figure(s.between_deg, 2), outliers.join(QStringLiteral(", "))}});
    }
    return table;
}

Table softIronTable(const FleetReport& report)
{
    Table table{Words::tr("Standard soft-iron correction of a type: D and E, alike in all its aircraft"),
        {words(Words::tr("type"), 30), words(Words::tr("compass"), 40), words(Words::tr("of"), 10), plain(Words::tr("aircraft")),
            angle(Words::tr("mean")), angle(Words::tr("standard error")), angle(Words::tr("sd"), Words::tr("between aircraft")),
            {Words::tr("next aircraft"), Words::tr("95 %"), QStringLiteral("°"), 36, Align::Left}},
        {}};
    for (const auto& standard : report.softIron)
        for (const auto& [letter, one] : {std::pair('D', &standard.D), std::pair('E', &standard.E)})
            if (*one)
                table.rows.push_back({{QString::fromStdString(standard.type), QString::fromStdString(standard.compass),
                    QString(QLatin1Char(letter)), QString::number((*one)->aircraft), signedFigure((*one)->mean_deg, 2),
                    figure((*one)->standardError_deg, 3), figure((*one)->between_deg, 2),
                    QStringLiteral("%1 – %2").arg(signedFigure((*one)->next95_deg.low, 2), signedFigure((*one)->next95_deg.high, 2))}});
    return table;
}

Table fleetHarmonicTable(const FleetReport& report)
{
    Table table{Words::tr("Harmonics of the mean and of the standard deviation"),
        {words(Words::tr("of"), 34), plain(Words::tr("order")), angle(Words::tr("sin")), angle(Words::tr("cos")),
            angle(Words::tr("amplitude")), angle(Words::tr("phase")), words({}, 20)},
        {}};
    for (const auto& [name, orders] :
        {std::pair(Words::tr("mean"), &report.pattern.mean), std::pair(Words::tr("standard deviation"), &report.pattern.spread),
            std::pair(Words::tr("mean, as found"), &report.found), std::pair(Words::tr("mean, as left"), &report.left)}) {
        double highest = 0, lowest = std::numeric_limits<double>::infinity();
        for (const auto& o : *orders)
            if (o.order > 0) {
                highest = std::max(highest, o.amplitude_rad());
                lowest = std::min(lowest, o.amplitude_rad());
            }
        const auto place = [&](const HarmonicOrder& o) {
            if (o.order == 0 || highest == lowest)
                return QString();
            return o.amplitude_rad() == highest ? Words::tr("highest") : o.amplitude_rad() == lowest ? Words::tr("lowest") : QString();
        };
        for (const auto& o : *orders)
            table.rows.push_back(
                {{name, QString::number(o.order), signedFigure(toDegrees(o.sin_rad), 3), signedFigure(toDegrees(o.cos_rad), 3),
                     figure(toDegrees(o.amplitude_rad()), 3), signedFigure(toDegrees(o.phase_rad()), 1), place(o)},
                    place(o).isEmpty() ? TableRow::Look::Plain : TableRow::Look::Marked});
    }
    return table;
}

Table exceedanceTable(const FleetReport& report)
{
    Table table{Words::tr("Beyond the limit at the next inspection, from pairs"),
        {words(Words::tr("of"), 20), words(Words::tr("name"), 40), plain(Words::tr("pairs")), plain(Words::tr("beyond")),
            {Words::tr("observed"), {}, QStringLiteral("%"), 16, Align::Point},
            {Words::tr("95 % interval"), {}, QStringLiteral("%"), 26, Align::Left},
            {Words::tr("expected"), Words::tr("Student"), QStringLiteral("%"), 18, Align::Point},
            {Words::tr("three sigma"), Words::tr("the paper's"), QStringLiteral("%"), 18, Align::Point}},
        {}};
    const auto& e = report.exceedance;
    const auto row = [&](const QString& of, const QString& name, std::int64_t pairs, std::int64_t beyond, const Interval& interval) {
        table.rows.push_back(
            {{of, name, QString::number(pairs), QString::number(beyond), percent(static_cast<double>(beyond) / static_cast<double>(pairs)),
                QStringLiteral("%1 – %2").arg(percent(interval.low), percent(interval.high)), {}, {}}});
    };
    if (e.pairs == 0)
        return table;
    row(Words::tr("all"), e.limit_deg ? Words::tr("limit %1°").arg(figure(e.limit_deg, 1)) : Words::tr("each its own limit"), e.pairs,
        e.exceeded, *e.share95);
    if (e.expectedShare)
        table.rows.back().cells[6] = percent(*e.expectedShare);
    if (e.threeSigmaShare)
        table.rows.back().cells[7] = percent(*e.threeSigmaShare);
    for (const auto& [name, groups] :
        {std::pair(Words::tr("type"), &e.byType), std::pair(Words::tr("base"), &e.bySite), std::pair(Words::tr("crew"), &e.byCrew)})
        if (groups->size() > 1)
            for (const auto& group : *groups)
                row(name, QString::fromStdString(group.name), group.pairs, group.exceeded, group.share95);
    for (const auto& h : e.headings)
        table.rows.push_back({{Words::tr("heading"), heading(h.heading_deg) + QStringLiteral("°"), {}, {}, {}, {}, percent(h.expectedShare),
            percent(h.threeSigmaShare)}});
    return table;
}

Table varianceTable(const FleetReport& report)
{
    Table table{Words::tr("Where it comes from: standard deviations by component, with 95 % intervals"),
        {words(Words::tr("coefficient"), 20), {Words::tr("aircraft"), {}, QStringLiteral("°"), 40, Align::Left},
            {Words::tr("crew"), {}, QStringLiteral("°"), 40, Align::Left}, {Words::tr("base"), {}, QStringLiteral("°"), 40, Align::Left},
            {Words::tr("swing to swing"), {}, QStringLiteral("°"), 40, Align::Left}},
        {}};
    const auto cell = [](const std::optional<VarianceComponent>& component) {
        if (!component)
            return Words::tr("not told");
        const QString high = std::isfinite(component->interval.high) ? figure(std::sqrt(component->interval.high), 2) : QStringLiteral("∞");
        return QStringLiteral("%1 (%2 – %3)")
            .arg(figure(std::sqrt(component->variance), 2), figure(std::sqrt(component->interval.low), 2), high);
    };
    for (std::size_t c = 0; c < kCoefficientCount; ++c)
        if (const auto& v = report.variance[c].report)
            table.rows.push_back({{letterAt(c), cell(v->aircraft), cell(v->crew), cell(v->site), cell(v->residual)}});
    return table;
}

Table plantTable(const FleetReport& report)
{
    Table table{Words::tr("A as human error, by base and crew"),
        {words(Words::tr("of"), 16), words(Words::tr("name"), 50), plain(Words::tr("swings")), angle(Words::tr("mean A")),
            angle(Words::tr("mean |A|")), {Words::tr("95 % interval"), {}, QStringLiteral("°"), 30, Align::Left}},
        {}};
    for (const auto& [name, groups] :
        {std::pair(Words::tr("base"), &report.plants.bySite), std::pair(Words::tr("crew"), &report.plants.byCrew)})
        for (const auto& g : *groups)
            table.rows.push_back(
                {{name, QString::fromStdString(g.name), QString::number(g.swings), signedFigure(g.meanA_deg, 2), figure(g.meanAbsA_deg, 2),
                    QStringLiteral("%1 – %2").arg(figure(g.meanAbsA95_deg.low, 2), figure(g.meanAbsA95_deg.high, 2))}});
    return table;
}

Table alarmTable(const FleetReport& report)
{
    Table table{Words::tr("Alarms of the control charts of A"),
        {words(Words::tr("from"), 27), words(Words::tr("to"), 27), words(Words::tr("of"), 16), words(Words::tr("name"), 40),
            words(Words::tr("chart"), 30), words(Words::tr("A lies"), 30), angle(Words::tr("average"), Words::tr("farthest"))},
        {}};
    if (!report.plants.charts)
        return table;
    for (const auto& alarm : report.plants.charts->alarms)
        table.rows.push_back({{dayText(alarm.day), dayText(alarm.last_day), alarm.crew ? Words::tr("crew") : Words::tr("base"),
            QString::fromStdString(alarm.name),
            joined({alarm.ewma ? QStringLiteral("EWMA") : QString(), alarm.cusum ? QStringLiteral("CUSUM") : QString()}),
            alarm.high ? Words::tr("east of the usual") : Words::tr("west of the usual"), signedFigure(alarm.level_deg, 2)}});
    return table;
}

Table jumpTable(const FleetReport& report, const FleetSwings& fleet)
{
    Table table{Words::tr("Jumps, at a false discovery rate of 10 %"),
        {words(Words::tr("aircraft"), 24), words(Words::tr("compass"), 32), words(Words::tr("between"), 46), words(Words::tr("of"), 8),
            angle(Words::tr("by")), angle(Words::tr("±"), Words::tr("1 se")), plain(Words::tr("p")),
            words(Words::tr("event, likely part"), 70)},
        {}};
    for (const auto& j : report.changes.jumps) {
        const auto& compass = compassAt(fleet, j.compass);
        const QString part = printable(inWords(likelyPart(jumpedTogether(report.changes, j), compass.kind)));
        table.rows.push_back({{QString::fromStdString(compass.aircraft), QString::fromStdString(compass.compass),
            QStringLiteral("%1 – %2").arg(dayText(fleet.swings[j.afterRow].day), dayText(fleet.swings[j.beforeRow].day)),
            letterAt(j.coefficient), signedFigure(j.change_deg, 2), figure(j.standardError_deg, 2), pText(j.p),
            joined({QString::fromStdString(j.event), part})}});
    }
    return table;
}

Table driftTable(const FleetReport& report, const FleetSwings& fleet)
{
    Table table{Words::tr("Drifts, at a false discovery rate of 10 %"),
        {words(Words::tr("aircraft"), 24), words(Words::tr("compass"), 36), words(Words::tr("of"), 10),
            {Words::tr("a year"), {}, QStringLiteral("°"), 20, Align::Point},
            {Words::tr("95 % interval"), {}, QStringLiteral("°"), 34, Align::Left}, plain(Words::tr("p")), words(Words::tr("from"), 28),
            words(Words::tr("to"), 28)},
        {}};
    for (const auto& d : report.changes.drifts) {
        const auto& compass = compassAt(fleet, d.compass);
        table.rows.push_back({{QString::fromStdString(compass.aircraft), QString::fromStdString(compass.compass), letterAt(d.coefficient),
            signedFigure(d.drift.perYear, 3),
            QStringLiteral("%1 – %2").arg(signedFigure(d.drift.interval95.low, 3), signedFigure(d.drift.interval95.high, 3)),
            pText(d.drift.p), dayText(fleet.swings[d.firstRow].day), dayText(fleet.swings[d.lastRow].day)}});
    }
    return table;
}

Table rankingTable(const FleetReport& report, const FleetSwings& fleet, std::size_t most)
{
    Table table{Words::tr("Who next: out of limits before the next date"),
        {words(Words::tr("aircraft"), 24), words(Words::tr("compass"), 34),
            {Words::tr("chance"), {}, QStringLiteral("%"), 16, Align::Point}, words(Words::tr("by"), 27),
            angle(Words::tr("expected"), Words::tr("largest")), angle(Words::tr("limit")), words(Words::tr("last swing"), 27),
            words(Words::tr("reason"), 70)},
        {}};
    const auto& all = report.ranking.compasses;
    for (std::size_t i = 0; i < all.size() && (most == 0 || i < most); ++i) {
        const auto& compass = compassAt(fleet, all[i].compass);
        table.rows.push_back({{QString::fromStdString(compass.aircraft), QString::fromStdString(compass.compass),
                                  probabilityText(all[i].probability), dayText(all[i].by_day), figure(all[i].largestExpected_deg, 1),
                                  figure(all[i].limit_deg, 1), dayText(all[i].lastSwing_day), printable(inWords(all[i]))},
            all[i].probability >= 0.5 ? TableRow::Look::Marked : TableRow::Look::Plain});
    }
    return table;
}

Table binTable(const FleetReport& report)
{
    Table table{Words::tr("The fleet by what is expected, as a share of the limit"),
        {words(Words::tr("largest expected deviation"), 60), plain(Words::tr("compasses"), {}, 24)}, {}};
    constexpr std::array bounds{0.25, 0.5, 0.75, 1.0};
    std::array<int, bounds.size() + 1> count{};
    for (const auto& each : report.ranking.compasses) {
        std::size_t bin = 0;
        while (bin < bounds.size() && each.largestExpected_deg > bounds[bin] * each.limit_deg)
            ++bin;
        ++count[bin];
    }
    const QStringList names{Words::tr("up to a quarter"), Words::tr("a quarter to a half"), Words::tr("a half to three quarters"),
        Words::tr("three quarters to the limit"), Words::tr("beyond the limit")};
    for (std::size_t i = 0; i < count.size(); ++i)
        table.rows.push_back({{names[static_cast<qsizetype>(i)], QString::number(count[i])}});
    return table;
}

} // namespace lubberline::ui
