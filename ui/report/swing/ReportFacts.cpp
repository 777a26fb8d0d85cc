/// The particulars of a swing in words: what was swung, with what, where, how and by whom.

#include <cmath>

#include "core/site/SiteSurvey.h"
#include "core/swing/SwingField.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

namespace {

QString orNotStated(const QString& text) { return text.isEmpty() ? notStated() : text; }

QString aircraftWords(const Aircraft& aircraft, const AircraftType& type)
{
    const QString built = aircraft.builtYear ? Words::tr("built %1").arg(*aircraft.builtYear) : QString();
    return joined({printable(aircraft.registration), joined({printable(type.maker), printable(type.name)}).replace(" · ", " "),
        labelled(Words::tr("serial no."), printable(aircraft.serialNumber)), built,
        labelled(Words::tr("operator"), printable(aircraft.operatorName))});
}

QString compassWords(const CompassSystem& compass)
{
    const QString compensator
        = compass.compensator == Compensator::Unknown ? QString() : labelled(Words::tr("compensator:"), wordFor(compass.compensator));
    return joined({printable(compass.name), statedWord(compass.kind), printable(compass.maker),
        labelled(Words::tr("part no."), printable(compass.partNumber)), labelled(Words::tr("serial no."), printable(compass.serialNumber)),
        printable(compass.location), compass.resolutionStated ? Words::tr("read to %1°").arg(compass.resolution_deg) : QString(),
        compensator});
}

QString swingWords(const Swing& swing, bool signaturesStand)
{
    const QString date = swing.date.empty() ? Words::tr("date not stated") : Words::tr("%1 (UTC)").arg(printable(swing.date));
    const QString times = swing.startUtc.empty()
        ? QString()
        : Words::tr("%1 to %2 UTC").arg(printable(swing.startUtc).mid(11, 5), printable(swing.endUtc).mid(11, 5));
    const QString state = swing.state == SwingState::Complete   ? Words::tr("%1, not yet signed").arg(wordFor(swing.state))
        : swing.state == SwingState::Signed && !signaturesStand ? Words::tr("signed by its state alone: NO SIGNATURE STANDS")
                                                                : wordFor(swing.state);
    const QString revision = swing.revision > 1 ? Words::tr("revision %1").arg(swing.revision) : QString();
    return joined({date, times, statedWord(swing.kind), statedWord(swing.stage), state, revision, printable(swing.weather)});
}

QString workWords(const Swing& swing)
{
    return joined({labelled(Words::tr("procedure"), printable(swing.procedure)),
        labelled(Words::tr("work order"), printable(swing.workOrder)), labelled(Words::tr("reason:"), printable(swing.reason))});
}

QString coordinate(std::optional<double> angle_deg, const QString& positive, const QString& negative)
{
    if (!angle_deg)
        return {};
    return QStringLiteral("%1° %2").arg(figure(std::abs(*angle_deg), 4), *angle_deg < 0 ? negative : positive);
}

QString variationWords(std::optional<double> variation_deg, const QString& source)
{
    if (!variation_deg)
        return {};
    const QString value = Words::tr("variation %1° (east +)").arg(signedFigure(variation_deg, 2));
    return source.isEmpty() ? value : Words::tr("%1, source: %2").arg(value, source);
}

QString classWords(const Site& site)
{
    const QString rule = site.siteClass == SiteClass::Class1 ? Words::tr("class 1 (0.1°)")
        : site.siteClass == SiteClass::Class2                ? Words::tr("class 2 (0.25°)")
                                                             : QString();
    return joined({rule, labelled(Words::tr("certificate"), printable(site.certificate)),
        labelled(Words::tr("valid to"), printable(site.certificateExpiry))});
}

/// What a painted line is off today, where the base tells what its lines were laid out with.
QString paintedWords(const Site& site)
{
    if (!site.paintedVariation_deg || !site.variation_deg)
        return {};
    const double offset_deg
        = paintedLineOffset_deg(Variation::fromDegrees(*site.paintedVariation_deg), Variation::fromDegrees(*site.variation_deg));
    const QString since
        = site.paintedDate.empty() ? Words::tr("lines painted") : Words::tr("lines painted %1").arg(printable(site.paintedDate));
    return Words::tr("%1 with variation %2°: add %3° to their figures")
        .arg(since, signedFigure(site.paintedVariation_deg, 2), signedFigure(offset_deg, 2));
}

QString siteWords(const std::optional<Site>& site, const Swing& swing)
{
    const QString used = swing.variation_deg
        ? Words::tr("magnetic headings made from true ones with variation %1° (east +)").arg(signedFigure(swing.variation_deg, 2))
        : QString();
    if (!site)
        return joined({notStated(), used});
    const QString elevation = site->elevation_m ? Words::tr("elevation %1 m").arg(figure(site->elevation_m, 0)) : QString();
    return joined({printable(site->name), coordinate(site->latitude_deg, Words::tr("N"), Words::tr("S")),
        coordinate(site->longitude_deg, Words::tr("E"), Words::tr("W")), elevation,
        variationWords(site->variation_deg, printable(site->variationSource)), classWords(*site), paintedWords(*site), used,
        printable(variationDisagreement(site, swing.field ? swing.field : stampFor(swing, site), swing.variation_deg))});
}

QString datumWords(const Datum& datum)
{
    return joined({printable(datum.instrument), labelled(Words::tr("serial no."), printable(datum.serialNumber)),
        labelled(Words::tr("calibration due"), printable(datum.calibrationDue)), printable(datum.readOut)});
}

QString peopleWords(const People& people)
{
    return joined(
        {labelled(Words::tr("datum"), printable(people.datumReader)), labelled(Words::tr("cockpit"), printable(people.cockpitReader)),
            labelled(Words::tr("adjuster"), printable(people.adjuster)), labelled(Words::tr("inspector"), printable(people.inspector))});
}

QString limitsFact(const std::optional<LimitsProfile>& limits)
{
    const QString words = limits ? limitWords(*limits) : QString();
    if (words.isEmpty())
        return Words::tr("none set");
    return limits->name.empty() ? words : QStringLiteral("%1: %2").arg(printable(limits->name), words);
}

} // namespace

