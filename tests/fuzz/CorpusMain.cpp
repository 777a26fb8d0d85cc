// Runs a fuzz target over every file of a folder, and over so many mutations of them that the time stays some seconds: an ordinary test,
// with any compiler. `TARGET FOLDER [--mutate COUNT [--seed SEED]]`; what ends it is written to ./found-TARGET first.

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "tests/fuzz/Mutation.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr unsigned kLongest_s = 60; // a hang, not a slow machine: each takes milliseconds

std::string s_found; // a signal's handler may look at nothing that allocates
const std::string* s_running = nullptr;

void keep(int signal)
{
    if (s_running) {
        const int file = ::open(s_found.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const bool written = file >= 0 && ::write(file, s_running->data(), s_running->size()) == static_cast<ssize_t>(s_running->size());
        for (const char* const words : {written ? "fuzz: what ended it is kept in " : "fuzz: what ended it could not be kept in ",
                 s_found.c_str(), signal == SIGALRM ? " (it hung)\n" : "\n"})
            static_cast<void>(!::write(STDERR_FILENO, words, std::char_traits<char>::length(words)));
    }
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

void run(const std::string& bytes)
{
    s_running = &bytes;
    ::alarm(kLongest_s);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ::alarm(0);
    s_running = nullptr;
}

/// In the order of their names, which a folder does not keep.
std::vector<std::string> filesOf(const char* folder)
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> files;
    for (const auto& path : paths) {
        std::ifstream file(path, std::ios::binary);
        files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return files;
}

} // namespace

int main(int argc, char** argv)
{
    std::uint64_t mutations = 0, seed = 1;
    for (int i = 2; i + 1 < argc; i += 2)
        (std::string(argv[i]) == "--seed" ? seed : mutations) = std::strtoull(argv[i + 1], nullptr, 10);
    const auto corpus = argc > 1 ? filesOf(argv[1]) : std::vector<std::string>();
    if (corpus.empty()) {
        std::fprintf(stderr, "fuzz: no files; expected TARGET FOLDER [--mutate COUNT [--seed SEED]]\n");
        return 1;
    }
    s_found = "found-" + std::filesystem::path(argv[0]).filename().string();
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM})
        ::signal(signal, keep);
    for (const auto& bytes : corpus)
        run(bytes);
    for (std::uint64_t i = 0; i < mutations; ++i)
        run(lubberline::test::Mutation(seed * 1'000'000'007ULL + i).of(corpus, static_cast<std::size_t>(i) % corpus.size()));
    std::printf("%zu files, %llu mutations\n", corpus.size(), static_cast<unsigned long long>(mutations));
    return 0;
}
