#include "ui/report/forms/InstallationSheet.h"

#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

QString distanceVerdict(const InstallationDistance& asked, std::optional<double> measured_m)
{
    if (!measured_m)
        return Words::tr("not looked at");
    return *measured_m >= asked.least_m ? Words::tr("kept") : Words::tr("TOO NEAR by %1 m").arg(figure(asked.least_m - *measured_m, 2));
}

QString distancesWords(const std::vector<std::optional<double>>& measured_m)
{
    const auto asked = installationDistances();
    int looked = 0, near = 0;
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (const auto measured = i < measured_m.size() ? measured_m[i] : std::nullopt) {
            ++looked;
            near += *measured < asked[i].least_m ? 1 : 0;
        }
    return near > 0 ? Words::tr("▲ %1 of %2 distances are too small; %3 were looked at.").arg(near).arg(asked.size()).arg(looked)
        : looked == static_cast<int>(asked.size())
        ? Words::tr("● All %1 distances are kept.").arg(looked)
        : Words::tr("○ %1 of %2 distances were looked at; none is too small.").arg(looked).arg(asked.size());
}

ReferenceSheet distancesSheet(const std::vector<std::optional<double>>& measured_m)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Installation of a flux gate");
    sheet.text << distancesWords(measured_m)
               << Words::tr("Least distances as the maker of a flux gate asks (Garmin, installation manual of the GMU 11/44).");
    sheet.table = {Words::tr("Distances"),
        {{Words::tr("From"), {}, {}, 78, TableColumn::Align::Left}, {Words::tr("At least"), {}, QStringLiteral("m"), 24},
            {Words::tr("Measured"), {}, QStringLiteral("m"), 24}, {Words::tr("Verdict"), {}, {}, 40, TableColumn::Align::Left}},
        {}};
    const auto asked = installationDistances();
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto measured = i < measured_m.size() ? measured_m[i] : std::nullopt;
        sheet.table.rows.push_back(
            {{printable(Message(asked[i].thing)), figure(asked[i].least_m, 1), figure(measured, 2), distanceVerdict(asked[i], measured)},
                measured && *measured < asked[i].least_m ? TableRow::Look::Marked : TableRow::Look::Plain});
    }
    sheet.signatures = true;
    return sheet;
}

ReferenceSheet dipoleSheet(const DipoleSource& found, std::size_t readings, const QString& source)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Source of a stray field");
    sheet.subject = source;
    sheet.text << Words::tr("One dipole and a uniform field, by least squares from %1 readings; %2 nT rms of a component are left. The "
                            "nearest reading stands %3 m from the source; standard errors are one sigma.")
                      .arg(readings)
                      .arg(figure(found.rms_nT, 1), figure(found.nearest_m, 2));
    for (const Message& warning : found.warnings)
        sheet.text << printable(warning);
    sheet.table = {Words::tr("Source"),
        {{Words::tr("Quantity"), {}, {}, 76, TableColumn::Align::Left}, {QStringLiteral("x"), {}, {}, 30},
            {QStringLiteral("y"), {}, {}, 30}, {QStringLiteral("z"), {}, {}, 30}},
        {}};
    const auto add = [&sheet](const QString& what, const Eigen::Vector3d& values, int decimals) {
        sheet.table.rows.push_back(
            {{what, signedFigure(values.x(), decimals), signedFigure(values.y(), decimals), signedFigure(values.z(), decimals)}});
    };
    add(Words::tr("place (m)"), found.at_m, 3);
    sheet.table.rows.push_back({{Words::tr("its standard error (m)"), figure(found.atError_m.x(), 3), figure(found.atError_m.y(), 3),
        figure(found.atError_m.z(), 3)}});
    add(Words::tr("moment (A m²)"), found.moment_A_m2, 3);
    add(Words::tr("uniform field (nT)"), found.uniform_nT, 0);
    sheet.text << Words::tr("Size of the moment: %1 ± %2 A m² (one standard error).")
                      .arg(figure(found.moment_A_m2.norm(), 3), figure(found.momentError_A_m2, 3));
    sheet.signatures = true;
    return sheet;
}

ReferenceSheet siteCheckSheet(const BothWays& both, const QString& sources)
{
    ReferenceSheet sheet;
    sheet.title = Words::tr("Site check");
    sheet.subject = sources;
    sheet.text << Words::tr("A run clockwise held against one counter-clockwise: what differs is no deviation.")
               << (both.within() ? Words::tr("● The largest difference, %1°, is within %2°.")
                                 : Words::tr("▲ The largest difference, %1°, is MORE THAN %2°."))
                      .arg(figure(both.largest_deg, 2), figure(both.limit_deg, 2));
    if (both.within() && !both.passes)
        sheet.text << Words::tr("▲ It does not pass: the runs are not one each way round over all headings.");
    for (const Message& finding : both.findings)
        sheet.text << printable(finding);
    sheet.text << Words::tr("%1° rms are left.").arg(figure(both.residual_deg, 2));
    sheet.table = {Words::tr("Clockwise − counter-clockwise"),
        {{Words::tr("Part"), {}, {}, 76, TableColumn::Align::Left}, {Words::tr("Difference"), {}, QStringLiteral("°"), 40},
            {Words::tr("Standard error"), {}, QStringLiteral("°"), 40}},
        {}};
    const QString parts[] = {Words::tr("constant"), Words::tr("with sin of heading"), Words::tr("with cos of heading")};
    for (std::size_t i = 0; i < std::size(parts); ++i)
        sheet.table.rows.push_back({{parts[i], signedFigure(both.difference_deg[i], 2), figure(both.standardError_deg[i], 2)}});
    sheet.signatures = true;
    return sheet;
}

} // namespace lubberline::ui
