// Sentences with their checksums as found in public logs and in the manuals of instruments; what they say, and what is no
// sentence.

#include <gtest/gtest.h>

#include "core/nmea/NmeaLines.h"
#include "core/nmea/NmeaSentence.h"
#include "core/nmea/NmeaValues.h"

namespace lubberline {
namespace {

/// Of a line that holds one sentence or none.
NmeaFault faultOf(std::string_view line)
{
    const auto found = nmeaSentences(line);
    return found.empty() ? NmeaFault::NotASentence : found.front().fault;
}

NmeaSentence sentenceOf(std::string_view line)
{
    auto found = nmeaSentences(line);
    EXPECT_EQ(found.size(), 1u) << line;
    EXPECT_EQ(found.front().fault, NmeaFault::None) << line;
    return found.front().sentence;
}

template <class Value>
Value read(std::string_view line)
{
    const auto value = valueOf(sentenceOf(line));
    EXPECT_TRUE(std::holds_alternative<Value>(value)) << line;
    return std::holds_alternative<Value>(value) ? std::get<Value>(value) : Value{};
}

TEST(NmeaSentence, checksumOfPublishedSentences)
{
    for (const char* line : {"$HCHDG,98.3,0.0,E,12.6,W*57", "$HCHDG,359.6,0.0,E,2.2,W*59", "$HCHDG,101.1,,,7.1,W*3C",
             "$IIHDG,097,,,00,E*1C", "$GPHDT,274.07,T*03", "$GPRMC,113745.12,A,5021.9979,N,00407.9635,W,0.0,358.1,310315,2.2,W,A*3B",
             "$GPVTG,232.7,T,234.9,M,1.3,N,2.4,K,A*2F", "$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47",
             "$HCHDG,338.9, , ,0.7,W*3D"}) {
        EXPECT_TRUE(sentenceOf(line).hasChecksum) << line;
    }
    EXPECT_EQ(makeNmea("HCHDG,98.3,0.0,E,12.6,W"), "$HCHDG,98.3,0.0,E,12.6,W*57");
}

TEST(NmeaSentence, everyDamagedCharacterIsFound)
{
    const std::string good = "$HCHDG,98.3,0.0,E,12.6,W*57";
    for (std::size_t i = 1; i < good.size(); ++i) {
        if (good[i] == '*')
            continue; // then it is a sentence without a checksum: whoever reads the stream knows whether its talker sends them
        std::string bad = good;
        bad[i] = bad[i] == '1' ? '2' : '1';
        EXPECT_NE(faultOf(bad), NmeaFault::None) << bad;
    }
}

TEST(NmeaSentence, whatIsNoSentence)
{
    for (const char* line : {"", "HCHDG,98.3", "$", "$HCHDG", "$HC,1", "$hchdg,1.0", "$HCH\x01G,98.3", "$HCHDGX,1"})
        EXPECT_EQ(faultOf(line), NmeaFault::NotASentence) << line;
    for (const char* line : {"$HCHDG,98.3,,,,*7", "$HCHDG,98.3,,,,*", "$HCHDG,98.3,,,,*7G", "$HCHDG,98.3,,,,*70X"})
        EXPECT_EQ(faultOf(line), NmeaFault::BadChecksum) << line;
}

TEST(NmeaSentence, whatLoggersPutBeforeItIsPassedOver)
{
    EXPECT_EQ(sentenceOf("2023-09-02T12:41:35.168370+00:00        $IIHDG,097,,,00,E*1C\r\n").talker, "II");
    EXPECT_EQ(sentenceOf("NAV 2013/11/20 05:00:04.561 GPS $GPHDT,274.07,T*03").type, "HDT");
    EXPECT_FALSE(sentenceOf("$HCHDG,205.2,,,2.7,W").hasChecksum);
}

TEST(NmeaSentence, whatLoggersWrapItIn)
{
    const std::string bare = "$HCHDG,98.3,0.0,E,12.6,W*57", open = "$HCHDG,98.3,0.0,E,12.6,W";
    for (const std::string& line : {"NMEA," + bare + ",1763629200000", "2025-11-20T09:00:00Z,\"TCP in\",HCHDG,\"" + bare + "\"",
             "host mux[311]: in [ '" + bare + "' ]", "{\"raw\":\"" + bare + "\\r\\n\"}", "{" + bare + "}", bare + ";",
             bare + std::string(1, '\0'), bare + " 12:00",
             "\xb5"
             "b\x01\x07$\xc8"
                 + bare,
             "$GPTXT,half a line" + bare, "\\g:1-2-73874,n:157036,s:r003669945,c:1120959341*1A\\" + bare, "<line>" + bare + "</line>"}) {
        const auto found = nmeaSentences(line);
        ASSERT_FALSE(found.empty()) << line;
        EXPECT_EQ(found.back().fault, NmeaFault::None) << line;
        EXPECT_EQ(found.back().sentence.field(0), "98.3") << line;
        EXPECT_TRUE(found.back().sentence.hasChecksum) << line;
    }
    for (const std::string& line : {"\"" + open + "\"", "[" + open + "]", "{\"a\":\"" + open + "\\r\\n\"}"}) {
        EXPECT_EQ(sentenceOf(line).field(4), "W") << line;
        EXPECT_FALSE(sentenceOf(line).hasChecksum) << line;
    }
}

TEST(NmeaSentence, severalOnALineAndASecondDollarBeginsAnew)
{
    const auto two = nmeaSentences("[\"$HCHDG,98.3,0.0,E,12.6,W*57\",\"$GPHDT,274.07,T*03\"]");
    ASSERT_EQ(two.size(), 2u);
    EXPECT_EQ(two[0].sentence.type, "HDG");
    EXPECT_EQ(two[1].sentence.type, "HDT");
    const auto cut = nmeaSentences("$HCHDG,9$GPHDT,274.07,T*03");
    ASSERT_EQ(cut.size(), 2u);
    EXPECT_EQ(cut[0].fault, NmeaFault::NotASentence); // half a heading is none
    EXPECT_EQ(cut[1].sentence.type, "HDT");
    const auto damaged = nmeaSentences("$HCHDG,98\xff.3");
    EXPECT_EQ(damaged.front().fault, NmeaFault::NotASentence); // and no heading of 98
}

TEST(NmeaValues, headings)
{
    const auto compass = read<NmeaCompass>("$HCHDG,98.3,0.5,E,12.6,W");
    EXPECT_DOUBLE_EQ(compass.heading.degrees(), 98.3); // the sensor's own: its deviation is not applied
    EXPECT_DOUBLE_EQ(compass.deviation->degrees(), 0.5);
    EXPECT_DOUBLE_EQ(compass.variation->degrees(), -12.6);
    EXPECT_DOUBLE_EQ(read<NmeaCompass>("$HCHDM,360.0,M").heading.degrees(), 0.0);
    EXPECT_DOUBLE_EQ(read<NmeaTrueHeading>("$GPHDT,274.07,T*03").heading.degrees(), 274.07);
    EXPECT_FALSE(read<NmeaCompass>("$HCHDG,98.3,,,,").variation);
    for (const char* line : {"$HCHDG,-3.0,,,,", "$HCHDG,360.5,,,,", "$HCHDM,-0.5,M", "$GPHDT,400,T", "$GNTHS,-1,A"})
        EXPECT_EQ(read<NmeaBadHeading>(line).talker, std::string(line + 1, 2)); // counted, and never bent to fit
    EXPECT_EQ(read<NmeaNoHeading>("$GNTHS,12.0,V").talker, "GN");
    for (const char* line : {"$HCHDG,,,,,", "$HCHDG,abc,,,,", "$IIVHW,,T,,M,5.1,N,,K", "$GPGSV,1,1,00", "$PGRME,1.0,M"})
        EXPECT_TRUE(std::holds_alternative<std::monostate>(valueOf(sentenceOf(line)))) << line;
}

TEST(NmeaValues, otherSentencesOfHeadingAndTime)
{
    EXPECT_DOUBLE_EQ(read<NmeaTrueHeading>("$GNTHS,27.48,A*20").heading.degrees(), 27.48);
    EXPECT_EQ(read<NmeaTrueHeading>("$GNTHS,27.48,E").mode, NmeaMode::Estimated);
    EXPECT_EQ(read<NmeaTrueHeading>("$GNTHS,27.48,S").mode, NmeaMode::Simulated);
    const auto water = read<NmeaWater>("$VWVHW,115.0,T,100.2,M,5.1,N,9.4,K");
    EXPECT_DOUBLE_EQ(water.heading->degrees(), 115.0);
    EXPECT_DOUBLE_EQ(water.compass->degrees(), 100.2);
    const auto clock = read<NmeaClock>("$GPZDA,201530.00,04,07,2002,00,00*60");
    EXPECT_DOUBLE_EQ(clock.time.secondsOfDay, 20 * 3600 + 15 * 60 + 30);
    EXPECT_EQ(*clock.time.date, Date("2002-07-04"));
    EXPECT_FALSE(read<NmeaClock>("$GPZDA,201530.00,31,02,2002,00,00").time.date); // no day of the calendar
}

TEST(NmeaValues, everyFormOfVtg)
{
    for (const char* line : {"$GPVTG,232.7,T,234.9,M,10.8,N,20.0,K,A", "$GPVTG,232.7,T,,M,10.8,N,,K", "$GPVTG,232.7,T,,M,,,20.0016,K,A",
             "$GPVTG,232.7,T,,,,,20.0016,K", "$GPVTG,232.7,234.9,10.8,20.0", "$GPVTG,232.7,,,20.0016", "$GPVTG,232.7,,234.9,,10.8,,20.0,,",
             "$GPVTG,232.7,T,,,10.8,N,,,D"}) {
        const auto track = read<NmeaTrack>(line);
        ASSERT_TRUE(track.track && track.speed_kt) << line;
        EXPECT_DOUBLE_EQ(track.track->degrees(), 232.7) << line;
        EXPECT_NEAR(*track.speed_kt, 10.8, 1e-9) << line; // 1 kt = 1.852 km/h
    }
    EXPECT_EQ(read<NmeaTrack>("$GPVTG,232.7,T,,M,10.8,N,,K,E").mode, NmeaMode::Estimated);
    EXPECT_FALSE(read<NmeaTrack>("$GPVTG,,T,,M,,N,,K,A").track);
}

TEST(NmeaValues, recommendedMinimum)
{
    const auto track = read<NmeaTrack>("$GPRMC,225446,A,4916.45,N,12311.12,W,000.5,054.7,191194,020.3,E*68");
    EXPECT_DOUBLE_EQ(track.track->degrees(), 54.7);
    EXPECT_DOUBLE_EQ(*track.speed_kt, 0.5);
    EXPECT_DOUBLE_EQ(track.variation->degrees(), 20.3);
    EXPECT_DOUBLE_EQ(track.time->secondsOfDay, 22 * 3600 + 54 * 60 + 46);
    EXPECT_EQ(*track.time->date, Date("1994-11-19"));
    EXPECT_NEAR(*track.latitude_deg, 49 + 16.45 / 60, 1e-12);
    EXPECT_NEAR(*track.longitude_deg, -(123 + 11.12 / 60), 1e-12);
}

TEST(NmeaValues, aVoidFixHasNoTrack)
{
    EXPECT_FALSE(read<NmeaTrack>("$GPRMC,225446,V,4916.45,N,12311.12,W,000.5,054.7,191194,020.3,E").track);
    EXPECT_FALSE(read<NmeaTrack>("$GPRMC,225446,A,4916.45,N,12311.12,W,000.5,054.7,191194,020.3,E,N").track);
    EXPECT_FALSE(read<NmeaTrack>("$GPVTG,232.7,T,234.9,M,1.3,N,2.4,K,N").track);
    EXPECT_TRUE(read<NmeaTrack>("$GPVTG,232.7,T,234.9,M,1.3,N,2.4,K,A*2F").track);
    EXPECT_TRUE(
        std::holds_alternative<std::monostate>(valueOf(sentenceOf("$GPGGA,123519,4807.038,N,01131.000,E,0,08,0.9,545.4,M,46.9,M,,"))));
    EXPECT_TRUE(
        std::holds_alternative<std::monostate>(valueOf(sentenceOf("$GPGGA,123519,9107.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,"))));
}

TEST(NmeaLines, sentencesArriveInPieces)
{
    NmeaLines lines;
    std::vector<std::string> got;
    const auto each = [&got](std::string_view line) { got.emplace_back(line); };
    const std::string stream = "$HCHDG,98.3,0.0,E,12.6,W*57\r\n$GPHDT,274.07,T*03\n\r\n$HCHDM,1";
    for (const char c : stream)
        lines.feed(std::string_view(&c, 1), each);
    ASSERT_EQ(got.size(), 2u);
    EXPECT_EQ(got[1], "$GPHDT,274.07,T*03");
    lines.finish(each);
    EXPECT_EQ(got.back(), "$HCHDM,1");
}

TEST(NmeaLines, aLineThatDoesNotEndIsReadInPieces)
{
    std::string json = "[";
    for (int i = 0; i < 1000; ++i)
        json += "\"$GPHDT,274.07,T*03\",";
    NmeaLines lines;
    std::size_t headings = 0;
    const auto each = [&](std::string_view line) {
        for (const auto& found : nmeaSentences(line))
            headings += found.fault == NmeaFault::None ? 1 : 0;
    };
    lines.feed(json, each);
    lines.finish(each);
    EXPECT_EQ(headings, 1000u);
}

TEST(NmeaLines, babbleIsGivenUpAndTheNextSentenceIsRead)
{
    NmeaLines lines;
    std::vector<std::string> got;
    const auto each = [&got](std::string_view line) { got.emplace_back(line); };
    lines.feed(std::string(1'000'000, '\xff'), each);
    lines.feed("\n$GPHDT,274.07,T*03\n", each);
    ASSERT_EQ(got.size(), 2u);
    EXPECT_EQ(got.front().size(), kMaxNmeaLine + 1);
    EXPECT_EQ(faultOf(got.front()), NmeaFault::NotASentence);
    EXPECT_EQ(got.back(), "$GPHDT,274.07,T*03");
}

} // namespace
} // namespace lubberline
