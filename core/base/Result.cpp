#include "core/base/Result.h"

namespace lubberline {

std::string describe(const Error& error)
{
    std::string text;
    if (!error.file.empty()) {
        text += error.file + ":";
        if (error.line > 0)
            text += std::to_string(error.line) + ":";
        text += " ";
    }
    return text + error.message;
}

} // namespace lubberline
