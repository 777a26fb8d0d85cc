#include "ui/electrical/ElectricalSteps.h"

#include "core/angle/Angle.h"
#include "ui/electrical/ElectricalPage.h"

namespace lubberline::ui {

QStringList electricalSteps(const FourPointTable& table)
{
    const auto& indicated = table.indicated_deg;
    QStringList steps;
    const auto step = [&](std::size_t point, double share, const QString& control) {
        if (!indicated[point])
            return;
        const double selected = 90.0 * static_cast<double>(point), error = wrap180(*indicated[point] - selected);
        steps += ElectricalPage::tr("select %1, turn %2: %3 → %4")
                     .arg(selected, 0, 'f', 0)
                     .arg(control)
                     .arg(*indicated[point], 0, 'f', 2)
                     .arg(wrap360(*indicated[point] - error * share), 0, 'f', 2);
    };
    step(2, 0.5, ElectricalPage::tr("half of the error out with N–S"));
    step(1, 1.0, ElectricalPage::tr("all of it out with E–W"));
    step(3, 0.5, ElectricalPage::tr("half of it out with E–W"));
    return steps;
}

} // namespace lubberline::ui
