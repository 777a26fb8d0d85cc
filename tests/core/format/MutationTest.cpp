// Valid files with random damage: never a crash, and whatever is read can be written and read again to the same.

#include <gtest/gtest.h>

#include <random>

#include "core/base/FileText.h"
#include "core/demo/DemoFleet.h"
#include "core/format/exchange/Exchange.h"
#include "tests/core/format/Support.h"
#include "tests/fuzz/RoundTrip.h"

namespace lubberline::test {

namespace {

/// One to four bytes changed, taken out, doubled, or a piece moved; often into something that means something.
std::string mutated(std::string text, std::mt19937& random)
{
    static const std::string kTelling = "\",;\n\r\t#:.-+0123456789eE{}[]\\ \x00\xEF\xBB\xBF\xFF\xB0";
    const auto below = [&](std::size_t count) { return count ? random() % count : 0; };
    for (std::size_t changes = 1 + below(4); changes > 0 && !text.empty(); --changes) {
        const std::size_t place = below(text.size());
        switch (below(4)) {
        case 0: text[place] = kTelling[below(kTelling.size())]; break;
        case 1: text.erase(place, 1 + below(8)); break;
        case 2: text.insert(place, text.substr(below(text.size()), below(20))); break;
        default: text[place] = static_cast<char>(below(256)); break;
        }
    }
    return text;
}

std::string smallExchange()
{
    DemoOptions options;
    options.aircraftPerType = 1;
    options.swingsPerCompass = 1;
    Fleet fleet = demoFleet(options);
    fleet.swings.resize(3);
    return writeExchange(fleet);
}

} // namespace

TEST(Mutation, damagedCsvNeverCrashesAndWhatIsReadComesBack)
{
    std::mt19937 random(1);
    const std::string valid = writeSwingCsv(wholeRecord());
    int read = 0;
    for (int i = 0; i < 20'000; ++i)
        read += checkSwingCsv(mutated(valid, random));
    EXPECT_GT(read, 1000);   // the damage is not all fatal
    EXPECT_LT(read, 19'000); // nor all harmless
}

TEST(Mutation, damagedExchangeNeverCrashesAndWhatIsReadComesBack)
{
    std::mt19937 random(2);
    const std::string whole = writeExchange(toFleet(wholeRecord())), small = smallExchange();
    int read = 0;
    for (int i = 0; i < 6'000; ++i)
        read += checkExchange(mutated(i % 3 ? whole : small, random));
    EXPECT_GT(read, 50);
    EXPECT_LT(read, 5'500);
}

TEST(Mutation, everyBeginningOfAFileIsSurvived)
{
    const std::string csv = writeSwingCsv(wholeRecord()), exchange = writeExchange(toFleet(wholeRecord()));
    for (std::size_t length = 0; length < csv.size(); ++length)
        checkSwingCsv(csv.substr(0, length));
    for (std::size_t length = 0; length + 1 < exchange.size(); ++length) // the last byte is a newline
        EXPECT_FALSE(checkExchange(exchange.substr(0, length)));
}

} // namespace lubberline::test
