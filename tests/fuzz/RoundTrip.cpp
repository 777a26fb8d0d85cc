#include "tests/fuzz/RoundTrip.h"

#include <sstream>

#include "core/base/FileText.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/exchange/Exchange.h"

namespace lubberline::test {

namespace {

void expectClear(const Error& error)
{
    LUBBERLINE_EXPECT(!error.message.english().empty() && error.message.english().find('\n') == std::string::npos, "an error is one line");
    LUBBERLINE_EXPECT(error.file == "fuzz" && isUtf8(error.message.english()), "an error names the file and can be shown");
}

Result<SwingFile> readCsv(std::string_view bytes)
{
    std::istringstream stream{std::string(bytes)};
    return readSwingCsv(stream, "fuzz");
}

} // namespace

bool checkSwingCsv(std::string_view bytes)
{
    auto file = readCsv(bytes);
    if (!file) {
        expectClear(file.error());
        return false;
    }
    LUBBERLINE_EXPECT(!file->swing.readings.empty() && isRecordId(file->swing.record), "a swing that is read has readings and an identity");
    SwingRecord record;
    record.swing = file->swing;
    record.aircraft.registration = file->aircraft;
    const auto again = readCsv(writeSwingCsv(record));
    LUBBERLINE_EXPECT(again.ok(), "what is written can be read");
    LUBBERLINE_EXPECT(again->swing.readings == file->swing.readings, "readings come back the same");
    if (file->aircraft.empty())
        file->aircraft = "not stated";
    const auto fleet = toFleet(*file);
    LUBBERLINE_EXPECT(fleet.ok() && readExchange(writeExchange(*fleet), "fuzz").ok(), "what is imported can be exported");
    return true;
}

bool checkExchange(std::string_view bytes)
{
    const auto fleet = readExchange(bytes, "fuzz");
    if (!fleet) {
        expectClear(fleet.error());
        return false;
    }
    const std::string text = writeExchange(*fleet);
    const auto again = readExchange(text, "fuzz");
    LUBBERLINE_EXPECT(again.ok() && writeExchange(*again) == text, "the second round is byte for byte the same");
    return true;
}

} // namespace lubberline::test
