#include "core/base/Number.h"
#include "core/calibration/AttitudeParts.h"

namespace lubberline {

namespace {

std::string regressorName(const SensorLog& log, Eigen::Index regressor, Eigen::Index axis)
{
    constexpr std::array<const char*, 12> kNames{"a", "b", "c", "P", "d", "e", "f", "Q", "g", "h", "k", "R"};
    if (regressor < 4)
        return kNames[static_cast<std::size_t>(axis * 4 + regressor)];
    constexpr std::array<char, 3> kAxes{'S', 'T', 'V'};
    return log.currents[static_cast<std::size_t>(regressor - 4)].name + " " + kAxes[static_cast<std::size_t>(axis)];
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

} // namespace

Message inWords(const SensorLog& log, const Eigen::VectorXd& direction, double total_nT)
{
    std::vector<Eigen::Index> involved;
    for (Eigen::Index i = 0; i < direction.size(); ++i)
        if (std::abs(direction[i]) > 1e-2)
            involved.push_back(i);
    std::vector<std::string> names;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::vector<std::string> together;
        for (const auto i : involved)
            together.push_back(regressorName(log, i, axis));
        names.push_back(together.size() == 1 ? together[0]
                : together.size() == 2       ? together[0] + " and " + together[1]
                                             : "(" + listed(together) + ")");
    }
    if (involved.size() == 1)
        return involved[0] < 3 ? Message{MARKED("core", "%1 cannot be told: the field along %2 is never other than 0 in this log"),
                   listed(names), "xyz"[involved[0]]}
                               : Message{MARKED("core", "%1 cannot be told: the current is never other than 0 in this log"), listed(names)};
    if (involved.size() == 2 && involved[1] == 3 && involved[0] < 3) {
        // The direction is (1, v) in (F s, p): what stays is p − v F s, and −v F is the constant field.
        std::vector<std::string> sums;
        const std::string factor = figureText(-direction[3] * total_nT, 0);
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            sums.push_back(regressorName(log, involved[0], axis) + " \u00B7 " + factor + " nT + " + regressorName(log, 3, axis));
        return {MARKED("core", "%1 cannot be told apart, as the field along %2 is always the same: only %3 is known"), listed(names),
            "xyz"[involved[0]], listed(sums)};
    }
    return {MARKED("core", "%1 cannot be told apart: in this log what they do always goes together"), listed(names)};
}

void describeAttitudeParameters(AttitudeResult& result, const SensorLog& log, const Regression& fit, double total_nT, double variance)
{
    const auto scales = currentScales(log);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        for (Eigen::Index i = 0; i < fit.solution.rows(); ++i) {
            const double factor = i < 3 ? 1.0 : i == 3 ? total_nT : total_nT / scales[static_cast<std::size_t>(i - 4)];
            FittedParameter parameter{regressorName(log, i, axis), {}, {}, i < 3 ? "1" : i == 3 ? "nT" : "nT/A"};
            if (fit.told[static_cast<std::size_t>(i)]) {
                parameter.value = factor * fit.solution(i, axis);
                parameter.standard_error = factor * std::sqrt(std::max(0.0, variance * fit.covariance(i, i)));
            }
            result.parameters.push_back(std::move(parameter));
        }
}

} // namespace lubberline
