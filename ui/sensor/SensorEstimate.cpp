#include "ui/sensor/SensorEstimate.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

#include "core/swing/Analysis.h"
#include "core/swing/SwingPlaces.h"
#include "core/swing/SwingResult.h"
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
std::optional<EstimatedSwing> estimated(const SwingRecord& record)
{
    const auto result = resultOf(record, nullptr, {0}); // no harmonics are asked for
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
        if (auto swing = estimated(*record))
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

SensorRecord recordOf(const QString& name, const QString& note, SensorModel model)
{
    SensorRecord record;
    record.name = name.toStdString();
    record.note = note.toStdString();
    record.origin = ModelOrigin::EstimatedFromSwings;
    record.model = std::move(model);
    return record;
}

QString estimateText(const QString& name, const Estimate& estimate, int decimals)
{
    return QStringLiteral("%1 %2 ± %3").arg(name, signedNumber(estimate.value, decimals)).arg(estimate.standardError, 0, 'f', decimals);
}

QString separationNote(const IronSeparation& separation, const std::vector<SwingAtPlace>& swings)
{
    QStringList labels, parts;
    for (const SwingAtPlace& swing : swings)
        labels += toText(swing.label);
    parts += SensorEstimateTexts::tr("swings %1").arg(labels.join(QStringLiteral(", ")));
    parts += estimateText(QStringLiteral("P"), separation.P_nT, 0) + QStringLiteral(" nT");
    parts += estimateText(QStringLiteral("Q"), separation.Q_nT, 0) + QStringLiteral(" nT");
    parts += estimateText(QStringLiteral("c"), separation.c, 4);
    parts += estimateText(QStringLiteral("f"), separation.f, 4);
    for (const auto& warning : separation.warnings)
        parts += toText(warning);
    return parts.join(QStringLiteral("; "));
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
    const QString label = toText(newest.atPlace.label);
    const QString kind = origin == Origin::HardIron ? SensorEstimateTexts::tr("hard iron") : SensorEstimateTexts::tr("vertical soft iron");
    QString note = SensorEstimateTexts::tr("swing %1: B and C taken as all %2").arg(label, kind);
    if (!newest.stamp)
        note += SensorEstimateTexts::tr("; the swing states no field: H %1 nT, dip %2° as set on this page")
                    .arg(there.horizontal_nT, 0, 'f', 0)
                    .arg(toDegrees(there.inclination_rad()), 0, 'f', 1);
    return recordOf(SensorEstimateTexts::tr("%1, %2").arg(label, kind), note, std::move(model.value()));
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
        SensorEstimateTexts::tr("separated, %1 places").arg(swings.size()), separationNote(*separation, swings), modelOf(*separation));
}

} // namespace lubberline::ui
