#include <gmock/gmock.h>

#include "core/record/SharedErrors.h"

namespace lubberline {
namespace {

using Errors = std::array<double, 5>;

TEST(SharedErrors, areReadAsPeopleWriteThem)
{
    EXPECT_EQ(readSharedErrors("0.6")->of_deg, (Errors{0.6, 0, 0, 0, 0}));
    EXPECT_EQ(readSharedErrors(" 0,6° ")->of_deg, (Errors{0.6, 0, 0, 0, 0}));
    EXPECT_EQ(readSharedErrors("A 0.6 B 0.2")->of_deg, (Errors{0.6, 0.2, 0, 0, 0}));
    EXPECT_EQ(readSharedErrors("B 0.2°, C 1; E 0.05")->of_deg, (Errors{0, 0.2, 1, 0, 0.05}));
    EXPECT_FALSE(readSharedErrors("")->any());
    EXPECT_FALSE(readSharedErrors("0")->any());
}

TEST(SharedErrors, whatIsNoneIsRefused)
{
    for (const char* text : {"A", "0.6 0.2", "A 0.6 A 0.2", "F 1", "A -0.1", "A 181", "A B 1", "north", "A 1 2", "A 0.6x"})
        EXPECT_FALSE(readSharedErrors(text)) << text;
    EXPECT_THAT(readSharedErrors("north").error().message.english(), testing::HasSubstr("as in A 0.6 B 0.2"));
}

TEST(SharedErrors, readBackAsTheyWereWritten)
{
    for (const Errors& each : {Errors{0.6, 0, 0, 0, 0}, Errors{0, 0.1234, 7, 0, 1e-4}, Errors{}}) {
        const SharedErrors errors{each};
        EXPECT_EQ(*readSharedErrors(textOf(errors)), errors) << textOf(errors);
    }
    EXPECT_EQ(textOf({{0.6, 0.2, 0, 0, 0}}), "A 0.6 B 0.2");
}

} // namespace
} // namespace lubberline
