#include "ui/reference/DatumMethods.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/angle/PrintedHeading.h"
#include "core/earth/FieldModel.h"
#include "core/procedure/SunDatum.h"
#include "core/reference/Grid.h"
#include "core/reference/VariationTable.h"
#include "ui/plots/drawn/DrawnAxes.h"
#include "ui/text/NumberText.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

namespace {

struct DatumWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::DatumWords)
};

QString headingWords(double heading_deg, int decimals = 1)
{
    return QStringLiteral("%1°").arg(printedHeading_deg(heading_deg, decimals), 4 + decimals, 'f', decimals, QChar('0'));
}

Date dayOf(UtcTime time) { return Date(std::chrono::year_month_day(std::chrono::floor<std::chrono::days>(time))); }

Result<Variation> variationOf(const DatumInputs& inputs)
{
    if (inputs.variation_deg)
        return Variation::fromDegrees(*inputs.variation_deg);
    const auto stamp = stampField(inputs.place, dayOf(inputs.time));
    return stamp ? Result<Variation>(stamp->field.variation()) : Result<Variation>(stamp.error());
}

Result<DatumAnswer> sunAnswer(const DatumInputs& inputs)
{
    const SunPosition sun = sunAt(inputs.place, inputs.time);
    const ErrorBudget budget = withVariation(sunBudget(inputs.place, inputs.time, inputs.sighting), inputs.variationError_deg);
    const SunDoubts doubts = doubtsOf(sun, inputs.time, budget);
    const auto variation = variationOf(inputs);
    if (!variation)
        return variation.error();
    DatumAnswer answer;
    for (const Message& warning : doubts.warnings)
        answer.warnings += translated(warning);
    answer.lines += DatumWords::tr("Sun: azimuth %1 true, elevation %2°; it turns by %3° a minute.")
                        .arg(headingWords(sun.azimuth_deg, 2), plainNumber(sun.elevation_deg, 1), signedNumber(sun.azimuthRate_deg_min, 3));
    answer.lines
        += DatumWords::tr("Astrocompass: set latitude %1°, declination %2°, local hour angle %3.")
               .arg(signedNumber(inputs.place.latitude_deg, 1), signedNumber(sun.declination_deg, 2), headingWords(sun.hourAngle_deg));
    if (doubts.none) {
        answer.headline = DatumWords::tr("The sun has set: no heading.");
        return answer;
    }
    answer.budget = budget;
    if (sun.shadowRatio > 0)
        answer.lines += DatumWords::tr("The shadow points to %1 true and is %2 times as long as its pin.")
                            .arg(headingWords(sun.azimuth_deg + 180, 2), plainNumber(sun.shadowRatio, 2));
    const UtcTime times[] = {inputs.time};
    answer.lines += DatumWords::tr("A clock an hour fast (daylight saving) would turn every heading by %1°.")
                        .arg(signedNumber(hourInA_deg(inputs.place, times), 1));
    if (!inputs.bearing_deg) {
        answer.headline = DatumWords::tr("Read the bearing of %1 from the nose.")
                              .arg(inputs.ofShadow ? DatumWords::tr("the shadow") : DatumWords::tr("the sun"));
        return answer;
    }
    const TrueHeading heading = headingBySun(sun, *inputs.bearing_deg, inputs.ofShadow);
    answer.headline = DatumWords::tr("The aircraft heads %1 magnetic ± %2° (one standard deviation; %3 true, variation %4°).")
                          .arg(headingWords(toMagnetic(heading, *variation).degrees()), plainNumber(budget.total_deg(), 2),
                              headingWords(heading.degrees()), signedNumber(variation->degrees(), 2));
    return answer;
}

