#include "app/Console.h"

#include <atomic>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <iostream>
#include <memory>

#include <unistd.h>

#include "core/base/TerminalText.h"

namespace lubberline::app {

namespace {

std::atomic<bool> g_interrupted{false}; // a signal handler can reach nothing else

void onInterrupt(int)
{
    g_interrupted = true;
    std::signal(SIGINT, SIG_DFL); // a second Ctrl-C ends the program at once
}

std::string textOf(const char* format, va_list arguments)
{
    va_list again;
    va_copy(again, arguments);
    std::string result(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, arguments)), '\0');
    std::vsnprintf(result.data(), result.size() + 1, format, again);
    va_end(again);
    return result;
}

} // namespace

std::string counted(std::int64_t count, const char* one) { return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s"); }

void put(const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    putText(textOf(format, arguments));
    va_end(arguments);
}

void putText(std::string_view text)
{
    const std::string shown = forTerminal(text);
    std::fwrite(shown.data(), 1, shown.size(), stdout); // a failure stays with the stream until whenPrinted()
}

int whenPrinted(int status)
{
    std::cout.flush();
    const bool arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout;
    if (arrived || status != kDone)
        return status;
    return fail(
        {ErrorCode::Io, MARKED("app", "standard output takes no more; expected one that is read to its end, on a drive with room")});
}

int fail(const Error& error)
{
    say(describe(error));
    return kFailed;
}

void warn(const std::vector<Message>& warnings)
{
    for (const auto& warning : warnings)
        say("warning: " + warning.english());
}

void say(const std::string& message) { std::fprintf(stderr, "lubberline: %s\n", inOneLine(message).c_str()); }

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
    std::string result = textOf(format, arguments);
    va_end(arguments);
    return result;
}

} // namespace lubberline::app
