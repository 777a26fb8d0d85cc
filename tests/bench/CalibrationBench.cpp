// Logs of a million samples: moments, the trimmed fit, headings, spectra and reading, each against what it cannot do without.

#include <fftw3.h>

#include <charconv>
#include <cstdio>
#include <random>
#include <sstream>
#include <vector>

#include "core/calibration/Compensation.h"
#include "core/calibration/Ellipsoid.h"
#include "core/calibration/FieldMoments.h"
#include "core/calibration/Welch.h"
#include "core/format/csv/SensorLogCsv.h"
#include "tests/bench/Ratio.h"

using namespace lubberline;
using namespace lubberline::bench;

namespace {

constexpr std::size_t kSamples = 1'000'000;
volatile double sink = 0; // what nobody reads is not computed

SensorLog randomLog()
{
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    SensorLog log;
    for (std::size_t i = 0; i < kSamples; ++i) {
        Eigen::Vector3d b{normal(random), normal(random), normal(random)};
        b = 48000 * b.normalized() + Eigen::Vector3d(3000, -2000, 1500);
        for (std::size_t axis = 0; axis < 3; ++axis)
            log.field[axis].push_back(b[static_cast<Eigen::Index>(axis)] + 50 * normal(random));
    }
    return log;
}

void sumColumns(const SensorLog& log)
{
    for (const auto& axis : log.field) {
        std::array<double, 8> sums{};
        for (std::size_t i = 0; i + 8 <= axis.size(); i += 8)
            for (std::size_t k = 0; k < 8; ++k)
                sums[k] += axis[i + k];
        sink = sums[0] + sums[1] + sums[2] + sums[3] + sums[4] + sums[5] + sums[6] + sums[7];
    }
}

std::string csvOf(const SensorLog& log)
{
    std::string text = "time_s,bx_nT,by_nT,bz_nT\n";
    char row[128];
    for (std::size_t i = 0; i < kSamples; ++i)
        text.append(row,
            static_cast<std::size_t>(std::snprintf(row, sizeof row, "%.3f,%.1f,%.1f,%.1f\n", 0.004 * static_cast<double>(i),
                log.field[0][i], log.field[1][i], log.field[2][i])));
    return text;
}

/// getline and from_chars on the same columns.
void readPlainly(const std::string& text)
{
    std::istringstream input(text);
    std::array<std::vector<double>, 4> columns;
    std::string line;
    std::getline(input, line);
    while (std::getline(input, line)) {
        const char* at = line.data();
        const char* end = at + line.size();
        for (auto& column : columns) {
            double value = 0;
            at = std::from_chars(at, end, value).ptr + 1;
            column.push_back(value);
        }
    }
    sink = columns[0].back();
}

} // namespace

int main()
{
    const SensorLog log = randomLog();
    const FieldColumns columns{log.field[0], log.field[1], log.field[2]};
    bool kept = true;
    kept &= report("moments to the fourth order",
        compare(
            [&] {
                sink = momentsOf(columns, {}, {3000, -2000, 1500}, 30000).of(0, 2, 2);
            },
            [&] { sumColumns(log); }, 9),
        "sums of the columns", 2.0);
    kept &= report("the whole trimmed fit",
        compare([&] { sink = fitEllipsoid(log, EllipsoidShape::General, {}).fit->field; }, [&] { sumColumns(log); }, 5),
        "sums of the columns", 15.0);

    std::vector<double> headings(kSamples);
    const Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity() * 1.01;
    const Timing level = compare(
        [&] {
            levelHeadings(columns, matrix, {3000, -2000, 1500}, headings);
            sink = headings.back();
        },
        [&] { sumColumns(log); }, 9);
    const double million_s = level.ours_s * 1e6 / static_cast<double>(kSamples);
    kept &= report("a million level headings compensated", {million_s, 0.05}, "50 ms: 20 million a second", 1.0);

    constexpr std::size_t kSegment = 4096;
    double* in = fftw_alloc_real(kSegment);
    fftw_complex* out = fftw_alloc_complex(kSegment / 2 + 1);
    fftw_plan plan = fftw_plan_dft_r2c_1d(kSegment, in, out, FFTW_ESTIMATE);
    std::fill(in, in + kSegment, 1.0);
    const std::vector<std::vector<double>> runs{log.field[0]};
    const std::size_t segments = welch(runs, kSegment, 240).segments;
    kept &= report("Welch, segments of 4096",
        compare([&] { sink = welch(runs, kSegment, 240).density[7]; },
            [&] {
                for (std::size_t i = 0; i < segments; ++i)
                    fftw_execute(plan);
                sink = out[1][0];
            },
            9),
        "its FFTs", 1.5);
    fftw_destroy_plan(plan);
    fftw_free(in);
    fftw_free(out);

    const std::string text = csvOf(log);
    kept &= report("reading a sensor log CSV",
        compare(
            [&] {
                std::istringstream input(text);
                sink = readSensorLog(input, "log.csv")->field[0].back();
            },
            [&] { readPlainly(text); }, 3),
        "getline and from_chars", 2.0);
    return kept ? 0 : 1;
}
