/// Sign convention and methods in words, so that whoever holds the paper can work the figures again.

#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

namespace {

QString pointRuleWords(const Analysis& analysis)
{
    if (!analysis.pointRules)
        return Words::tr("none: a cardinal point has no reading near enough.");
    const QString argument
        = analysis.pointRules->argument == HeadingArgument::Magnetic ? Words::tr("magnetic") : Words::tr("compass", "heading");
    if (analysis.pointRules->points == 4) {
        return Words::tr("from the readings nearest to N, E, S, W by %1 heading: A mean of the four, B = (E − W)/2, C = (N − S)/2, "
                         "E = ((N + S) − (E + W))/4; D cannot be told.")
            .arg(argument);
    }
    return Words::tr("from the readings nearest to the eight points by %1 heading: A mean of the eight, B = (E − W)/2, C = (N − S)/2, "
                     "D = ((NE + SW) − (SE + NW))/4, E = ((N + S) − (E + W))/4.")
        .arg(argument);
}

QString errorWords(const Analysis& analysis)
{
    const auto& fit = analysis.approximate;
    if (!fit.fitted())
        return Words::tr("there is no fit, and no errors of it.");
    const QString looked
        = Words::tr("Suspect: a slip of reading or writing is likely, by Bayes' rule over the usual slips; a suspect reading "
                    "stays in use until somebody excludes it with a reason. t is the externally studentised residual.");
    if (!fit.intervalFactor)
        return Words::tr(
                   "the standard errors are those of the smallest division alone: there are no more readings than coefficients, and no "
                   "interval can be given.")
            + ' ' + looked;
    return Words::tr(
               "standard errors are of the scatter about the fit, and never less than the smallest division leaves. 95 % ± is the half "
               "width of the interval that holds the true value 95 times in 100: %1 standard errors (Student).")
               .arg(figure(*fit.intervalFactor, 2))
        + ' '
        + (analysis.shared.any()
                ? Words::tr("Errors that all readings share are in them (%1, in degrees), and in the intervals with 1.96 of theirs: they "
                            "are stated, not estimated from the scatter.")
                      .arg(printable(textOf(analysis.shared)))
                : Words::tr("Errors that all readings share (datum, variation) are not stated and not in them."))
        + ' ' + looked;
}

QString spectrumWords(const Harmonics& harmonics)
{
    const QString method = harmonics.method == HarmonicsMethod::Fft ? Words::tr("fast Fourier transform of equally spaced headings")
                                                                    : Words::tr("least squares on headings that are not equally spaced");
    return Words::tr("harmonics of deviation against magnetic heading by %1, up to order %2, which is what these headings resolve.")
        .arg(method)
        .arg(harmonics.highestResolvable);
}

} // namespace

std::vector<Fact> methodWords(const Analysis& analysis)
{
    const QString heading = analysis.approximate.index_rad == 0.0
        ? Words::tr("ψ′ is the compass heading")
        : Words::tr("ψ′ is the compass heading with its index of %1°").arg(signedFigure(toDegrees(analysis.approximate.index_rad), 0));
    return {
        {Words::tr("Sign"),
            Words::tr("Deviation = magnetic heading − compass heading; easterly is positive: the compass reads low, and deviation is "
                      "added to what it reads to get magnetic heading.")},
        {Words::tr("Approximate"),
            Words::tr("least squares of δ = A + B sin ψ′ + C cos ψ′ + D sin 2ψ′ + E cos 2ψ′; %1, A to E are angles. "
                      "Residual = deviation read − deviation fitted.")
                .arg(heading)},
        {Words::tr("Exact"),
            Words::tr("tan δ = (A + B sin ψ + C cos ψ + D sin 2ψ + E cos 2ψ) / (1 + B cos ψ − C sin ψ + D cos 2ψ − E sin 2ψ), multiplied "
                      "out and fitted by linear least squares; ψ is the magnetic heading, A to E have no unit.")},
        {Words::tr("Point rules"), pointRuleWords(analysis)},
        {Words::tr("Errors"), errorWords(analysis)},
        {Words::tr("Spectrum"), spectrumWords(analysis.harmonics)},
    };
}

} // namespace lubberline::ui
