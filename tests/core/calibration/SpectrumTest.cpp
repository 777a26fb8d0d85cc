#include "core/calibration/Spectrum.h"

#include <gmock/gmock.h>

#include <numeric>
#include <random>

#include "core/angle/Angle.h"
#include "core/calibration/LogQuality.h"
#include "core/calibration/Welch.h"

namespace lubberline::test {
namespace {

using testing::HasSubstr;

struct Sine {
    double frequency_hz, amplitude;
};

SensorLog logWith(const std::vector<Sine>& sines, double rate_hz, int samples, double noise = 20)
{
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    SensorLog log;
    for (int i = 0; i < samples; ++i) {
        const double time = i / rate_hz;
        double value = 20000;
        for (const auto& sine : sines)
            value += sine.amplitude * std::sin(2 * kPi * sine.frequency_hz * time + 0.3);
        log.time_s.push_back(time);
        log.field[0].push_back(value + noise * normal(random));
        log.field[1].push_back(noise * normal(random));
        log.field[2].push_back(40000 + noise * normal(random));
    }
    return log;
}

/// Parseval: density times step adds up to the variance; of a sine exactly (its own bin), of noise in the mean.
TEST(Spectrogram, tellsWhenALineIsThere)
{
    SensorLog log = logWith({}, 200, 8192);
    for (std::size_t row = 4096; row < log.size(); ++row)
        log.field[0][row] += 100 * std::sin(2 * kPi * 50 * log.time_s[row]);
    const auto spectrogram = spectrogramOf(log, "bx", 256, 16);
    ASSERT_TRUE(spectrogram);
    EXPECT_EQ(spectrogram->time_s.size(), 16u);
    EXPECT_NEAR(spectrogram->step_hz, 200.0 / 256, 1e-12);
    const auto at50 = static_cast<std::size_t>(std::lround(50 / spectrogram->step_hz));
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_EQ(spectrogram->density[i][at50] > 1e3, spectrogram->time_s[i] > log.time_s[4096]) << i;
    EXPECT_FALSE(spectrogramOf(log, "nothing", 256));
    log.time_s.clear();
    EXPECT_FALSE(spectrogramOf(log, "bx", 256));
}

TEST(Welch, densityAddsUpToTheVariance)
{
    std::vector<double> sine;
    for (int i = 0; i < 4096; ++i)
        sine.push_back(7 + 3 * std::sin(2 * kPi * 16 * i / 256.0));
    const auto spectrum = welch(std::vector<std::vector<double>>{sine}, 256, 100);
    EXPECT_EQ(spectrum.segments, 31u);
    EXPECT_NEAR(std::accumulate(spectrum.density.begin(), spectrum.density.end(), 0.0) * spectrum.step_hz, 4.5, 1e-9);
    EXPECT_NEAR(spectrum.step_hz, 100.0 / 256, 1e-12);
}

/// White noise of 20 nT at 240 Hz is 400/120 nT²/Hz one-sided.
TEST(Spectrum, noiseIsFlatAndHasNoLines)
{
    const auto spectrum = spectrumOf(logWith({}, 240, 20000), {.column = "by_nT"});
    ASSERT_TRUE(spectrum) << describe(spectrum.error());
    EXPECT_TRUE(spectrum->lines.empty());
    const double mean
        = std::accumulate(spectrum->density.begin() + 2, spectrum->density.end(), 0.0) / static_cast<double>(spectrum->density.size() - 2);
    EXPECT_NEAR(mean, 400.0 / 120, 0.15);
}

TEST(Spectrum, linesAreNamedWithTheirAmplitude)
{
    const auto spectrum = spectrumOf(logWith({{50, 30}, {80, 12}}, 240, 20000), {});
    ASSERT_TRUE(spectrum) << describe(spectrum.error());
    EXPECT_EQ(spectrum->column, "bx") << "the axis with the strongest line";
    ASSERT_EQ(spectrum->lines.size(), 2u);
    EXPECT_NEAR(spectrum->lines[0].frequency_hz, 50, 0.1);
    EXPECT_NEAR(spectrum->lines[0].amplitude, 30, 0.7);
    EXPECT_EQ(spectrum->lines[0].source.english(), "mains 50 Hz");
    EXPECT_FALSE(spectrum->lines[0].aliasOf_hz);
    // At 240 samples a second 400 Hz stand at 80 Hz.
    EXPECT_NEAR(spectrum->lines[1].frequency_hz, 80, 0.1);
    EXPECT_NEAR(*spectrum->lines[1].aliasOf_hz, 400, 1e-9);
    EXPECT_THAT(together(spectrum->warnings).english(), HasSubstr("may be 400 Hz, folded down"));
}

TEST(Spectrum, everySupplyThatExplainsALineIsNamed)
{
    // At 90 samples a second 50 Hz and 400 Hz both stand at 40 Hz.
    const auto both = spectrumOf(logWith({{400, 200}}, 90, 20000), {});
    ASSERT_TRUE(both && both->lines.size() == 1u);
    EXPECT_NEAR(both->lines[0].frequency_hz, 40, 0.1);
    EXPECT_EQ(both->lines[0].source.english(), "mains 50 Hz or aircraft supply 400 Hz");
    ASSERT_EQ(both->lines[0].sources.size(), 2u);
    EXPECT_EQ(both->lines[0].sources[1].aliasOf_hz, 400.0);
    EXPECT_THAT(together(both->warnings).english(), HasSubstr("may be 50, 400 Hz, folded down"));
    // A generator at 399 Hz, at 100 samples a second: a line of 1 Hz that looks like iron which drifts. At 380 Hz it is none.
    const auto slow = spectrumOf(logWith({{399, 100}}, 100, 40000), {});
    ASSERT_TRUE(slow && !slow->lines.empty());
    EXPECT_NEAR(slow->lines[0].frequency_hz, 1, 0.05);
    EXPECT_THAT(slow->lines[0].source.english(), HasSubstr("aircraft supply 400 Hz at 399"));
    EXPECT_NEAR(*slow->lines[0].aliasOf_hz, 399, 0.05);
    EXPECT_EQ(spectrumOf(logWith({{379, 100}}, 100, 40000), {})->lines[0].source.english(), "not known");
}

/// A minute of mains at 49.6 samples a second stands at 0.4 Hz, in the third bin of its segments, and looks like iron that drifts.
TEST(Spectrum, aSlowFoldedLineIsNamed)
{
    for (const double rate_hz : {49.6, 99.7, 24.9}) {
        const double folded_hz = aliasOf_hz(50, rate_hz);
        const auto spectrum = spectrumOf(logWith({{50, 100}}, rate_hz, static_cast<int>(60 * rate_hz)), {});
        ASSERT_TRUE(spectrum && spectrum->lines.size() == 1u) << rate_hz;
        EXPECT_NEAR(spectrum->lines[0].frequency_hz, folded_hz, 0.02) << rate_hz;
        EXPECT_NEAR(spectrum->lines[0].amplitude, 100, 15) << rate_hz;
        EXPECT_EQ(spectrum->lines[0].aliasOf_hz, 50.0) << rate_hz;
        EXPECT_THAT(together(spectrum->warnings).english(), HasSubstr("may be 50")) << rate_hz;
    }
    // What moves as slowly by itself has no name, and is no line: a sensor that is turned once in nine seconds.
    EXPECT_TRUE(spectrumOf(logWith({{0.11, 10000}}, 49.6, 2976), {})->lines.empty());
    // And noise has none there either.
    int lines = 0;
    for (int samples = 2000; samples < 6000; samples += 80)
        lines += spectrumOf(logWith({}, 49.6, samples), {.column = "by"})->lines.empty() ? 0 : 1;
    EXPECT_LE(lines, 1);
}

/// At half the sampling rate a wave is a column that goes up and down; what is seen of it hangs on where it is met.
TEST(Spectrum, aLineAtHalfTheSamplingRateIsSeen)
{
    for (const double rate_hz : {120.0, 100.0}) {
        const auto spectrum = spectrumOf(logWith({{rate_hz / 2, 300}}, rate_hz, 20000), {.column = "bx"});
        ASSERT_TRUE(spectrum && spectrum->lines.size() == 1u) << rate_hz;
        EXPECT_EQ(spectrum->lines[0].frequency_hz, rate_hz / 2);
        EXPECT_NEAR(spectrum->lines[0].amplitude, 300 * std::sin(0.3), 3);
        EXPECT_EQ(spectrum->lines[0].source.english(), rate_hz == 120 ? "mains 60 Hz" : "mains 50 Hz");
        EXPECT_THAT(together(spectrum->warnings).english(), HasSubstr("goes up and down by 8"));
    }
    for (unsigned samples = 4000; samples < 4040; ++samples)
        EXPECT_TRUE(spectrumOf(logWith({}, 100, static_cast<int>(samples)), {.column = "by"})->lines.empty());
    // A little below it is whole.
    const auto below = spectrumOf(logWith({{59.5, 300}}, 120, 20000), {.column = "bx"});
    ASSERT_EQ(below->lines.size(), 1u);
    EXPECT_NEAR(below->lines[0].amplitude, 300, 5);
}

/// Mains are not exactly 50 Hz, and a short log has wide bins but a line's place all the same.
TEST(Spectrum, aNameIsAsNearAsTheFrequencyIsKnown)
{
    const auto nameOf = [](double frequency_hz, double rate_hz, int samples = 20000, double amplitude = 150) {
        const auto spectrum = spectrumOf(logWith({{frequency_hz, amplitude}}, rate_hz, samples), {.column = "bx"});
        return spectrum->lines.empty() ? std::string("no line") : spectrum->lines[0].source.english();
    };
    for (const double mains_hz : {49.83, 49.9, 50.15, 50.0})
        EXPECT_EQ(nameOf(mains_hz, 200), "mains 50 Hz") << mains_hz;
    EXPECT_EQ(nameOf(59.93, 200), "mains 60 Hz");
    EXPECT_EQ(nameOf(50.1, 95), "mains 50 Hz");
    EXPECT_EQ(nameOf(50.1, 100), "mains 50 Hz");
    EXPECT_EQ(nameOf(49.6, 200), "perhaps mains 50 Hz at 49.6 Hz");
    EXPECT_EQ(nameOf(49.1, 200), "not known");
    EXPECT_EQ(nameOf(392, 1000, 50000), "perhaps aircraft supply 400 Hz at 392.0 Hz");
    EXPECT_THAT(nameOf(402, 200), HasSubstr("perhaps aircraft supply 400 Hz at 402"));
    // Three seconds: 115 Hz fold on 15.0 Hz, 2.7 Hz away, and the line is found to 0.1 Hz.
    EXPECT_EQ(nameOf(12.3, 100, 300), "not known");
    EXPECT_EQ(nameOf(115, 100, 300), "115 Hz");
    // On zero nothing tells below from above.
    EXPECT_EQ(nameOf(400.4, 100), "perhaps aircraft supply 400 Hz at 399.6 Hz or perhaps aircraft supply 400 Hz at 400.4 Hz");
}

TEST(Spectrum, aConstantHasNoLines)
{
    SensorLog log = logWith({}, 90, 20000);
    for (auto& axis : log.field)
        std::fill(axis.begin(), axis.end(), 18000.1);
    EXPECT_TRUE(spectrumOf(log, {.column = "bx"})->lines.empty());
}

TEST(Spectrum, whatFallsOnZeroIsWarnedOf)
{
    EXPECT_EQ(aliasOf_hz(400, 240), 80);
    EXPECT_EQ(aliasOf_hz(1200, 240), 0);
    EXPECT_EQ(aliasOf_hz(400, 100), 0);
    EXPECT_EQ(aliasOf_hz(400, 50), 0);
    EXPECT_EQ(suppliesOnZero_hz(240, 0.01), (std::vector<double>{1200}));
    EXPECT_EQ(suppliesOnZero_hz(100, 0.01), (std::vector<double>{300, 400, 1200, 2000}));
    EXPECT_THAT(warningOfZero(100, 0.01).english(), HasSubstr("400"));
    EXPECT_TRUE(warningOfZero(97, 0.01).empty());
    // Nearly on zero it looks like iron that drifts.
    EXPECT_THAT(warningOfSlow(49.6, 0.248).english(), HasSubstr("50 Hz fall on 0.40 Hz"));
    EXPECT_THAT(warningOfSlow(49.6, 0.248).english(), HasSubstr("hard iron that drifts"));
    EXPECT_TRUE(warningOfSlow(50, 0.25).empty()) << "on zero, and told so";
    EXPECT_TRUE(warningOfSlow(47, 0.235).empty());
    EXPECT_TRUE(warningOfSlow(240, 1.2).empty());
}

/// Mains that a light brings for a third of the log, far above its noise: whole periods of it, and not spikes.
TEST(Spectrum, aStrongLineIsNoRowOfSpikes)
{
    for (const double rate_hz : {240.0, 1000.0}) {
        SensorLog log = logWith({}, rate_hz, 16384, 2);
        for (std::size_t row = 8000; row < 12000; ++row)
            log.field[0][row] += 500 * std::sin(2 * kPi * 50 * log.time_s[row]);
        log.field[0][2000] += 400; // spikes all the same
        log.field[0][9000] += 4000;
        const LogQuality quality = qualityOf(log);
        EXPECT_LE(quality.of(SampleFault::Spike), 6) << rate_hz;
        EXPECT_EQ(quality.faults[2000], SampleFault::Spike) << rate_hz;
        EXPECT_EQ(quality.faults[9000], SampleFault::Spike) << rate_hz;
        const auto spectrum = spectrumOf(log, {.column = "bx"});
        ASSERT_TRUE(spectrum) << describe(spectrum.error());
        ASSERT_FALSE(spectrum->lines.empty());
        EXPECT_NEAR(spectrum->lines[0].frequency_hz, 50, 0.1);
        // A quarter of the log has it: in the mean of squares half of the amplitude.
        EXPECT_NEAR(spectrum->lines[0].amplitude, 500 * std::sqrt(4000.0 / 16384), 25) << rate_hz;
    }
}

/// A rotor that speeds up from 300 to 420 rev/min: its line is smeared over frequency, and sharp over its angle.
TEST(Spectrum, rotorOrdersAreTracked)
{
    SensorLog log = logWith({}, 240, 24000, 5);
    log.others.push_back({"rotor_rpm", {}});
    double turn = 0;
    for (std::size_t row = 0; row < log.size(); ++row) {
        const double rate = 5 + 2 * static_cast<double>(row) / static_cast<double>(log.size());
        log.others[0].values.push_back(60 * rate);
        turn += rate / 240;
        log.field[0][row] += 25 * std::sin(2 * kPi * 2 * turn);
    }
    const auto spectrum = spectrumOf(log, {.column = "bx", .tachometer = "rotor_rpm"});
    ASSERT_TRUE(spectrum) << describe(spectrum.error());
    ASSERT_FALSE(spectrum->lines.empty());
    EXPECT_EQ(spectrum->lines[0].source.english(), "rotor order 2");
    EXPECT_NEAR(spectrum->lines[0].amplitude, 25, 1.5);
    EXPECT_NEAR(spectrum->lines[0].frequency_hz, 12, 0.1);
}

/// A low-pass of first order with 3.5 ms takes 3.4 dB off 50 Hz; nine notches of Q 5 cost 1.5 ms.
TEST(Spectrum, filtersCostDelay)
{
    DelayFilter lowPass;
    lowPass.lowPass_hz = 1e3 / (2 * kPi * 3.5);
    EXPECT_NEAR(10 * std::log10(gainSquared(lowPass, 50)), -3.4, 0.05);
    DelayFilter notch;
    notch.notches_hz = {50};
    EXPECT_LT(gainSquared(notch, 50), 1e-12);
    double delay_ms = 0;
    for (const double supply : {50.0, 115.0, 400.0})
        for (const double order : {1.0, 3.0, 5.0})
            delay_ms += 1e3 / (2 * kPi * supply * order * 5);
    EXPECT_NEAR(delay_ms, 1.5, 0.05);

    const auto spectrum = spectrumOf(logWith({{50, 60}}, 1000, 30000, 2), {.column = "bx", .maxDelay_ms = 3.5});
    ASSERT_TRUE(spectrum && spectrum->filter);
    ASSERT_EQ(spectrum->filter->notches_hz.size(), 1u);
    EXPECT_NEAR(spectrum->filter->notches_hz[0], 50, 0.1);
    EXPECT_LE(spectrum->filter->delay_ms, 3.5 + 1e-9);
    EXPECT_LT(spectrum->filter->left_rms, 0.1 * spectrum->filter->before_rms);
}

TEST(Spectrum, gapsAreNotBridged)
{
    SensorLog log = logWith({{50, 30}}, 240, 8000);
    for (std::size_t row = 4000; row < log.size(); ++row)
        log.time_s[row] += 1.0;
    const auto spectrum = spectrumOf(log, {.column = "bx"});
    ASSERT_TRUE(spectrum);
    EXPECT_NEAR(spectrum->lines[0].amplitude, 30, 1);
    EXPECT_THAT(together(spectrum->warnings).english(), HasSubstr("gap"));
}

TEST(Spectrum, whatIsRefused)
{
    EXPECT_THAT(describe(spectrumOf(logWith({}, 240, 100), {.column = "current"}).error()), HasSubstr("has no column \"current\""));
    EXPECT_THAT(describe(spectrumOf(logWith({}, 240, 100), {.column = "bx", .segment = 512}).error()), HasSubstr("512 samples"));
    SensorLog log = logWith({}, 240, 100);
    log.time_s.clear();
    EXPECT_THAT(describe(spectrumOf(log, {}).error()), HasSubstr("has no time"));
}

} // namespace
} // namespace lubberline::test
