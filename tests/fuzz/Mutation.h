#pragma once
/// Damage to bytes, the same for the same seed on every machine: what a fuzzer does, where there is no clang.

#include <cstdint>
#include <string>
#include <vector>

namespace lubberline::test {

/// Of one file of a corpus; now and then with a piece of another one in it.
class Mutation {
public:
    explicit Mutation(std::uint64_t seed) : m_state(seed) {}
    /// @param corpus not empty
    [[nodiscard]] std::string of(const std::vector<std::string>& corpus, std::size_t which);

private:
    std::uint64_t next();
    std::size_t below(std::size_t count) { return count > 0 ? static_cast<std::size_t>(next() % count) : 0; }
    [[nodiscard]] std::string piece(const std::string& bytes, std::size_t longest);
    void change(std::string& bytes, const std::vector<std::string>& corpus);
    void changeNumber(std::string& bytes);
    std::uint64_t m_state;
};

} // namespace lubberline::test
