#include "ui/window/Pages.h"

#include "ui/bench/IronBenchPage.h"
#include "ui/calibration/CalibrationPage.h"
#include "ui/calibration/LineOfSightPage.h"
#include "ui/calibration/SensorTestsPage.h"
#include "ui/due/DuePage.h"
#include "ui/earth/EarthFieldPage.h"
#include "ui/earth/PredictionPage.h"
#include "ui/electrical/ElectricalPage.h"
#include "ui/fleet/AircraftPage.h"
#include "ui/fleet/NewRecordPage.h"
#include "ui/fleet/OverviewPage.h"
#include "ui/fleet/PopulationPage.h"
#include "ui/fleet/StartPage.h"
#include "ui/guided/GuidedPage.h"
#include "ui/help/HelpPage.h"
#include "ui/inflight/FlightLogPage.h"
#include "ui/inflight/WindsPage.h"
#include "ui/intake/NewSwingPage.h"
#include "ui/intake/NmeaImportPage.h"
#include "ui/intake/YearsImportPage.h"
#include "ui/preferences/PreferencesPage.h"
#include "ui/reference/CheckPage.h"
#include "ui/reference/ComparePage.h"
#include "ui/reference/DatumPage.h"
#include "ui/reference/ReferencePage.h"
#include "ui/sensor/SensorPage.h"
#include "ui/sites/InstrumentsPage.h"
#include "ui/sites/SitesPage.h"
#include "ui/swing/SwingPage.h"

namespace lubberline::ui {

std::vector<PageDescription> allPages(PageContext& context)
{
    // Of two that show the same kind of record the first is asked first.
    return {
        StartPage::description(context),
        OverviewPage::description(context),
        AircraftPage::description(context),
        PopulationPage::description(context),
        GuidedPage::description(context),
        SwingPage::description(context),
        NewSwingPage::description(context),
        NmeaImportPage::description(context),
        YearsImportPage::description(context),
        FlightLogPage::description(context),
        WindsPage::description(context),
        ElectricalPage::description(context),
        SensorPage::description(context),
        IronBenchPage::description(context),
        CalibrationPage::description(context),
        SensorTestsPage::description(context),
        LineOfSightPage::description(context),
        PredictionPage::description(context),
        EarthFieldPage::description(context),
        ReferencePage::description(context),
        DatumPage::description(context),
        CheckPage::description(context),
        ComparePage::description(context),
        DuePage::description(context),
        SitesPage::description(context),
        InstrumentsPage::description(context),
        NewRecordPage::description(context, NewRecordPage::Kind::Type),
        NewRecordPage::description(context, NewRecordPage::Kind::Aircraft),
        NewRecordPage::description(context, NewRecordPage::Kind::Compass),
        PreferencesPage::description(context),
        HelpPage::description(context),
    };
}

} // namespace lubberline::ui
