#include "ui/calibration/CalibrationPictures.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/calibration/ModelHeader.h"

namespace lubberline::ui {

namespace {

/// Whose words they are, for translators.
struct PictureWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::CalibrationPage)
};

constexpr std::size_t kMostSphereDots = 3000;

std::shared_ptr<const std::vector<double>> shared(std::vector<double> values)
{
    return std::make_shared<const std::vector<double>>(std::move(values));
}

/// A column of a log that lives as long as the plot needs it.
std::shared_ptr<const std::vector<double>> columnOf(const std::shared_ptr<const SensorLog>& log, const std::vector<double>& values)
{
    return {log, &values};
}

std::vector<double> sizesOf(const std::array<std::vector<double>, 3>& field)
{
    std::vector<double> sizes(field[0].size());
    for (std::size_t row = 0; row < sizes.size(); ++row)
        sizes[row] = std::hypot(field[0][row], field[1][row], field[2][row]);
    return sizes;
}

} // namespace

SeriesPicture logPicture(const std::shared_ptr<const SensorLog>& log)
{
    const QString unit = QString::fromStdString(std::string(log->figureUnit()));
    const bool timed = !log->time_s.empty();
    SeriesPicture picture{timed ? PictureWords::tr("time (s)") : PictureWords::tr("row"), PictureWords::tr("field (%1)").arg(unit),
        timed ? QStringLiteral("s") : QString(), unit, {}, {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        picture.series.push_back(
            {QString(QLatin1Char("xyz"[axis])), timed ? columnOf(log, log->time_s) : nullptr, columnOf(log, log->field[axis]), false});
    return picture;
}

std::vector<SphereDot> sphereDots(const CalibrationRun& run)
{
    std::vector<SphereDot> dots;
    if (run.model)
        if (const auto compensator = compensatorOf(*run.model)) {
            const SensorLog& log = *run.part;
            const double sigma = run.ellipsoid ? run.ellipsoid->fit->rms : run.attitude->rms_nT;
            const std::size_t step = log.size() / kMostSphereDots + 1;
            for (std::size_t row = 0; row < log.size(); row += step)
                if (const Eigen::Vector3d field = compensator->field(log.at(row)); field.allFinite() && field.norm() > 0)
                    dots.push_back({field.normalized(), (field.norm() - run.field_nT) / std::max(sigma, 1e-9)});
        }
    return dots;
}

SeriesPicture beforeAfterPicture(const CalibrationRun& run)
{
    if (!run.compensated)
        return {{}, {}, {}, {}, {}, PictureWords::tr("No calibration comes of this log: see why, and what to do next.")};
    const CompensatedLog& compensated = *run.compensated;
    const SensorLog& log = *run.part;
    if (compensated.before && compensated.after) {
        std::vector<double> before(log.size()), after(log.size());
        for (std::size_t row = 0; row < log.size(); ++row) {
            before[row] = wrap180(compensated.before_deg[row] - log.heading_deg[row]);
            after[row] = wrap180(compensated.after_deg[row] - log.heading_deg[row]);
        }
        const auto headings = columnOf(run.part, log.heading_deg);
        return {PictureWords::tr("magnetic heading (°)"), PictureWords::tr("heading error, read − magnetic (°)"), QStringLiteral("°"),
            QStringLiteral("°"),
            {{PictureWords::tr("before"), headings, shared(std::move(before)), true},
                {PictureWords::tr("after"), headings, shared(std::move(after)), true}},
            {}};
    }
    const auto time = log.time_s.empty() ? nullptr : columnOf(run.part, log.time_s);
    const QString unit = QString::fromStdString(std::string(log.figureUnit()));
    return {time ? PictureWords::tr("time (s)") : PictureWords::tr("row"), PictureWords::tr("the field's size (%1)").arg(unit),
        time ? QStringLiteral("s") : QString(), unit,
        {{PictureWords::tr("before"), time, shared(sizesOf(log.field)), false},
            {PictureWords::tr("after"), time, shared(sizesOf(compensated.field)), false}},
        {}};
}

} // namespace lubberline::ui
