#include "ui/guided/GuidedJob.h"

#include <QRegularExpression>

#include <cmath>

#include "core/angle/AngleText.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/Number.h"
#include "core/deviation/SlipWords.h"
#include "core/procedure/Plan.h"
#include "core/procedure/SunDatum.h"
#include "core/swing/SwingResult.h"
#include "ui/guided/GuidedWords.h"
#include "ui/kit/Words.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/text/AngleWords.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

namespace {

constexpr double kNearEnough_deg = 5.0; // procedures: an aircraft within 5° of the wanted heading is enough
constexpr std::size_t kMostFigures = 3;

} // namespace

Result<std::vector<double>> parseFigures(const QString& text)
{
    static const QRegularExpression separators("[\\s/]+");
    std::vector<double> figures;
    for (const QString& part : text.split(separators, Qt::SkipEmptyParts)) {
        const auto figure = parseHeading_deg(part.toStdString());
        if (!figure)
            return figure.error();
        figures.push_back(*figure);
    }
    if (figures.size() > kMostFigures)
        return Error{
            ErrorCode::InvalidInput, said(GuidedJob::tr("%1 figures; expected one to three of the same heading").arg(figures.size()))};
    return figures;
}

GuidedJob::GuidedJob(GuidedServices services, QObject* parent) : QObject(parent), m_services(std::move(services)) {}

Result<void> GuidedJob::open(SwingJob job, const SwingRecord& record, std::shared_ptr<const Analysis> previous,
    const QString& previousLabel, const std::optional<ExpectedCurve>& siblings)
{
    auto state = stateOf(job);
    if (!state)
        return state.error();
    m_job = std::move(job);
    m_state = std::move(state.value());
    m_record = record;
    m_previous = std::move(previous);
    m_previousLabel = previousLabel;
    m_siblings = siblings;
    m_open = true;
    emit changed();
    return {};
}

const StationState* GuidedJob::station() const
{
    if (m_state.phase != JobPhase::Stations || m_state.current < 0)
        return nullptr;
    return &m_state.stations[static_cast<std::size_t>(m_state.current)];
}

Result<void> GuidedJob::tell(job::What what)
{
    LUBBERLINE_EXPECT(m_open, "a guided swing is told something only while it is open");
    SwingJob next = m_job;
    next.events.push_back({m_services.nowUtc(), std::move(what)});
    auto state = stateOf(next);
    if (!state)
        return state.error();
    if (const auto stored = m_services.store(m_job, next.events.back()); !stored)
        return stored.error();
    m_job = std::move(next);
    m_state = std::move(state.value());
    emit changed();
    return {};
}

std::string GuidedJob::Prepared::keptNote() const { return keptAsRead(judgement) + (note.empty() ? std::string() : "; " + note.english()); }

std::optional<Place> GuidedJob::placeOfSun() const
{
    const auto& site = m_record.site;
    if (!site || !site->latitude_deg || !site->longitude_deg)
        return {};
    return Place{*site->latitude_deg, *site->longitude_deg, 0};
}

Message GuidedJob::clockDoubt() const
{
    const auto place = placeOfSun();
    return place ? sunDoubt(m_job, m_state, *place) : Message{};
}

void GuidedJob::tellDatumErrors(Swing& swing) const
{
    if (!swing.sharedErrors.any()) // else somebody stated it
        swing.sharedErrors = sharedErrorsOf(m_job, swing, placeOfSun());
}

QString GuidedJob::astroSetting() const
{
    const auto place = placeOfSun();
    const auto time = readUtcTime(m_services.nowUtc());
    if (datum().kind != DatumKind::Astrocompass || !place || !time)
        return {};
    const SunPosition sun = sunAt(*place, *time);
    return tr("Set the astrocompass for %1 UTC: latitude %2°, declination %3°, local hour angle %4°.")
        .arg(toText(m_services.nowUtc().substr(11, 5)), signedNumber(place->latitude_deg, 1), signedNumber(sun.declination_deg, 1),
            plainNumber(sun.hourAngle_deg, 1));
}

/// By the sun it takes the base's place and the time of now.
Result<DatumHeading> GuidedJob::headingOf(const RawFigures& raw, Message& note) const
{
    const auto& stated = m_job.particulars.variation_deg;
    const auto variation = stated ? std::optional(Variation::fromDegrees(*stated)) : std::nullopt;
    const auto place = placeOfSun();
    if (!takesSun(datum().kind) || (!place && !needsSun(datum().kind)))
        return datumHeading(datum(), raw, variation);
    if (!place)
        return Error{ErrorCode::InvalidInput,
            said(tr("the sun tells a heading where the place is known; give the base its latitude and longitude"))};
    const auto time = readUtcTime(m_services.nowUtc());
    if (!time)
        return time.error();
    auto heading = sunHeading(datum(), raw, *place, *time, variation);
    if (!heading)
        return heading.error();
    for (const Message& warning : heading->warnings)
        note = warning;
    return std::move(heading->heading);
}

