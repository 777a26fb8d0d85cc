#pragma once
/// A programmer's mistake: checked in every build, ends the program with the place and the broken promise.
/// Expected failures (a bad file, too few headings) are a Result, never this.

#include <cstdio>
#include <cstdlib>

#define LUBBERLINE_EXPECT(condition, promise)                                                                                              \
    do {                                                                                                                                   \
        if (!(condition)) {                                                                                                                \
            std::fprintf(stderr, "lubberline: %s:%d: broken contract: %s\n", __FILE__, __LINE__, promise);                                 \
            std::abort();                                                                                                                  \
        }                                                                                                                                  \
    } while (false)
