#pragma once
/// What must hold for any bytes: reading ends, an error is one clear line, and what is read is written and read again the same.
/// A broken promise ends the program, which is what a fuzzer looks for. @return whether the bytes could be read.

#include <string_view>

namespace lubberline::test {

bool checkSwingCsv(std::string_view bytes);
bool checkExchange(std::string_view bytes);

} // namespace lubberline::test
