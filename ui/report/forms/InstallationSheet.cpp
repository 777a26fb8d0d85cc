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

} // namespace lubberline::ui