Result<GuidedJob::Prepared> GuidedJob::prepare(const Entry& entry) const
{
    const StationState* here = station();
    LUBBERLINE_EXPECT(here, "a reading is made at a station");
    const RawFigures raw{entry.datum_deg, entry.astern_deg, entry.compass_deg};
    Message sunNote;
    const auto heading = headingOf(raw, sunNote);
    if (!heading)
        return heading.error();
    const auto compass = compassFigure(raw, m_job.resolution_deg);
    if (!compass)
        return compass.error();
    const double off = std::abs(wrap180(heading->magnetic.degrees() - here->station.nominal_deg));
    if (off > reachOfStation_deg(m_job.plan))
        return Error{ErrorCode::InvalidInput,
            said(tr("the datum says %1°, which is no reading on %2°; turn there, or skip this heading with a reason (F4)")
                     .arg(printedHeading_deg(heading->magnetic.degrees(), 1), 0, 'f', 1)
                     .arg(here->station.nominal_deg, 3, 'f', 0, QChar('0')))};

    Prepared prepared;
    prepared.reading = {m_state.current, raw, heading->magnetic.degrees(), compass->compass.degrees(), {}};
    prepared.datumSpread_deg = heading->spread_deg;
    prepared.compassSpread_deg = compass->spread_deg;
    prepared.note = sunNote;
    if (off > kNearEnough_deg)
        prepared.note = {MARKED("ui", "the aircraft stands %1° from %2; within 5° is wanted"), lubberline::figureText(off, 1),
            formatHeading(here->station.nominal_deg, AngleStyle::DecimalDegrees, 0)};

    std::vector<Observation> earlier;
    std::vector<double> nominals;
    for (const auto& other : m_state.stations) {
        // Readings of before an adjustment say little of the compass as it is now.
        if (other.reading && !other.voided && other.station.phase == here->station.phase
            && other.station.configuration == here->station.configuration)
            earlier.push_back(*other.reading);
        if (&other != here && !other.done())
            nominals.push_back(other.station.nominal_deg);
    }
    SlipContext context;
    if (m_previous && m_previous->approximate.parameters == static_cast<int>(kCoefficientCount))
        context.expected = curveAfter(m_previous->approximate.smith());
    else if (m_siblings)
        context.expected = *m_siblings;
    context.earlier = earlier;
    context.resolution_deg = m_job.resolution_deg;
    context.nominal_deg = here->station.nominal_deg;
    context.otherNominals_deg = nominals;
    prepared.judgement = judgeReading({heading->magnetic, compass->compass}, context);
    return prepared;
}

std::optional<double> GuidedJob::datumShould_deg(double magnetic_deg) const
{
    if (needsSun(datum().kind))
        return {};
    Message note;
    const auto shown = headingOf({{wrap360(magnetic_deg)}, {}, {}}, note);
    if (!shown)
        return {};
    return wrap360(magnetic_deg - wrap180(shown->magnetic.degrees() - magnetic_deg)); // every correction is an angle that is added
}

Result<void> GuidedJob::readAgain(int station)
{
    const bool skipped = !m_state.stations[static_cast<std::size_t>(station)].skipped.empty();
    return tell(job::ReadingRejected{station, skipped ? "read after all" : "read again"});
}

QString GuidedJob::skipCostWords() const
{
    const StationState* here = station();
    if (!here)
        return {};
    if (here->station.phase == StationPhase::AsFound || here->station.phase == StationPhase::Correct)
        return std::fmod(here->station.nominal_deg, 180.0) == 0.0 ? tr("Without it C is not told, and the N–S control stays as it is.")
                                                                  : tr("Without it B is not told, and the E–W control stays as it is.");
    std::vector<double> planned, left;
    for (const auto& other : m_state.stations)
        if (other.station.phase == here->station.phase && other.station.configuration == here->station.configuration) {
            planned.push_back(other.station.nominal_deg);
            if (&other != here && other.skipped.empty())
                left.push_back(other.station.nominal_deg);
        }
    return costWords(planned, left);
}

int GuidedJob::lastRead() const
{
    for (auto event = m_job.events.rbegin(); event != m_job.events.rend(); ++event) {
        if (const auto* skipped = std::get_if<job::StationSkipped>(&event->what))
            if (!m_state.stations[static_cast<std::size_t>(skipped->station)].skipped.empty())
                return skipped->station;
        if (const auto* taken = std::get_if<job::ReadingTaken>(&event->what)) {
            const auto& station = m_state.stations[static_cast<std::size_t>(taken->station)];
            if (station.reading && station.correctionsDone == 0)
                return taken->station;
        }
    }
    return -1;
}

SwingPicture GuidedJob::picture() const
{
    SwingRecord record = m_record;
    record.swing = asLeftSwing(m_job, m_state);
    const bool checking = std::any_of(
        record.swing.readings.begin(), record.swing.readings.end(), [](const Reading& reading) { return reading.complete(); });
    if (!checking)
        record.swing = asFoundSwing(m_job, m_state);
    tellDatumErrors(record.swing);
    std::shared_ptr<const Analysis> analysis;
    QString why;
    record.compass.resolution_deg = m_job.resolution_deg;
    if (auto made = resultOf(record, &m_job)) {
        analysis = std::make_shared<const Analysis>(std::move(made.value()));
    } else
        why = translated(made.error().message);
    return pictureOf(record, std::move(analysis), why, m_previous, m_previousLabel, shownAngles());
}

} // namespace lubberline::ui
