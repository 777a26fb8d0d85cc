#include "core/calibration/ModelHeader.h"

#include <Eigen/Core>
#include <array>

#include "core/algebra/Solve.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

std::string rowOf(std::initializer_list<double> values)
{
    std::string row;
    for (const double value : values)
        row += (row.empty() ? "{" : ", ") + shortestNumber(value);
    return row + "}";
}

/// Nothing of a note can end the comment that it stands in.
std::string commentText(std::string_view note)
{
    std::string text(note);
    for (char& c : text)
        if (c == '\n' || c == '\r' || c == '*' || c == '\\' || c == '?')
            c = ' ';
    return text;
}

struct TestVector {
    Eigen::Vector3d measured;
    double pitch_deg, roll_deg;
};

constexpr std::string_view kFunctions = R"(
/* The field at the sensor without the aircraft's own, in the unit of the measurement. */
static inline void lubberline_field(const double measured[3], double field[3])
{
    int i, j;
    for (i = 0; i < 3; ++i) {
        field[i] = 0.0;
        for (j = 0; j < 3; ++j)
            field[i] += lubberline_matrix[i][j] * (measured[j] - lubberline_offset[j]);
    }
}

/* Magnetic heading in degrees, 0 to 360, of a field in body axes at an attitude in degrees (nose up and starboard wing down positive). */
static inline double lubberline_heading_deg(const double field[3], double pitch_deg, double roll_deg)
{
    const double degree = 0.017453292519943295;
    const double sp = sin(pitch_deg * degree), cp = cos(pitch_deg * degree), sr = sin(roll_deg * degree), cr = cos(roll_deg * degree);
    const double heading = atan2(field[2] * sr - field[1] * cr, field[0] * cp + field[1] * sp * sr + field[2] * sp * cr) / degree;
    return heading < 0.0 ? heading + 360.0 : heading;
}

/* 0 when this code gives what the calibration program computed; else the number of the first test vector that differs. */
static inline int lubberline_self_test(void)
{
    int i, k;
    for (i = 0; i < LUBBERLINE_TEST_VECTORS; ++i) {
        double field[3], turn;
        lubberline_field(lubberline_test_measured[i], field);
        for (k = 0; k < 3; ++k)
            if (!(fabs(field[k] - lubberline_test_field[i][k]) <= 0.01))
                return i + 1;
        turn = lubberline_heading_deg(field, lubberline_test_attitude_deg[i][0], lubberline_test_attitude_deg[i][1]) - lubberline_test_heading_deg[i];
        if (!(fabs(turn - 360.0 * floor(turn / 360.0 + 0.5)) <= 0.001))
            return i + 1;
    }
    return 0;
}

#endif
)";

} // namespace

Result<FieldCompensator> compensatorOf(const SensorModel& model)
{
    const SensorResponse response = responseOf(model);
    const auto inverse = solveSquare(response.gain, Eigen::Matrix3d::Identity());
    if (!response.gain.allFinite() || !response.offset_nT.allFinite() || !inverse)
        return Error{ErrorCode::Numeric, MARKED("core", "the model's soft iron cannot be taken out: 1 + S has no inverse")};
    return FieldCompensator{*inverse, response.offset_nT};
}

double headingOf_deg(const Eigen::Vector3d& field, double pitch_deg, double roll_deg)
{
    const double sp = std::sin(toRadians(pitch_deg)), cp = std::cos(toRadians(pitch_deg));
    const double sr = std::sin(toRadians(roll_deg)), cr = std::cos(toRadians(roll_deg));
    return wrap360(toDegrees(std::atan2(field.z() * sr - field.y() * cr, field.x() * cp + field.y() * sp * sr + field.z() * sp * cr)));
}

Result<std::string> writeModelHeader(const SensorModel& model, std::string_view unit, std::string_view note)
{
    const auto compensator = compensatorOf(model);
    if (!compensator)
        return compensator.error();
    const auto& m = compensator->matrix;
    const auto& o = compensator->offset;
    std::string text = "/* Compensation of a magnetic sensor, body axes x forward, y starboard, z down; field in " + std::string(unit)
        + ".\n   field = matrix (measured - offset). Made by Lubberline; lubberline_self_test() checks this copy. */\n";
    if (!note.empty())
        text += "/* " + commentText(note) + " */\n";
    text += "#ifndef LUBBERLINE_SENSOR_MODEL_H\n#define LUBBERLINE_SENSOR_MODEL_H\n\n#include <math.h>\n\n";
    text += "static const double lubberline_matrix[3][3] = {" + rowOf({m(0, 0), m(0, 1), m(0, 2)}) + ",\n    "
        + rowOf({m(1, 0), m(1, 1), m(1, 2)}) + ",\n    " + rowOf({m(2, 0), m(2, 1), m(2, 2)}) + "};\n";
    text += "static const double lubberline_offset[3] = " + rowOf({o[0], o[1], o[2]}) + ";\n\n";

    const double size = unit == "nT" ? 40000.0 : std::max(1.0, 3.0 * o.norm());
    const std::array<TestVector, 5> vectors{{{{size, 0, 0}, 0, 0}, {{0, size, 0}, 0, 0}, {{0, 0, size}, 10, -5},
        {{-0.5 * size, 0.4 * size, 0.7 * size}, -20, 15}, {{0.3 * size, -0.6 * size, -0.5 * size}, 5, 60}}};
    std::string measured, fields, attitudes, headings;
    for (const auto& vector : vectors) {
        const Eigen::Vector3d field = compensator->field(vector.measured);
        measured += (measured.empty() ? "" : ",\n    ") + rowOf({vector.measured[0], vector.measured[1], vector.measured[2]});
        fields += (fields.empty() ? "" : ",\n    ") + rowOf({field[0], field[1], field[2]});
        attitudes += (attitudes.empty() ? "" : ", ") + rowOf({vector.pitch_deg, vector.roll_deg});
        headings += (headings.empty() ? "" : ", ") + shortestNumber(headingOf_deg(field, vector.pitch_deg, vector.roll_deg));
    }
    text += "#define LUBBERLINE_TEST_VECTORS 5\n";
    text += "static const double lubberline_test_measured[LUBBERLINE_TEST_VECTORS][3] = {" + measured + "};\n";
    text += "static const double lubberline_test_field[LUBBERLINE_TEST_VECTORS][3] = {" + fields + "};\n";
    text += "static const double lubberline_test_attitude_deg[LUBBERLINE_TEST_VECTORS][2] = {" + attitudes + "};\n";
    text += "static const double lubberline_test_heading_deg[LUBBERLINE_TEST_VECTORS] = {" + headings + "};\n";
    return text.append(kFunctions);
}

} // namespace lubberline
