#pragma once
/// Two hands for reports of wind: who reads them hands them over in heaps, a thread of its own sums them up in their order. The result is that
/// of one hand, to the last digit.

#include <array>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/inflight/WindStudy.h"

namespace lubberline {

class WindHands {
public:
    /// @param study nobody else's until done()
    explicit WindHands(WindStudy& study);
    ~WindHands();
    WindHands(const WindHands&) = delete;
    WindHands& operator=(const WindHands&) = delete;

    /// What the report's texts look into may go afterwards.
    void add(const WindReport& report, std::int64_t line);
    /// A report with which the study holds more than it may; none are summed up after it.
    enum class Excess { None, Aircraft, Flights };
    struct Stopped {
        Excess excess = Excess::None;
        std::int64_t line = 0;
    };
    /// Of what is summed up so far: whether to go on reading.
    [[nodiscard]] bool stopped() const { return m_seenStopped; }
    /// Waits for the rest. Throws what summing up threw.
    Stopped done();

    // What is kept of each takes memory; reports do not.
    static constexpr std::size_t kMostAircraft = 10'000, kMostFlights = 200'000;

private:
    static constexpr std::size_t kHeap = 2048, kHeaps = 4;
    struct Heap {
        std::vector<WindReport> reports;
        std::vector<std::int64_t> lines;
        std::deque<std::string> texts; ///< what the reports look into
    };
    std::string_view kept(std::size_t column, std::string_view text);
    void handOver();
    void sumUp();
    Stopped sumUp(const Heap& heap);

    WindStudy& m_study;
    std::array<Heap, kHeaps> m_heaps;
    std::size_t m_filling = 0;              ///< heaps handed over so far; the next one is at it, modulo all
    std::array<std::string_view, 4> m_last; ///< texts of the report before: mostly those of this one
    bool m_seenStopped = false;

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::size_t m_handed = 0, m_taken = 0; // under the mutex, with the rest
    bool m_ended = false;
    Stopped m_stopped;
    std::exception_ptr m_thrown;
    std::thread m_hand;
};

} // namespace lubberline
