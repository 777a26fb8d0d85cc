// How the window reaches heading references, the two-minute check and two compasses compared.

#include "db/stores/Stores.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"
#include "ui/reference/CheckPage.h"
#include "ui/reference/ComparePage.h"
#include "ui/reference/DatumPage.h"
#include "ui/reference/ReferencePage.h"

namespace lubberline::ui {

namespace {

/// Of the newest swing of a compass that has one.
std::optional<OwnIron> ownIron(db::Stores& stores, const FleetItem& record)
{
    const auto* id = std::get_if<CompassId>(&record);
    const auto rows = id ? stores.swings.swingsOf(*id) : Result<std::vector<SwingRow>>(std::vector<SwingRow>());
    const auto compass = id ? stores.fleet.compass(*id) : Result<CompassSystem>(CompassSystem());
    if (!rows || !compass)
        return {};
    const auto aircraft = stores.fleet.aircraft(compass->aircraft);
    for (const SwingRow& row : *rows)
        if (const auto result = row.superseded ? Result<Analysis>(Error{}) : stores.results.resultOf(row.id); result && aircraft)
            return OwnIron{QStringLiteral("%1 · %2").arg(toText(aircraft->registration), toText(compass->name)), result->exact.smith()};
    return {};
}

} // namespace

PageDescription ReferencePage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("reference"), [&context] {
                             return new ReferencePage(
                                 context.files, [&context](const FleetItem& record) { return ownIron(context.stores, record); });
                         }};
    page.commands = {{MenuId::Model, 140, tr("Heading &references in flight"), tr("Ctrl+Alt+R"), "reference", [&context](Page& shown) {
                          context.go({"reference", shown.shown().compass});
                      }}};
    page.help = tr(
        "Draw manoeuvres on the time line or type them, turn the sliders, and see what a vertical gyro, a needle or a slaved gyro makes of them: the error read − magnetic with the share of each source "
        "(the run with all less the run without it), and the gains of the loops against frequency. "
        "Levelling: τ2 dm/dt + m = ε, dσ/dt = −(m + ∫m dt/τ3)/τ1 + ω_D − θ̇; third order needs τ3 > τ2. Slaving: τ_s de/dt + e = e_m + τ_s d. "
        "Vertical: σ = τ1(ω_D − θ̇) is left for good where no integral takes it away; its gain at ω is 1/√(1 + (τ1ω)²) of first order, and that of slaving 1/√(1 + (τ_sω)²). "
        "A tilted sensor is wrong by −(φ cos ψ − θ sin ψ) tan I. Source: Kayton and Fried, Avionics Navigation Systems, chapter 9; where it is misprinted, "
        "recomputed.");
    page.outputs = {{MenuId::File, 200, tr("Save the &scenario or its run…"), {}, "saveScenario",
                        [](Page& shown) { dynamic_cast<ReferencePage&>(shown).save(); }},
        {MenuId::File, 210, tr("Write the &report…"), {}, "referenceReport",
            [](Page& shown) { dynamic_cast<ReferencePage&>(shown).writeReport(); }}};
    return page;
}

PageDescription DatumPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("datum"),
        [&context] { return new DatumPage(context.files, [&context] { return context.stores.clock().nowUtc(); }); }};
    page.commands = {{MenuId::Model, 135, tr("A d&atum anywhere: sun, runway, gyro"), tr("Ctrl+Alt+D"), "datumAnywhere",
        [&context](Page&) { context.go({"datum"}); }}};
    page.help = tr(
        "What tells a heading away from any base, and how well. Sun: heading = azimuth of the sun − its bearing from the nose (a shadow: less 180°); parts of its error: "
        "clock × rate of the azimuth, position, plumb × tan(elevation), pointing, variation (Meeus, Astronomical Formulae for Calculators, chapters 7, 8, 18; "
        "held against almanacs from 1950 to 2050). Runway: its published direction and √2 × off-centre ÷ distance of the points. Transfer gyro: setting, reading, drift × time. "
        "Synchro: one- and two-cycle errors of about 0.2° each (Kayton and Fried 9.2, 9.4). Grid: true − (λ − λ0) in the north, + in the south.");
    page.outputs = {{MenuId::File, 200, tr("Write the &report…"), {}, "datumReport",
        [](Page& shown) { dynamic_cast<DatumPage&>(shown).writeReport(); }}};
    return page;
}

PageDescription CheckPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("check"), [&context] {
            auto* check = new CheckPage(context.stores, context.files);
            connect(check, &CheckPage::makeSwing, &context.window, [&context](const Swing& swing) { context.makeSwing(swing); });
            return check;
        }};
    page.commands = {{MenuId::Swing, 220, tr("T&wo-minute check of this compass"), tr("Ctrl+Alt+C"), "twoMinuteCheck",
        [&context](Page& shown) {
            context.go({"check", shown.shown().compass});
        },
        needsCompass}};
    page.help = tr(
        "Turn to the headings that are named, which are those that tell most about this compass given how it changed so far, and type what datum and compass read: "
        "whether its card still holds, and how probably that verdict is wrong. Each coefficient is believed to wander, N(0, σ²t) with σ learnt from its swings, and to "
        "jump now and then; the readings are weighed by Bayes' rule. Stored, it is a check swing with the verdict in its note, completed and signed as any other; it "
        "is no swing for the calendar.");
    page.outputs = {{MenuId::File, 200, tr("Write the &report…"), {}, "checkReport",
        [](Page& shown) { dynamic_cast<CheckPage&>(shown).writeReport(); }}};
    return page;
}

PageDescription ComparePage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("compare"), [&context] { return new ComparePage(context.stores, context.files); }};
    page.commands = {{MenuId::Swing, 230, tr("C&ompare with another compass"), tr("Ctrl+Alt+O"), "compareCompasses",
        [&context](Page& shown) {
            context.go({"compare", shown.shown().compass});
        },
        needsCompass}};
    page.help = tr(
        "Type what two compasses of one aircraft read together, or read a log of both: which of them moved. Corrected by their cards they differ by −x·Δ1 + x·Δ2, so that "
        "only how each of them changes, or a reading beside a datum, tells them apart; what moved both alike is not in the difference at all, and it is said. Make a swing due notes the finding among the events of the aircraft: the due list names it until a swing is signed or somebody answers for not swinging.");
    page.outputs = {{MenuId::File, 200, tr("Write the &report…"), {}, "compareReport",
        [](Page& shown) { dynamic_cast<ComparePage&>(shown).writeReport(); }}};
    return page;
}

} // namespace lubberline::ui
