#include "core/deviation/FourierPlan.h"

#include <fftw3.h>

#include <map>

#include "core/base/FourierPlanner.h"

namespace lubberline {

namespace {

/// Only the execution of a plan is thread safe in FFTW; making one is not. FFTW_UNALIGNED lets it run on anybody's arrays;
/// FFTW_ESTIMATE leaves no chance to the moment, so that results are the same on every run.
fftw_plan planFor(int length)
{
    // Kept until the program ends, and never destroyed: plans without their map would be reported as leaks.
    static auto& plans = *new std::map<int, fftw_plan>;
    const std::lock_guard lock(fourierPlannerMutex());
    const auto [place, isNew] = plans.try_emplace(length, nullptr);
    if (isNew) {
        std::vector<double> in(static_cast<std::size_t>(length));
        std::vector<std::complex<double>> out(in.size() / 2 + 1);
        place->second = fftw_plan_dft_r2c_1d(
            length, in.data(), reinterpret_cast<fftw_complex*>(out.data()), FFTW_ESTIMATE | FFTW_UNALIGNED | FFTW_PRESERVE_INPUT);
    }
    return place->second;
}

} // namespace

std::vector<std::complex<double>> realTransform(const std::vector<double>& samples)
{
    std::vector<std::complex<double>> transformed(samples.size() / 2 + 1);
    fftw_execute_dft_r2c(planFor(static_cast<int>(samples.size())), const_cast<double*>(samples.data()),
        reinterpret_cast<fftw_complex*>(transformed.data()));
    return transformed;
}

} // namespace lubberline
