#pragma once
/// Loops that are compiled twice, for processors with and without wide vectors; the program picks at its start.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define LUBBERLINE_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define LUBBERLINE_VECTOR_CLONES
#endif

namespace lubberline {

typedef double FourDoubles __attribute__((vector_size(32))); // NOLINT: the attribute wants a typedef

} // namespace lubberline
