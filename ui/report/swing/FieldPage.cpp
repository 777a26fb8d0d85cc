#include "ui/report/swing/FieldPage.h"

#include <cmath>

#include "core/swing/SwingField.h"
#include "core/swing/SwingPlaces.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

QString place(const Place& place)
{
    const auto angle = [](double value_deg, const QString& positive, const QString& negative) {
        return QStringLiteral("%1° %2").arg(figure(std::abs(value_deg), 4), value_deg < 0 ? negative : positive);
    };
    return joined({angle(place.latitude_deg, Words::tr("N"), Words::tr("S")), angle(place.longitude_deg, Words::tr("E"), Words::tr("W")),
        Words::tr("%1 m above the ellipsoid").arg(figure(place.height_m, 0))});
}

QString variation(const Swing& swing)
{
    const QString modelled = Words::tr("%1° (east +)").arg(signedFigure(swing.field->field.variation().degrees(), 2));
    const auto beyond_deg = variationBeyondStamp_deg(swing);
    if (!beyond_deg)
        return modelled;
    const QString stated = Words::tr("the swing states %1°").arg(signedFigure(swing.variation_deg, 2));
    return std::abs(*beyond_deg) > kDoubtfulVariation_deg
        ? joined({modelled, stated, Words::tr("they differ by more than %1°: to be looked at").arg(kDoubtfulVariation_deg)})
        : joined({modelled, stated});
}

std::vector<Fact> fieldFacts(const Swing& swing)
{
    const FieldStamp& stamp = *swing.field;
    const EarthField& field = stamp.field;
    return {{Words::tr("Model"), Words::tr("%1 for %2").arg(printable(stamp.model), printable(stamp.date))},
        {Words::tr("Place"), place(stamp.place)},
        {Words::tr("Field"),
            Words::tr("north %1, east %2, down %3 nT; horizontal H %4 nT, total F %5 nT")
                .arg(signedFigure(field.north_nT, 1), signedFigure(field.east_nT, 1), signedFigure(field.down_nT, 1),
                    figure(field.horizontal_nT(), 1), figure(field.total_nT(), 1))},
        {Words::tr("Dip"), Words::tr("%1° (down +)").arg(signedFigure(toDegrees(field.inclination_rad()), 2))},
        {Words::tr("Variation"), variation(swing)}};
}

/// [P 7]
constexpr std::array<const char*, kCoefficientCount> kCombinations{
    "(d − b) / 2λ, with the turn of the mount", "(c tan I + P/H) / λ", "(f tan I + Q/H) / λ", "(a − e) / 2λ", "(d + b) / 2λ"};

Table combinationsTable(const ExactFit& fit)
{
    Table table{Words::tr("What this swing tells of the iron: exact coefficients as Poisson's combinations"), {}, {}};
    table.columns = {{Words::tr("Coefficient"), {}, {}, 24, TableColumn::Align::Left},
        {Words::tr("Combination"), {}, {}, 66, TableColumn::Align::Left}, {Words::tr("Found"), {}, Words::tr("no unit"), 30},
        {Words::tr("± std. error"), {}, Words::tr("no unit"), 30}};
    for (const Coefficient c : kCoefficients) {
        TableRow row;
        row.cells = {QChar::fromLatin1(letterOf(c)), QString::fromUtf8(kCombinations[indexOf(c)]), signedFigure(fit.value[indexOf(c)], 4),
            figure(fit.standardError[indexOf(c)], 4)};
        table.rows.push_back(row);
    }
    return table;
}

} // namespace

void describeField(const ReportInput& input, FieldPage& page)
{
    page.field = fieldFacts(input.record.swing);
    page.combinations = combinationsTable(input.analysis.exact);
    const auto swing = swingAtPlace(input.analysis.exact, input.record.swing.field->field.meridian(), input.record.swing.date.text());
    if (!swing) {
        page.unknown
            = {Words::tr("the headings of this swing do not tell all five coefficients, so nothing is said of Poisson's parameters")};
        return;
    }
    for (const auto& knowledge : whatSwingsTell(*swing, std::nullopt))
        if (!knowledge.known) // what is known stands in the table
            page.unknown += printable(knowledge.what);
}

std::optional<FieldPage> fieldPageOf(const ReportInput& input)
{
    if (!input.record.swing.field && input.sensors.empty())
        return {};
    FieldPage page;
    if (input.record.swing.field)
        describeField(input, page);
    if (!input.sensors.empty())
        describeSensor(input, input.sensors.front(), page);
    return page;
}

} // namespace lubberline::ui
