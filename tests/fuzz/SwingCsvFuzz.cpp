#include <cstddef>
#include <cstdint>

#include "tests/fuzz/RoundTrip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    lubberline::test::checkSwingCsv({reinterpret_cast<const char*>(data), size});
    return 0;
}
