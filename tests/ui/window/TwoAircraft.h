#pragma once

#include "core/format/exchange/Exchange.h"
#include "tests/ui/window/Fixture.h"

namespace lubberline::ui {

/// Two aircraft of a type, each with a compass, a complete swing and a draft.
struct TwoAircraft {
    SmallFleet fleet;
    AircraftId other;
    CompassId otherCompass;
    SwingId complete, draft, otherComplete, otherDraft;

    TwoAircraft()
    {
        Aircraft aircraft;
        aircraft.type = fleet.type;
        aircraft.registration = "3802";
        other = *fleet.stores.save(aircraft);
        CompassSystem compass;
        compass.aircraft = other;
        compass.name = "standby compass";
        otherCompass = *fleet.stores.save(compass);
        complete = fleet.addSwing("2026-11-18", eightPoints());
        draft = fleet.addSwing("2026-11-19", eightPoints());
        const CompassId first = std::exchange(fleet.compass, otherCompass);
        otherComplete = fleet.addSwing("2026-11-20", eightPoints());
        otherDraft = fleet.addSwing("2026-11-21", eightPoints());
        fleet.compass = first;
        for (const SwingId id : {complete, otherComplete})
            if (!fleet.stores.signing.complete(id))
                qFatal("the swing is not complete");
    }
    QString all(AircraftId aircraft)
    {
        return QString::fromStdString(writeExchange(db::exportFleet(fleet.stores.database(), {aircraft}, {}).value()));
    }
};

} // namespace lubberline::ui
