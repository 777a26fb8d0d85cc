// Coefficient files that are damaged in every way that would bend a compass silently.

#include <gtest/gtest.h>

#include <cmath>

#include "core/earth/FieldModel.h"
#include "tests/core/earth/FieldFiles.h"

namespace lubberline::test {
namespace {

void refused(const std::string& text, const char* words, std::int64_t line = -1)
{
    const CoefficientFile file(text);
    const auto model = readFieldModel(file.path());
    ASSERT_FALSE(model) << words;
    EXPECT_EQ(model.error().code, ErrorCode::Format) << model.error().message.english();
    EXPECT_EQ(model.error().file, file.path());
    EXPECT_NE(model.error().message.english().find(words), std::string::npos) << model.error().message.english();
    if (line >= 0) {
        EXPECT_EQ(model.error().line, line) << model.error().message.english();
    }
}

/// The text with one line replaced (or removed, when empty).
std::string withLine(const std::string& text, int number, const std::string& replacement)
{
    std::string result;
    std::size_t begin = 0;
    for (int i = 1; begin < text.size(); ++i) {
        const std::size_t end = text.find('\n', begin);
        result += i == number ? replacement : text.substr(begin, end - begin + 1);
        begin = end + 1;
    }
    return result;
}

TEST(FieldFile, damagedCof)
{
    const std::string good = wmm2020Cof();
    refused("", "empty");
    refused(std::string("\0\1\2", 3), "no text");
    refused(good.substr(0, good.find("99999")), "without its line of nines");
    refused(good.substr(0, good.size() / 2), "cut short");
    refused(withLine(good, 1, ""), "no header", 1);
    refused(withLine(good, 5, ""), "missing, doubled or out of order", 5);
    refused(withLine(good, 5,
                withLine(good, 5, "").substr(0, 0)
                    + "  2  1    2982.0   -2991.6      -7.0     -30.2\n  2  1    2982.0   -2991.6      -7.0     -30.2\n"),
        "out of order", 6);
    refused(withLine(good, 4, "  2  0   -2500.0       0.0     -11.5\n"), "cut short", 4);
    refused(withLine(good, 4, "  2  0   -2500.0       0.0     -11.5  x\n"), "\"x\" is not a number", 4);
    refused(withLine(good, 4, "  2  0   -2500.0       5.0     -11.5  0.0\n"), "order 0", 4);
    refused(withLine(good, 4, "  2.5  0   -2500.0       0.0     -11.5  0.0\n"), "no degree", 4);
    refused(withLine(good, 91, ""), "ends within degree 12", -1);
    refused(good.substr(0, good.find(" 12 12")), "within degree 12, before order 12");
    const std::string twoDegrees
        = "2025.0 TEST-2025 11/13/2024\n1 0 -29000 0 12 0\n1 1 -1400 4500 10 -20\n2 0 -2600 0 -11 0\n2 1 2900 -3100 -5 -27\n2 2 1600 -800 -8 -11\n";
    refused(twoDegrees, "without its line of nines behind degree 2: whether more degrees are missing cannot be told");
    refused("hello world\n", "not a number", 1);
}

TEST(FieldFile, missingFileAndFolder)
{
    EXPECT_EQ(readFieldModel("/none/such.cof").error().code, ErrorCode::Io);
    EXPECT_EQ(readFieldModel("/tmp").error().code, ErrorCode::Io);
    EXPECT_FALSE(fieldModelByName("wmm1999"));
    EXPECT_EQ(fieldModelByName("WMM-2025")->name(), "WMM2025");
    EXPECT_EQ(fieldModelByName("igrf14")->name(), "IGRF-14");
}

/// A table of two epochs and degree 2 in IGRF's form: half-way between them the field is the mean.
const std::string kSmallIgrf = "# comment\n"
                               "c/s deg ord IGRF IGRF SV\n"
                               "g/h n m 2020.0 2025.0 2025-30\n"
                               "g 1 0 -29400 -29350 12\n"
                               "g 1 1 -1450 -1410 10\n"
                               "h 1 1 4650 4545 -21\n"
                               "g 2 0 -2500 -2556 -11\n"
                               "g 2 1 2980 2950 -5\n"
                               "h 2 1 -2990 -3130 -27\n"
                               "g 2 2 1677 1649 -2\n"
                               "h 2 2 -734 -815 -11\n";

TEST(FieldFile, igrfTable)
{
    const CoefficientFile file(kSmallIgrf);
    const auto model = readFieldModel(file.path());
    ASSERT_TRUE(model) << model.error().message.english();
    EXPECT_EQ(model->firstYear(), 2020.0);
    EXPECT_EQ(model->lastYear(), 2030.0);
    EXPECT_EQ(model->degree(), 2);
    const auto place = *makePlace(52, 21);
    const auto a = model->evaluate(place, 2020)->field, b = model->evaluate(place, 2025)->field,
               middle = model->evaluate(place, 2022.5)->field;
    EXPECT_NEAR(middle.north_nT, (a.north_nT + b.north_nT) / 2, 1e-6);
    EXPECT_NEAR(middle.east_nT, (a.east_nT + b.east_nT) / 2, 1e-6);
}

/// Whatever saved it: line ends of three systems, a byte order mark; what is no UTF-8 is told.
TEST(FieldFile, isReadAsEditorsSaveIt)
{
    const std::string good = wmm2020Cof();
    const CoefficientFile plain(good);
    const auto place = *makePlace(52, 21);
    const double expected_nT = readFieldModel(plain.path())->evaluate(place, 2022)->field.north_nT;
    std::string old, windows = "\xEF\xBB\xBF", utf16;
    for (const char c : good) {
        old += c == '\n' ? '\r' : c;
        windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
        utf16 += {c, '\0'};
    }
    for (const auto& text : {old, windows}) {
        const CoefficientFile file(text);
        const auto model = readFieldModel(file.path());
        ASSERT_TRUE(model) << model.error().message.english();
        EXPECT_EQ(model->evaluate(place, 2022)->field.north_nT, expected_nT);
    }
    refused(utf16, "UTF-16 without");
    refused("\xFF\xFE" + utf16, "is UTF-16");
}

/// Without its column of the change a table is good up to its last epoch, and says no more.
TEST(FieldFile, igrfTableWithoutItsColumnOfTheChange)
{
    std::string text;
    for (const std::string line :
        {"c/s deg ord IGRF IGRF", "g/h n m 2020.0 2025.0", "g 1 0 -29400 -29350", "g 1 1 -1450 -1410", "h 1 1 4650 4545"})
        text += line + "\n";
    const CoefficientFile file(text);
    const auto model = readFieldModel(file.path());
    ASSERT_TRUE(model) << model.error().message.english();
    EXPECT_EQ(model->firstYear(), 2020.0);
    EXPECT_EQ(model->lastYear(), 2025.0);
    const auto place = *makePlace(0, 0); // X = −g10, Y = −h11 times (a/r)³, but for the flattening
    const auto first = model->evaluate(place, 2020)->field, last = model->evaluate(place, 2025)->field;
    EXPECT_NEAR(last.north_nT / first.north_nT, 29350.0 / 29400.0, 1e-9);
    EXPECT_NEAR(last.east_nT / first.east_nT, 4545.0 / 4650.0, 1e-9);
    EXPECT_NEAR(model->evaluate(place, 2024)->rate.north_nT / first.north_nT, -10.0 / 29400.0, 1e-9);
    EXPECT_FALSE(model->evaluate(place, 2025.5));
    refused("c/s deg ord IGRF\ng/h n m 2025.0\ng 1 0 -29350\ng 1 1 -1410\nh 1 1 4545\n", "no column of the yearly change", 2);
}

TEST(FieldFile, damagedIgrf)
{
    refused(withLine(kSmallIgrf, 3, ""), "no header");
    refused(withLine(kSmallIgrf, 6, ""), "where h of degree 1 order 1", 6);
    refused(withLine(kSmallIgrf, 5, "g 1 2 -1450 -1410 10\n"), "out of order", 5);
    refused(withLine(kSmallIgrf, 5, "g 1 1 -1450 -1410\n"), "where the header has 6", 5);
    refused(withLine(kSmallIgrf, 5, "g 1 1 -1450 twelve 10\n"), "not a number", 5);
    refused(withLine(kSmallIgrf, 11, ""), "ends within degree 2");
    refused(withLine(kSmallIgrf, 3, "g/h n m 2020.0 2024.0 2024-29\n"), "five years", 3);
}

/// A model reads nothing but the file that it is given: it is made where there is no folder for temporary files.
TEST(FieldFile, builtInModelsNeedNoFiles)
{
    EXPECT_EQ(wmm2025().degree(), 12);
    EXPECT_EQ(igrf14().degree(), 13);
}

/// Degrees far above those of the built-in models: the roots that GeographicLib's sums need are there.
TEST(FieldFile, highDegrees)
{
    constexpr int kDegree = 133; // of WMMHR
    std::string text = "2025.0 HIGH 1/1/2025\n";
    for (int n = 1; n <= kDegree; ++n)
        for (int m = 0; m <= n; ++m)
            text += std::to_string(n) + " " + std::to_string(m) + (n == 1 && m == 0 ? " -30000 0 10 0\n" : " 0 0 0 0\n");
    const CoefficientFile file(text + std::string(48, '9') + "\n");
    const auto model = readFieldModel(file.path());
    ASSERT_TRUE(model) << model.error().message.english();
    EXPECT_EQ(model->degree(), kDegree);
    // A dipole along the axis: at the geographic equator H = −g (a/r)³, Z = 0.
    const auto answer = model->evaluate(*makePlace(0, 33), 2027);
    EXPECT_NEAR(answer->field.north_nT, 29980.0 * std::pow(6371.2 / 6378.137, 3), 1e-6);
    EXPECT_NEAR(answer->field.down_nT, 0.0, 1e-9);
    EXPECT_NEAR(answer->rate.north_nT, -10.0 * std::pow(6371.2 / 6378.137, 3), 1e-9);
}

} // namespace
} // namespace lubberline::test