std::vector<Fact> factsOf(const SwingRecord& record, bool signaturesStand)
{
    const Swing& swing = record.swing;
    std::vector<Fact> facts{{Words::tr("Aircraft"), orNotStated(aircraftWords(record.aircraft, record.type))},
        {Words::tr("Compass"), orNotStated(compassWords(record.compass))}, {Words::tr("Swing"), swingWords(swing, signaturesStand)},
        {Words::tr("Task"), orNotStated(workWords(swing))}, {Words::tr("Site"), siteWords(record.site, swing)},
        {Words::tr("Configuration"), orNotStated(configurationWords(swing.configuration))},
        {Words::tr("Datum"), orNotStated(datumWords(swing.datum))}, {Words::tr("People"), orNotStated(peopleWords(swing.people))},
        {Words::tr("Limits"), limitsFact(record.limits)}};
    if (swing.indexRemoved_deg)
        facts.push_back({Words::tr("Index"),
            Words::tr(
                "after these readings A = %1° was taken out by turning the compass; the deviations of the table are as read, results, "
                "plots and card as it stands since")
                .arg(signedFigure(swing.indexRemoved_deg, 1))});
    if (!swing.siteOverride.empty())
        facts.push_back({Words::tr("In spite of"), printable(swing.siteOverride)});
    if (!swing.amendment.empty())
        facts.push_back(
            {Words::tr("Amends"), joined({labelled(Words::tr("record"), printable(swing.supersedes)), printable(swing.amendment)})});
    if (const QString note = printable(swing.note); !note.isEmpty())
        facts.push_back({Words::tr("Note"), note});
    return facts;
}

} // namespace lubberline::ui
