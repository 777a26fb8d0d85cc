// One fuzz target: LUBBERLINE_FUZZED is the check that it runs.

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/Parsers.h"
#include "tests/fuzz/RoundTrip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    lubberline::test::LUBBERLINE_FUZZED({reinterpret_cast<const char*>(data), size});
    return 0;
}
