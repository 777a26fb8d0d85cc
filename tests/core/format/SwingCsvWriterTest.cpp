#include <gmock/gmock.h>

#include "core/demo/DemoFleet.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

using testing::HasSubstr;

TEST(SwingCsvWriter, everyParticularAndReadingComesBack)
{
    SwingRecord record = wholeRecord();
    record.swing.sharedErrors.of_deg = {0.6, 0, 0.125, 0, 0};
    EXPECT_THAT(writeSwingCsv(record), HasSubstr("\n# shared_error_deg: A 0.6 C 0.125\n"));
    const auto file = readCsv(writeSwingCsv(record));
    ASSERT_TRUE(file) << describe(file.error()) << writeSwingCsv(record);
    EXPECT_EQ(file->aircraft, "SP-TST");
    EXPECT_EQ(file->type, "PZL-130");
    EXPECT_EQ(file->compass, "standby compass");
    EXPECT_EQ(file->site, "D\u0119blin");
    EXPECT_EQ(file->operatorName, "an operator");
    Swing expected = record.swing; // but for what is the database's
    expected.id = {};
    expected.compass = {};
    expected.site = {};
    expected.state = SwingState::Draft;
    expected.record = file->swing.record;
    EXPECT_EQ(file->swing, expected);
}

TEST(SwingCsvWriter, readingsOfTheWholeDemonstrationFleetComeBack)
{
    const Fleet fleet = demoFleet();
    for (const Swing& swing : fleet.swings) {
        SwingRecord record;
        record.swing = swing;
        const auto file = readCsv(writeSwingCsv(record));
        ASSERT_TRUE(file) << describe(file.error());
        std::vector<Reading> complete;
        for (const auto& reading : swing.readings)
            if (reading.complete())
                complete.push_back(reading);
        EXPECT_EQ(file->swing.readings, complete);
    }
}

TEST(SwingCsvWriter, leavesOutWhatNoReadingHas)
{
    SwingRecord record;
    Reading reading;
    reading.magnetic = MagneticHeading::fromDegrees(1);
    reading.compass = CompassHeading::fromDegrees(2.5);
    record.swing.readings = {reading, Reading{}}; // the second is not complete
    EXPECT_THAT(writeSwingCsv(record), testing::EndsWith("\nmagnetic_heading_deg,compass_heading_deg\n1,2.5\n"));
    record.swing.readings[0].note = "a";
    EXPECT_THAT(writeSwingCsv(record), HasSubstr("magnetic_heading_deg,compass_heading_deg,note\n1,2.5,a\n"));
}

TEST(SwingCsvWriter, lineBreaksOfAParticularDoNotMakeAKey)
{
    SwingRecord record = wholeRecord();
    record.swing.note = "calm\n# variation_deg: 99\nradio: on";
    const auto file = readCsv(writeSwingCsv(record));
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->swing.variation_deg, 7.25);
    EXPECT_EQ(file->swing.note, "calm # variation_deg: 99 radio: on");
}

TEST(SwingCsvWriter, readingsWithDifferentExtraColumnsShareOneHeader)
{
    SwingRecord record = wholeRecord();
    record.swing.readings[1].extra = {{"humidity", "40"}, {"wind", "N"}};
    const auto file = readCsv(writeSwingCsv(record));
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->swing.readings, record.swing.readings);
}

} // namespace lubberline::test
