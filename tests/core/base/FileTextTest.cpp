// The small parts that the formats stand on: numbers, UTF-8, dates, rows.

#include <gmock/gmock.h>

#include <clocale>
#include <limits>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/format/csv/RowSplitter.h"
#include "core/record/RecordWords.h"

namespace lubberline::test {

TEST(Number, readsWhatIsOne)
{
    EXPECT_EQ(readNumber("3.5").value, 3.5);
    EXPECT_EQ(readNumber("+3.5").value, 3.5);
    EXPECT_EQ(readNumber("-3.5").value, -3.5);
    EXPECT_EQ(readNumber("\u22123.5").value, -3.5);
    EXPECT_EQ(readNumber("1e2").value, 100.0);
    EXPECT_EQ(readNumber("3,5", true).value, 3.5);
    EXPECT_EQ(readNumber("3.5", true).value, 3.5);
}

TEST(Number, refusesWhatIsNone)
{
    for (const char* text :
        {"", " 3", "3 ", "3,5", "a", "nan", "NaN", "inf", "-inf", "infinity", "0x10", "1.2.3", "--1", "+-1", "-+1", "1e", "e5", ".", "-"})
        EXPECT_EQ(readNumber(text).fault, NumberFault::NotANumber) << text;
    for (const char* text : {"1.234,5", "1,2,3", ",", "1,5e400x"})
        EXPECT_EQ(readNumber(text, true).fault, NumberFault::NotANumber) << text;
    for (const char* text : {"1e400", "-1e400", "1e-400"})
        EXPECT_EQ(readNumber(text).fault, NumberFault::OutOfRange) << text;
}

TEST(Number, takesEveryMinusThatIsTyped)
{
    for (const char* text : {"-3.5", "\u22123.5", "\u20133.5", "\u20103.5", "\u20113.5", "\u20123.5"})
        EXPECT_EQ(readNumber(text).value, -3.5) << text;
    for (const char* text : {"\u2212-3", "-\u22123", "\u20143", "1e\u22122"}) // U+2014 is a dash between words
        EXPECT_EQ(readNumber(text).fault, NumberFault::NotANumber) << text;
}

TEST(Number, takesThousandsApartOnlyWhereTheyAre)
{
    EXPECT_EQ(readNumber("1\u00A0234.5").value, 1234.5);
    EXPECT_EQ(readNumber("\u221212\u202F345\u202F678,5", true).value, -12345678.5);
    EXPECT_EQ(readNumber("123\u2009456").value, 123456.0);
    for (const char* text :
        {"1\u00A023", "1234\u00A0567", "1\u00A0234\u202F567", "1\u00A02345", "\u00A0123", "123\u00A0", "1.5\u00A0000", "1 234"})
        EXPECT_EQ(readNumber(text).fault, NumberFault::NotANumber) << text;
}

TEST(Number, isShownWithItsSign)
{
    EXPECT_EQ(signedFigureText(3.46, 1), "+3.5");
    EXPECT_EQ(signedFigureText(-2.0, 1), "\u22122.0");
    EXPECT_EQ(signedFigureText(-0.04, 1), "0.0");
    EXPECT_EQ(signedFigureText(0.04, 1), "0.0");
    EXPECT_EQ(figureText(-2.0, 0), "\u22122");
    EXPECT_EQ(figureText(3.5, 2), "3.50");
    EXPECT_EQ(figureText(-0.0, 1), "0.0");
}

TEST(Number, isWrittenShortAndReadsBackToTheBit)
{
    EXPECT_EQ(shortestNumber(359), "359");
    EXPECT_EQ(shortestNumber(0.1), "0.1");
    EXPECT_EQ(shortestNumber(-0.0), "0");
    for (const double value : {0.1 + 0.2, 1.0 / 3, 359.99999999999994, 1e-300, 6.02e23, std::numeric_limits<double>::denorm_min()})
        EXPECT_EQ(readNumber(shortestNumber(value)).value, value);
}

TEST(Number, doesNotCareForTheLocale)
{
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* german : {"de_DE.UTF-8", "pl_PL.UTF-8", ""}) // those that the machine has
        if (std::setlocale(LC_ALL, german)) {
            EXPECT_EQ(readNumber("3.5").value, 3.5);
            EXPECT_EQ(shortestNumber(3.5), "3.5");
        }
    std::setlocale(LC_ALL, before.c_str());
}

TEST(Utf8, isToldFromOtherBytes)
{
    for (const char* text : {"", "plain", "\u00B0 \u2212 \U0001F9ED", "\xEF\xBF\xBF"})
        EXPECT_TRUE(isUtf8(text)) << text;
    // lone continuation, cut short, overlong, surrogate, beyond U+10FFFF, Latin-1
    for (const char* text :
        {"\x80", "\xE2\x82", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "3\xB0"})
        EXPECT_FALSE(isUtf8(text)) << text;
}

TEST(Quotes, nameWhatTheEyeCannotSee)
{
    EXPECT_EQ(inQuotes("a\tb\x1b"), "\"a[U+0009]b[U+001B]\"");
    EXPECT_EQ(inQuotes("358\u200B"), "\"358[U+200B]\"");
    EXPECT_EQ(inQuotes("1\u00A02\u202F3\uFEFF\U000E0041"), "\"1[U+00A0]2[U+202F]3[U+FEFF][U+E0041]\"");
    EXPECT_EQ(inQuotes("\u0141\u00F3d\u017A, 3\u00B015\u2032"), "\"\u0141\u00F3d\u017A, 3\u00B015\u2032\"");
    EXPECT_EQ(inQuotes("3\xB0"), "\"3[0xB0]\"");
    // Of figures, too, what looks like ours: a Cyrillic letter, a full-width digit; not the accent of a Latin one.
    EXPECT_EQ(figuresInQuotes("3 \u0415"), "\"3 \u0415[U+0415]\"");
    EXPECT_EQ(figuresInQuotes("\uFF13"), "\"\uFF13[U+FF13]\"");
    EXPECT_EQ(figuresInQuotes("\u22123\u00B0 S\u00FCd \u2032"), "\"\u22123\u00B0 S\u00FCd \u2032\"");
    EXPECT_EQ(inQuotes("3 \u0415"), "\"3 \u0415\"");
}

