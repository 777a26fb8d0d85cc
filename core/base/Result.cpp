#include "core/base/Result.h"

namespace lubberline {

Message described(const Error& error)
{
    if (error.file.empty())
        return error.message;
    const std::string place = error.line > 0 ? error.file + ":" + std::to_string(error.line) : error.file;
    return {Pattern{nullptr, "%1: %2"}, place, error.message}; // as compilers say it, in every language
}

std::string describe(const Error& error) { return described(error).english(); }

} // namespace lubberline
