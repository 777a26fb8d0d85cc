// A Swing CSV that states where it was made: the field stamp that it gives.

#include <gmock/gmock.h>

#include "core/earth/FieldModel.h"
#include "core/swing/SwingField.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

const std::string kRow = "10,12\n";

} // namespace

TEST(SwingCsvPlace, givesAFieldStampByItsDate)
{
    const auto file = readCsv("# date: 2026-03-10\n# latitude_deg: 51.55\n# longitude_deg: 21,89\n# height_m: 117\n" + kHeader + kRow);
    ASSERT_TRUE(file) << describe(file.error());
    ASSERT_TRUE(file->swing.field);
    EXPECT_EQ(*file->swing.field, *stampField(*makePlace(51.55, 21.89, 117), "2026-03-10"));
    EXPECT_EQ(file->swing.field->model, "WMM2025");
    EXPECT_TRUE(file->warnings.empty());
    EXPECT_TRUE(file->swing.note.empty());
}

TEST(SwingCsvPlace, isWrittenBackAndReadAgain)
{
    const auto file = readCsv("# date: 2005-05-01\n# latitude_deg: -33.9461\n# longitude_deg: 511.1772\n" + kHeader + kRow);
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->swing.field->model, "IGRF-14");
    EXPECT_NEAR(file->swing.field->place.longitude_deg, 151.1772, 1e-9);
    const std::string text = writeSwingCsv(recordOf(*file));
    EXPECT_THAT(text, testing::AllOf(HasSubstr("# latitude_deg: -33.9461\n"), HasSubstr("# height_m: 0\n")));
    const auto again = readCsv(text);
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(again->swing.field, file->swing.field);
    EXPECT_EQ(writeSwingCsv(recordOf(*again)), text);
}

TEST(SwingCsvPlace, whereNoFieldIsKnownAWarningSaysWhy)
{
    const std::string place = "# latitude_deg: 51\n# longitude_deg: 21\n";
    const std::pair<std::string, const char*> cases[] = {
        {place, "no date"}, {"# date: 1850-01-01\n" + place, "1900"},            // before every model
        {"# date: 2026-01-01\n# latitude_deg: 86\n# longitude_deg: 142\n", "H"}, // blackout zone
    };
    for (const auto& [keys, words] : cases) {
        const auto file = readCsv(keys + kHeader + kRow);
        ASSERT_TRUE(file) << describe(file.error());
        EXPECT_FALSE(file->swing.field);
        EXPECT_THAT(inEnglish(file->warnings), testing::ElementsAre(HasSubstr(words)));
    }
}

TEST(SwingCsvPlace, halfAPlaceAndNoPlaceOnEarthAreRefused)
{
    const std::pair<const char*, const char*> cases[] = {
        {"# latitude_deg: 51\n", "latitude_deg is stated without longitude_deg"},
        {"# longitude_deg: 21\n", "longitude_deg is stated without latitude_deg"},
        {"# latitude_deg: 91\n# longitude_deg: 21\n", "latitude_deg: \"91\""},
        {"# latitude_deg: north\n# longitude_deg: 21\n", "latitude_deg: \"north\""},
        {"# latitude_deg: 1\n# longitude_deg: 1\n# height_m: 1e9\n", "height_m: \"1e9\""},
    };
    for (const auto& [keys, words] : cases) {
        const auto file = readCsv(keys + kHeader + kRow);
        ASSERT_FALSE(file) << keys;
        EXPECT_EQ(file.error().code, ErrorCode::InvalidInput);
        EXPECT_THAT(file.error().message.english(), testing::AllOf(HasSubstr(words), HasSubstr("expected")));
    }
}

TEST(SwingCsvPlace, goesIntoTheSiteThatItNames)
{
    const auto file = readCsv(
        "# aircraft: SP-TST\n# site: Mielec\n# date: 2026-03-10\n# latitude_deg: 50.32\n# longitude_deg: 381.46\n" + kHeader + kRow);
    ASSERT_TRUE(file);
    const auto fleet = toFleet(*file);
    ASSERT_TRUE(fleet);
    EXPECT_EQ(fleet->sites.front().latitude_deg, 50.32);
    EXPECT_NEAR(*fleet->sites.front().longitude_deg, 21.46, 1e-9);
    EXPECT_EQ(stateOf(fleet->swings.front(), fleet->sites.front()), StampState::Current);
}

} // namespace lubberline::test
