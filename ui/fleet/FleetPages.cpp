// How the window reaches the pages of the fleet: the start, the overview, an aircraft.

#include "ui/due/DueWatch.h"
#include "ui/fleet/AircraftPage.h"
#include "ui/fleet/OverviewPage.h"
#include "ui/fleet/PopulationPage.h"
#include "ui/fleet/StartPage.h"
#include "ui/kit/PageDescription.h"

namespace lubberline::ui {

namespace {

/// Tells a page what is due, now and whenever that is found anew.
template <class Show>
void followDue(PageContext& context, Page& page, Show show)
{
    const auto tell = [&context, show] {
        if (context.due->news())
            show(*context.due->news());
    };
    QObject::connect(context.due, &DueWatch::ready, &page, tell);
    tell();
}

} // namespace

PageDescription StartPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("start"), [&context] {
                             auto* start = new StartPage;
                             connect(start, &StartPage::demonstrationWanted, &context.window, [&context] { context.openDemonstration(); });
                             connect(start, &StartPage::importWanted, &context.window, [&context] { context.chooseImport(); });
                             connect(start, &StartPage::newSwingWanted, &context.window, [&context] { context.go({"newSwing"}); });
                             connect(start, &StartPage::filled, &context.window, [&context] { context.go({}); });
                             return start;
                         }};
    page.shows = [&context](const FleetItem& item) {
        const auto totals = context.stores.fleet.totals();
        return std::holds_alternative<std::monostate>(item) && totals && totals->aircraft == 0;
    };
    page.focus = true;
    page.help
        = tr("The database is empty. Look around in the demonstration fleet, import a file, or name an aircraft and type its first swing.");
    return page;
}

PageDescription OverviewPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("overview"), [&context] {
            auto* overview = new OverviewPage(context.stores);
            connect(overview, &OverviewPage::aircraftChosen, &context.window, [&context](AircraftId id) { context.go({{}, id}); });
            connect(overview, &OverviewPage::newSwingWanted, &context.window, [&context] { context.go({"newSwing"}); });
            connect(overview, &OverviewPage::importWanted, &context.window, [&context] { context.chooseImport(); });
            connect(overview, &OverviewPage::placeWanted, &context.window, [&context](const FleetItem& item) { context.go({{}, item}); });
            connect(overview, &OverviewPage::dueWanted, &context.window, [&context] { context.go({"due"}); });
            followDue(context, *overview, [overview](const DueNews& news) { overview->setDue(news.lines); });
            return overview;
        }};
    page.shows = [](const FleetItem& item) {
        return std::holds_alternative<std::monostate>(item) || std::holds_alternative<AircraftTypeId>(item);
    };
    page.commands = {{MenuId::Fleet, 100, tr("&Overview"), tr("Alt+Home"), "overview", [&context](Page&) { context.go({}); }}};
    page.help = tr(
        "What needs a hand today comes first: guided swings that stand half-way, compasses that are due or out of limits, the newest swings; Enter or a click goes there. "
        "Beneath it the aircraft that are out of limits: their state is that of the newest swing of each compass, held against its limits. Ctrl+F finds one by name.");
    return page;
}

Result<void> OverviewPage::open(const FleetItem& record)
{
    if (const auto* type = std::get_if<AircraftTypeId>(&record)) {
        showType(*type);
        return {};
    }
    if (const auto totals = m_stores.fleet.totals(); !totals)
        return totals.error();
    showFleet();
    return {};
}

Shown OverviewPage::shown() const
{
    Shown shown;
    shown.type = m_type;
    return shown;
}

PageDescription PopulationPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("population"), [&context] {
            auto* population = new PopulationPage(context.stores, context.files);
            connect(population, &PopulationPage::openSwing, &context.window, [&context](SwingId id) { context.go({{}, id}); });
            return population;
        }};
    page.help = tr(
        "Years of swings of a type looked at together: choose a type, then Compute. A click on a heading of the plot lists the swings behind it; the other tabs tell which compass to swing next, the history of one compass as a film, and the tables of the report.");
    page.outputs = {{MenuId::File, 215, tr("Save the fleet &report…"), {}, "saveFleetReport",
        [](Page& shown) { dynamic_cast<PopulationPage&>(shown).save(); }}};
    page.commands = {{MenuId::Fleet, 105, tr("Years as a po&pulation"), tr("Ctrl+Alt+P"), "population", [&context](Page& shown) {
                          context.go({"population", shown.shown().compass.valid() ? FleetItem(shown.shown().compass) : FleetItem()});
                      }}};
    page.focus = true;
    return page;
}

PageDescription AircraftPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("aircraft"), [&context] {
            auto* aircraft = new AircraftPage(context.edits, context.undo);
            connect(aircraft, &AircraftPage::swingChosen, &context.window, [&context](SwingId id) { context.go({{}, id}); });
            followDue(context, *aircraft, [aircraft](const DueNews& news) {
                std::map<CompassId, DueState> due;
                for (const DueLine& line : news.lines)
                    due.emplace(line.compass.compass, line.answer.state);
                aircraft->setDue(std::move(due));
            });
            return aircraft;
        }};
    page.shows = [](const FleetItem& item) { return std::holds_alternative<AircraftId>(item) || std::holds_alternative<CompassId>(item); };
    page.help = tr(
        "Particulars, compasses and events of an aircraft at the left, the swings of the chosen compass and its coefficients over the years at the right. "
        "Enter opens the swing that is marked. Record lightning strikes, engine changes and the like as events: what is due follows from them.");
    return page;
}

namespace {

/// Of an aircraft itself, or of the compass in it.
Result<AircraftId> aircraftOf(db::Stores& stores, const FleetItem& record)
{
    if (const auto* compass = std::get_if<CompassId>(&record)) {
        const auto found = stores.fleet.compass(*compass);
        return found ? Result<AircraftId>(found->aircraft) : found.error();
    }
    const auto* aircraft = std::get_if<AircraftId>(&record);
    return aircraft ? *aircraft : AircraftId();
}

} // namespace

Result<void> AircraftPage::open(const FleetItem& record)
{
    const auto id = aircraftOf(m_context.stores, record);
    if (!id)
        return id.error();
    const auto* compass = std::get_if<CompassId>(&record);
    if (auto shown = showAircraft(*id, compass ? *compass : CompassId()); !shown)
        return shown;
    m_asked = record;
    return {};
}

bool AircraftPage::isOf(const FleetItem& record) const
{
    const auto id = aircraftOf(m_context.stores, record);
    return id && *id == aircraft();
}

Shown AircraftPage::shown() const { return {aircraft(), compass()}; }

std::vector<FleetItem> AircraftPage::path() const
{
    std::vector<FleetItem> path{m_aircraft.record().type, aircraft()};
    if (std::holds_alternative<CompassId>(m_asked))
        path.push_back(m_asked);
    return path;
}

} // namespace lubberline::ui