Result<DatumAnswer> gridAnswer(const DatumInputs& inputs)
{
    const double year = *decimalYear(dayOf(inputs.time).text());
    const auto model = defaultFieldModel(year);
    if (!model)
        return model.error();
    const auto field = model->evaluate(inputs.place, year);
    if (!field)
        return field.error();
    const Variation variation = inputs.variation_deg ? Variation::fromDegrees(*inputs.variation_deg) : field->field.variation();
    DatumAnswer answer;
    for (const Message& warning : field->warnings)
        answer.warnings += translated(warning);
    answer.headline
        = DatumWords::tr("Grid heading %1 (%2 true)")
              .arg(headingWords(gridHeading_deg(TrueHeading::fromDegrees(inputs.heading_deg), inputs.place, inputs.meridian_deg), 2),
                  headingWords(inputs.heading_deg, 2));
    answer.lines
        += DatumWords::tr("Convergence (true − grid) %1°; grid variation %2°, variation %3°.")
               .arg(signedNumber(convergence_deg(inputs.place, inputs.meridian_deg), 2),
                   signedNumber(grivation_deg(variation, inputs.place, inputs.meridian_deg), 2), signedNumber(variation.degrees(), 2));
    for (const TableReading reading : {TableReading::Between, TableReading::Nearest}) {
        const auto error = variationTableError(*model, inputs.place, year, inputs.tableStep_deg, reading);
        if (!error)
            return error.error();
        const QString words = reading == TableReading::Between
            ? DatumWords::tr(
                "A table of variation in steps of %1°, read between its entries: %2°, wrong by %3° here and up to %4° in this cell.")
            : DatumWords::tr("The same by the nearest entry (steps of %1°): %2°, wrong by %3° here and up to %4° in this cell.");
        answer.lines += words.arg(plainNumber(inputs.tableStep_deg, 1), signedNumber(error->tabled_deg, 2),
            signedNumber(error->error_deg, 2), plainNumber(error->largest_deg, 2));
    }
    return answer;
}

/// Instruments whose heading is only as good as the sum of their parts.
DatumAnswer budgetAnswer(const QString& what, const ErrorBudget& budget)
{
    DatumAnswer answer;
    answer.headline = DatumWords::tr("%1 ± %2° (one standard deviation)").arg(what, plainNumber(budget.total_deg(), 2));
    answer.budget = budget;
    return answer;
}

struct DaySample {
    double hour, elevation_deg, error_deg;
};

constexpr double kMostError_deg = 3; ///< beyond it nobody would take the sun

std::vector<DaySample> dayOfSun(const DatumInputs& inputs)
{
    const auto midnight = std::chrono::floor<std::chrono::days>(inputs.time);
    std::vector<DaySample> samples;
    for (int minute = 0; minute <= 1440; minute += 10) {
        const UtcTime time = midnight + std::chrono::minutes(minute);
        const SunPosition sun = sunAt(inputs.place, time);
        const double error = sunBudget(inputs.place, time, inputs.sighting).total_deg();
        samples.push_back({minute / 60.0, sun.elevation_deg, sun.elevation_deg < kSunset_deg ? std::nan("") : error});
    }
    return samples;
}

DrawnAxes dayAxes(const QRectF& rect, const QFont& font)
{
    return {rect, font, {0, 24, DatumWords::tr("hour of the day (UTC)")},
        {0, kMostError_deg, DatumWords::tr("error of the heading (°, one standard deviation)")}};
}

void paintDay(QPainter& painter, const QRectF& rect, const std::vector<DaySample>& samples, double now_h, const DrawnLook& look)
{
    const DrawnAxes axes = dayAxes(rect, painter.font());
    axes.paint(painter, look.colours);
    painter.save();
    painter.setClipRect(axes.inside());
    QPolygonF errors, elevations;
    const auto flush = [&painter](QPolygonF& line, const QPen& pen) {
        painter.setPen(pen);
        painter.drawPolyline(line);
        line.clear();
    };
    const QPen errorPen = curvePen(look.colours.exact, painter.font()),
               elevationPen = curvePen(look.colours.approximate, painter.font(), 1.2, Qt::DashLine);
    for (const DaySample& sample : samples) {
        if (!std::isfinite(sample.error_deg)) {
            flush(errors, errorPen);
            flush(elevations, elevationPen);
            continue;
        }
        if (look.isShown(0))
            errors << axes.at(sample.hour, sample.error_deg);
        if (look.isShown(1))
            elevations << axes.at(sample.hour, sample.elevation_deg / 90 * kMostError_deg);
    }
    flush(errors, errorPen);
    flush(elevations, elevationPen);
    painter.setPen(QPen(look.colours.axis, 0));
    painter.drawLine(axes.at(now_h, 0), axes.at(now_h, kMostError_deg));
    painter.restore();
}

} // namespace

