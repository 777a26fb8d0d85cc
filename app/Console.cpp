#include "app/Console.h"

#include <atomic>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <memory>

#include <unistd.h>

namespace lubberline::app {

namespace {

std::atomic<bool> g_interrupted{false}; // a signal handler can reach nothing else

void onInterrupt(int)
{
    g_interrupted = true;
    std::signal(SIGINT, SIG_DFL); // a second Ctrl-C ends the program at once
}

} // namespace

int fail(const Error& error)
{
    std::fprintf(stderr, "lubberline: %s\n", describe(error).c_str());
    return kFailed;
}

void warn(const std::vector<Message>& warnings)
{
    for (const auto& warning : warnings)
        std::fprintf(stderr, "lubberline: warning: %s\n", warning.english().c_str());
}

void say(const std::string& message) { std::fprintf(stderr, "lubberline: %s\n", message.c_str()); }

Progress consoleProgress(const std::string& what)
{
    std::signal(SIGINT, onInterrupt);
    const bool terminal = isatty(STDERR_FILENO);
    auto shown = std::make_shared<int>(-1);
    return [what, terminal, shown](double fraction) {
        const int percent = static_cast<int>(fraction * 100.0);
        if (terminal && percent != *shown) {
            *shown = percent;
            std::fprintf(stderr, "\r%s: %3d %%%s", what.c_str(), percent, percent >= 100 ? "\n" : "");
        }
        return !g_interrupted.load();
    };
}

std::string text(const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    va_list again;
    va_copy(again, arguments);
    std::string result(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, arguments)), '\0');
    std::vsnprintf(result.data(), result.size() + 1, format, again);
    va_end(again);
    va_end(arguments);
    return result;
}

} // namespace lubberline::app
