// The quick reader of figures reads what from_chars reads, to the last bit, and nothing else.

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "core/base/Number.h"
#include "core/base/PlainNumber.h"

namespace lubberline {
namespace {

TEST(PlainNumber, isWhatFromCharsReads)
{
    std::mt19937_64 random(3);
    for (int i = 0; i < 20'000; ++i) {
        const int whole = static_cast<int>(random() % 13), decimals = static_cast<int>(random() % 9);
        std::string text = random() % 3 == 0 ? "-" : "";
        for (int k = 0; k <= whole; ++k)
            text += static_cast<char>('0' + random() % 10);
        if (decimals > 0)
            text += '.';
        for (int k = 0; k < decimals; ++k)
            text += static_cast<char>('0' + random() % 10);
        double expected = 0, value = 0;
        ASSERT_EQ(std::from_chars(text.data(), text.data() + text.size(), expected).ec, std::errc());
        ASSERT_TRUE(takePlainNumber(text, value)) << text;
        ASSERT_EQ(std::memcmp(&value, &expected, sizeof value), 0) << text;
    }
    for (const std::string text : {"1e3", "-2.5E-7", "123456789012345678", "0.1234567890123456789", ".5"}) {
        double expected = 0, value = 0;
        const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), expected);
        ASSERT_TRUE(fault == std::errc() && end == text.data() + text.size());
        ASSERT_TRUE(takePlainNumber(text, value)) << text;
        EXPECT_EQ(value, expected) << text;
    }
    double value = 0;
    EXPECT_TRUE(takePlainNumber("-0", value) && std::signbit(value));
}

TEST(PlainNumber, leavesTheRestToTheReaderOfNumbers)
{
    double value = 0;
    for (const std::string text : {"", "-", ".", "-.", "1,5", "+1", " 1", "1 ", "nan", "inf", "1e999", "0x10", "1.2.3", "--1"})
        EXPECT_FALSE(takePlainNumber(text, value)) << text;
}

} // namespace
} // namespace lubberline