bool operator==(const DatumInputs& a, const DatumInputs& b)
{
    const auto all = [](const DatumInputs& i) {
        return std::tuple(i.place.latitude_deg, i.place.longitude_deg, i.time, i.variation_deg, i.variationError_deg, i.sighting.clock_s,
            i.sighting.position_km, i.sighting.plumb_deg, i.sighting.pointing_deg, i.ofShadow, i.bearing_deg, i.runway.published_deg,
            i.runway.offCentre_m, i.runway.wheelbase_m, i.runway_deg, i.gyro.setting_deg, i.gyro.reading_deg, i.gyro.drift_deg_h,
            i.gyro.minutes, i.synchro.oneCycle_deg, i.synchro.twoCycle_deg, i.heading_deg, i.meridian_deg, i.tableStep_deg);
    };
    return all(a) == all(b);
}

Result<DatumAnswer> answerOf(DatumMethod method, const DatumInputs& inputs)
{
    switch (method) {
    case DatumMethod::Sun: return sunAnswer(inputs);
    case DatumMethod::Grid: return gridAnswer(inputs);
    case DatumMethod::Runway: {
        const QString what = inputs.runway_deg
            ? DatumWords::tr("Lined up, the aircraft heads %1 magnetic").arg(headingWords(*inputs.runway_deg))
            : DatumWords::tr("Lined up, the aircraft heads as the runway");
        return budgetAnswer(what, budgetOf(inputs.runway));
    }
    case DatumMethod::TransferGyro: return budgetAnswer(DatumWords::tr("The heading that the gyro carries"), budgetOf(inputs.gyro));
    case DatumMethod::Synchro: break;
    }
    return budgetAnswer(DatumWords::tr("The heading that comes by synchro"), budgetOf(inputs.synchro));
}

DrawnPicture sunDay(const DatumInputs& inputs)
{
    const auto samples = dayOfSun(inputs);
    const double now_h
        = std::chrono::duration<double, std::ratio<3600>>(inputs.time - std::chrono::floor<std::chrono::days>(inputs.time)).count();
    DrawnPicture picture;
    picture.paint
        = [samples, now_h](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintDay(painter, rect, samples, now_h, look); };
    picture.readOut = [samples](const QRectF& rect, const QFont& font, const QPointF& at) {
        const DrawnAxes axes = dayAxes(rect, font);
        if (!axes.contains(at))
            return QString();
        const DaySample& sample = samples[static_cast<std::size_t>(std::clamp(std::lround(axes.valueAt(at).x() * 6), 0L, 144L))];
        const QString hour
            = QStringLiteral("%1:%2").arg(int(sample.hour), 2, 10, QChar('0')).arg(std::lround(sample.hour * 60) % 60, 2, 10, QChar('0'));
        return std::isfinite(sample.error_deg) ? DatumWords::tr("%1 UTC: elevation %2°, error %3°")
                                                     .arg(hour, plainNumber(sample.elevation_deg, 1), plainNumber(sample.error_deg, 2))
                                               : DatumWords::tr("%1 UTC: the sun has set").arg(hour);
    };
    picture.legend = [](const PlotColours& colours) {
        return std::vector<LegendEntry>{{DatumWords::tr("error of a heading by the sun"), LegendEntry::Key::Line, QPen(colours.exact, 2)},
            {DatumWords::tr("elevation of the sun (full height: 90°)"), LegendEntry::Key::Line,
                QPen(colours.approximate, 2, Qt::DashLine)}};
    };
    return picture;
}

} // namespace lubberline::ui