TEST(Spaces, areThoseOfSpreadsheetsToo)
{
    EXPECT_EQ(trimmed(" \t\u00A0 358\u202F\u2009 \u3000"), "358");
    EXPECT_EQ(trimmed("\u00A0\u202F"), "");
    EXPECT_EQ(trimmed("a\u00A0b"), "a\u00A0b");
    EXPECT_EQ(trimmed("\u200B3\u200B"), "\u200B3\u200B"); // no space: it is told, not passed over
    EXPECT_EQ(trimmed("\u0142"), "\u0142");
}

TEST(Encoding, isToldFromTheBeginningOfAFile)
{
    const std::string text = "# site: \xC5\x81\xC3\xB3"
                             "d\xC5\xBA\n0,358\n";
    EXPECT_TRUE(otherEncoding(text).empty());
    EXPECT_TRUE(otherEncoding("").empty());
    EXPECT_TRUE(otherEncoding(std::string("\x7f"
                                          "ELF\x02\x01\0\0",
                                  8))
                    .empty());
    std::string little, big;
    for (const char c : std::string("magnetic_heading_deg\t"))
        little += {c, '\0'}, big += {'\0', c};
    for (const auto& utf16 : {little, big})
        EXPECT_THAT(otherEncoding(utf16).english(), testing::AllOf(testing::HasSubstr("UTF-16 without"), testing::HasSubstr("CSV UTF-8")));
    EXPECT_THAT(otherEncoding("\xFF\xFE" + little).english(), testing::StartsWith("is UTF-16; expected UTF-8"));
    EXPECT_THAT(otherEncoding("\xFE\xFF" + big).english(), testing::StartsWith("is UTF-16; expected UTF-8"));
    EXPECT_THAT(otherEncoding("PK\x03\x04 and more").english(), testing::StartsWith("is a workbook"));
    EXPECT_THAT(otherEncoding("\xD0\xCF\x11\xE0 and more").english(), testing::StartsWith("is a workbook"));
    EXPECT_THAT(otherEncoding(std::string("\xFF\xFE\0\0m\0\0\0", 8)).english(), testing::StartsWith("is UTF-32"));
}

TEST(Encoding, ofACodePageIsToldByItsFirstByte)
{
    EXPECT_TRUE(notUtf8("\xC5\x81\xC3\xB3"
                        "d")
                    .empty());
    EXPECT_THAT(notUtf8("# operator: J\xFCrgen").english(),
        testing::AllOf(testing::HasSubstr("0xFC"), testing::HasSubstr("\"# operator: J\""), testing::HasSubstr("Windows-1252"),
            testing::HasSubstr("CSV UTF-8")));
}

TEST(Quotes, cutLongText)
{
    const std::string longText(200, 'x');
    EXPECT_LT(inQuotes(longText).size(), 80u);
    std::string accents;
    for (int i = 0; i < 59; ++i)
        accents += "\u00E9";
    EXPECT_TRUE(isUtf8(inQuotes("x" + accents))); // never cut inside a character
}

TEST(RowSplitter, partsCells)
{
    RowSplitter splitter(',');
    EXPECT_EQ(splitter.begin("a, b ,\"c,d\",\"say \"\"yes\"\"\",,5\" pipe"), RowSplitter::State::Complete);
    EXPECT_THAT(splitter.cells(), testing::ElementsAre("a", "b", "c,d", "say \"yes\"", "", "5\" pipe"));
    EXPECT_EQ(splitter.begin(" \" kept \" "), RowSplitter::State::Complete);
    EXPECT_THAT(splitter.cells(), testing::ElementsAre(" kept "));
}

TEST(RowSplitter, goesOnOverLines)
{
    RowSplitter splitter(';');
    EXPECT_EQ(splitter.begin("1;\"first"), RowSplitter::State::Open);
    EXPECT_EQ(splitter.resume(""), RowSplitter::State::Open);
    EXPECT_EQ(splitter.resume("third\";2"), RowSplitter::State::Complete);
    EXPECT_THAT(splitter.cells(), testing::ElementsAre("1", "first\n\nthird", "2"));
    EXPECT_EQ(splitter.begin("\"a\"b"), RowSplitter::State::TextAfterQuote);
}

TEST(RecordWords, areReadInTheFormsThatPeopleWrite)
{
    EXPECT_EQ(choiceOf<SwingStage>("as found"), SwingStage::AsFound);
    EXPECT_EQ(choiceOf<SwingStage>("As-Left"), SwingStage::AsLeft);
    EXPECT_EQ(choiceOf<SwingKind>(fileWord(SwingKind::Air)), SwingKind::Air);
    EXPECT_EQ(choiceOf<Compensator>("electronic"), Compensator::Electronic);
    EXPECT_FALSE(choiceOf<RadioState>("perhaps"));
    EXPECT_EQ(allowedWords<SwingKind>(), "check, correction, calibration, air or not_stated");
}

} // namespace lubberline::test
