// The C header is compiled and run.
#include "core/calibration/ModelHeader.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace lubberline::test {
namespace {

SensorModel model()
{
    SensorModel made;
    made.softIron << 0.05, 0.02, -0.01, 0.01, -0.04, 0.015, -0.02, 0.005, 0.03;
    made.hardIron_nT = {3000, -2000, 1500};
    made.misalignment.yaw_rad = 0.02;
    return made;
}

/// The exit status of a C program that is the header and `body`.
int runC(const std::string& header, const std::string& body)
{
    const auto folder = std::filesystem::temp_directory_path() / ("lubberline_header_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "model.h") << header;
    std::ofstream(folder / "main.c") << "#include \"model.h\"\n#include <stdio.h>\nint main(void) {" << body << "}\n";
    const std::string program = (folder / "program").string();
    const std::string compile = std::string(LUBBERLINE_COMPILER) + " -x c -std=c99 -Wall -Wextra -Werror -Wno-unused-function "
        + (folder / "main.c").string() + " -o " + program + " -lm";
    EXPECT_EQ(std::system(compile.c_str()), 0);
    const int status = std::system(program.c_str());
    std::filesystem::remove_all(folder);
    return status;
}

TEST(ModelHeader, compilesAndAgrees)
{
    const auto header = writeModelHeader(model(), "nT", "made */ of \n a test");
    ASSERT_TRUE(header);
    EXPECT_EQ(runC(*header, "return lubberline_self_test();"), 0);
    // A vector of our own: what the sensor reads in (20000, 5000, 30000).
    const SensorResponse response = responseOf(model());
    const Eigen::Vector3d read = response.gain * Eigen::Vector3d(20000, 5000, 30000) + response.offset_nT;
    char body[512];
    std::snprintf(body, sizeof body,
        "double m[3] = {%.9f, %.9f, %.9f}, f[3]; lubberline_field(m, f);"
        "return !(fabs(f[0] - 20000) < 1e-3 && fabs(f[1] - 5000) < 1e-3 && fabs(f[2] - 30000) < 1e-3"
        " && fabs(lubberline_heading_deg(f, 0, 0) - 345.963757) < 1e-5);",
        read.x(), read.y(), read.z());
    EXPECT_EQ(runC(*header, body), 0);
}

TEST(ModelHeader, aDamagedCopyFailsItsTest)
{
    std::string header = *writeModelHeader(model(), "nT", "");
    const auto at = header.find("lubberline_offset[3] = {") + 24;
    header.replace(at, 1, header[at] == '9' ? "8" : "9");
    EXPECT_NE(runC(header, "return lubberline_self_test();"), 0);
}

TEST(ModelHeader, whatHasNoInverseIsRefused)
{
    SensorModel flat;
    flat.softIron(0, 0) = -1;
    const auto header = writeModelHeader(flat, "nT", "");
    ASSERT_FALSE(header);
    EXPECT_THAT(describe(header.error()), testing::HasSubstr("no inverse"));
}

} // namespace
} // namespace lubberline::test
