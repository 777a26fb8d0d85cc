#include "ui/kit/CompassTitle.h"

#include <QCoreApplication>

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct CompassTitleWords {
    Q_DECLARE_TR_FUNCTIONS(CompassTitle)
};

} // namespace

Result<QString> compassTitle(db::Stores& stores, CompassId compass)
{
    const auto record = stores.fleet.compass(compass);
    if (!record)
        return record.error();
    const auto aircraft = stores.fleet.aircraft(record->aircraft);
    if (!aircraft)
        return aircraft.error();
    return QStringLiteral("%1 · %2").arg(toText(aircraft->registration), toText(record->name))
        + (aircraft->demonstration ? CompassTitleWords::tr(" · DEMONSTRATION") : QString());
}

Result<QString> titleWith(db::Stores& stores, CompassId compass, const QString& title)
{
    if (!compass.valid())
        return title;
    auto name = compassTitle(stores, compass);
    return name ? Result<QString>(title + QStringLiteral(" · ") + *name) : name;
}

CompassId compassIn(const FleetItem& record)
{
    const auto* compass = std::get_if<CompassId>(&record);
    return compass ? *compass : CompassId();
}

} // namespace lubberline::ui
