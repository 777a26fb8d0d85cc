#include "core/base/FileText.h"
#include "tests/fuzz/Parsers.h"
#include "ui/report/swing/Report.h"

namespace lubberline::test {

bool checkPdf(std::string_view bytes)
{
    const auto exchange = ui::exchangeInPdf(std::string(bytes), "fuzz");
    LUBBERLINE_EXPECT(exchange.ok() || !exchange.error().message.english().empty(), "an error says something");
    return exchange.ok();
}

} // namespace lubberline::test
