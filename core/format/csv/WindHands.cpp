#include "core/format/csv/WindHands.h"

namespace lubberline {

WindHands::WindHands(WindStudy& study) : m_study(study), m_hand([this] { sumUp(); }) {}

WindHands::~WindHands()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ended = true;
    }
    m_changed.notify_all();
    if (m_hand.joinable())
        m_hand.join();
}

std::string_view WindHands::kept(std::size_t column, std::string_view text)
{
    if (m_last[column] != text)
        m_last[column] = m_heaps[m_filling % kHeaps].texts.emplace_back(text);
    return m_last[column];
}

void WindHands::add(const WindReport& report, std::int64_t line)
{
    Heap& heap = m_heaps[m_filling % kHeaps];
    WindReport& own = heap.reports.emplace_back(report);
    own.aircraft = kept(0, report.aircraft);
    own.flight = kept(1, report.flight);
    own.source = kept(2, report.source);
    own.group = kept(3, report.group);
    heap.lines.push_back(line);
    if (heap.reports.size() == kHeap)
        handOver();
}

void WindHands::handOver()
{
    std::unique_lock lock(m_mutex);
    m_handed = ++m_filling;
    m_changed.notify_all();
    m_changed.wait(lock, [this] { return m_filling - m_taken < kHeaps; });
    m_seenStopped = m_stopped.excess != Excess::None || m_thrown;
    lock.unlock();
    Heap& next = m_heaps[m_filling % kHeaps];
    next.reports.clear();
    next.lines.clear();
    next.texts.clear();
    m_last = {};
}

WindHands::Stopped WindHands::done()
{
    {
        const std::lock_guard lock(m_mutex);
        m_handed = ++m_filling;
        m_ended = true;
    }
    m_changed.notify_all();
    m_hand.join();
    if (m_thrown)
        std::rethrow_exception(m_thrown);
    return m_stopped;
}

void WindHands::sumUp()
{
    std::unique_lock lock(m_mutex);
    for (;;) {
        m_changed.wait(lock, [this] { return m_handed > m_taken || m_ended; });
        if (m_handed == m_taken)
            return;
        const Heap& heap = m_heaps[m_taken % kHeaps];
        if (m_stopped.excess == Excess::None && !m_thrown) {
            lock.unlock();
            Stopped stopped;
            std::exception_ptr thrown;
            try {
                stopped = sumUp(heap);
            } catch (...) {
                thrown = std::current_exception();
            }
            lock.lock();
            m_stopped = stopped;
            m_thrown = thrown;
        }
        ++m_taken;
        m_changed.notify_all();
    }
}

WindHands::Stopped WindHands::sumUp(const Heap& heap)
{
    for (std::size_t i = 0; i < heap.reports.size(); ++i) {
        m_study.add(heap.reports[i]);
        if (m_study.aircraft() > kMostAircraft)
            return {Excess::Aircraft, heap.lines[i]};
        if (m_study.flights() > kMostFlights)
            return {Excess::Flights, heap.lines[i]};
    }
    return {};
}

} // namespace lubberline
