#include "ui/sensor/SensorEstimate.h"

#include <QCoreApplication>

#include <algorithm>

#include "core/base/Number.h"
#include "core/swing/Analysis.h"
#include "core/swing/SwingPlaces.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct SensorEstimateTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::SensorEstimate)
};

/// Older swings say nothing of today's iron, and are not read: that would take the window's time.
constexpr std::size_t kMostSwings = 40;

struct EstimatedSwing {
    SwingAtPlace atPlace;
    std::optional<FieldStamp> stamp;
};

/// None where the readings do not tell all five coefficients.
std::optional<EstimatedSwing> estimated(db::Stores& stores, const SwingRecord& record)
{
    const auto result = stores.results.resultOf(record);
    if (!result)
        return std::nullopt;
    const auto& stamp = record.swing.field;
    const std::string label = record.swing.date.text() + (record.site ? " " + record.site->name : std::string());
    auto atPlace = swingAtPlace(result->exact, stamp ? stamp->field.meridian() : MeridianField(), label);
    return atPlace ? std::optional(EstimatedSwing{std::move(atPlace.value()), stamp}) : std::nullopt;
}

/// Newest first; `enough` ends the search.
Result<std::vector<EstimatedSwing>> swingsOf(
    db::Stores& stores, CompassId compass, const std::function<bool(const std::vector<EstimatedSwing>&)>& enough)
{
    const auto rows = stores.swings.swingsOf(compass);
    if (!rows)
        return rows.error();
    std::vector<EstimatedSwing> swings;
    for (std::size_t i = 0; i < std::min(rows->size(), kMostSwings) && !enough(swings); ++i) {
        const auto record = stores.swings.record((*rows)[i].id);
        if (!record)
            return record.error();
        if (auto swing = estimated(stores, *record))
            swings.push_back(std::move(*swing));
    }
    return swings;
}

std::vector<SwingAtPlace> newestOfEachPlace(const std::vector<EstimatedSwing>& swings)
{
    std::vector<SwingAtPlace> chosen;
    std::vector<Place> places;
    for (const EstimatedSwing& swing : swings) {
        if (!swing.stamp || std::find(places.begin(), places.end(), swing.stamp->place) != places.end())
            continue;
        places.push_back(swing.stamp->place);
        chosen.push_back(swing.atPlace);
    }
    return chosen;
}

/// What is stored with a model is English, whoever reads it later (core/base/Message.h).
SensorRecord recordOf(std::string name, std::string note, SensorModel model)
{
    SensorRecord record;
    record.name = std::move(name);
    record.note = std::move(note);
    record.origin = ModelOrigin::EstimatedFromSwings;
    record.model = std::move(model);
    return record;
}

std::string estimateText(const char* name, const Estimate& estimate, int decimals)
{
    return std::string("; ") + name + " " + signedFigureText(estimate.value, decimals) + " ± "
        + figureText(estimate.standardError, decimals);
}

std::string separationNote(const IronSeparation& separation, const std::vector<SwingAtPlace>& swings)
{
    std::string labels;
    for (const SwingAtPlace& swing : swings)
        labels += (labels.empty() ? "" : ", ") + swing.label;
    std::string note = Message{MARKED("ui", "swings %1"), labels}.english();
    note += estimateText("P", separation.P_nT, 0) + " nT" + estimateText("Q", separation.Q_nT, 0) + " nT";
    note += estimateText("c", separation.c, 4) + estimateText("f", separation.f, 4);
    for (const auto& warning : separation.warnings)
        note += "; " + warning.english();
    return note;
}

} // namespace

Result<SensorRecord> estimateFromNewest(db::Stores& stores, CompassId compass, Origin origin, const Result<MeridianField>& field)
{
    auto swings = swingsOf(stores, compass, [](const auto& found) { return !found.empty(); });
    if (!swings)
        return swings.error();
    if (swings->empty())
        return Error{ErrorCode::InvalidInput,
            said(SensorEstimateTexts::tr(
                "no swing of this compass tells all five exact coefficients; expected one with five or more headings all round"))};
    const EstimatedSwing& newest = swings->front();
    if (!newest.stamp && !field)
        return field.error();
    const MeridianField there = newest.stamp ? newest.atPlace.field : *field;
    auto model = modelOf(newest.atPlace.exact, there, origin);
    if (!model)
        return model.error();
    const Message kind = origin == Origin::HardIron ? MARKED("ui", "hard iron") : MARKED("ui", "vertical soft iron");
    std::string note = Message{MARKED("ui", "swing %1: B and C taken as all %2"), newest.atPlace.label, kind}.english();
    if (!newest.stamp)
        note += Message{MARKED("ui", "; the swing states no field: H %1 nT, dip %2° as set on this page"),
            lubberline::figureText(there.horizontal_nT, 0), lubberline::figureText(toDegrees(there.inclination_rad()), 1)}
                    .english();
    return recordOf(newest.atPlace.label + ", " + kind.english(), std::move(note), std::move(model.value()));
}

Result<SensorRecord> estimateBySeparation(db::Stores& stores, CompassId compass)
{
    const auto found = swingsOf(stores, compass, [](const auto&) { return false; });
    if (!found)
        return found.error();
    const auto swings = newestOfEachPlace(*found);
    if (swings.size() < 2)
        return Error{ErrorCode::InvalidInput,
            said(SensorEstimateTexts::tr(
                "swings at %n place(s) with a known field; expected two or more where H and dip differ (sites need latitude and longitude)",
                nullptr, static_cast<int>(swings.size())))};
    const auto separation = separateIron(swings);
    if (!separation)
        return separation.error();
    return recordOf(
        Message{MARKED("ui", "separated, %1 places"), swings.size()}.english(), separationNote(*separation, swings), modelOf(*separation));
}

} // namespace lubberline::ui
