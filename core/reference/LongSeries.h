#pragma once
/// Memory for the figures of an hour, 180,000 a series: page by page of 4 KiB the system would take as long to hand it out as all
/// instruments take to be carried through the flight.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lubberline {

/// Large pages that were given back, some, for the next flight: a slider flies the hour again with each of its moves, and the system
/// clears every page that it hands out.
class KeptPages {
public:
    KeptPages() = default;
    KeptPages(const KeptPages&) = delete;
    KeptPages& operator=(const KeptPages&) = delete;
    ~KeptPages()
    {
        for (const auto& [memory, bytes] : m_kept)
            std::free(memory);
    }
    /// Null: none of this size is there.
    void* take(std::size_t bytes)
    {
        const std::scoped_lock lock(m_mutex);
        const auto found = std::ranges::find(m_kept, bytes, &Kept::bytes);
        if (found == m_kept.end())
            return nullptr;
        void* const memory = found->memory;
        m_bytes -= bytes;
        m_kept.erase(found);
        return memory;
    }
    void give(void* memory, std::size_t bytes)
    {
        const std::scoped_lock lock(m_mutex);
        if (m_bytes + bytes > kMost || m_kept.size() == m_kept.capacity()) {
            std::free(memory);
            return;
        }
        m_kept.push_back({memory, bytes});
        m_bytes += bytes;
    }

private:
    static constexpr std::size_t kMost = std::size_t{32} << 20;
    struct Kept {
        void* memory;
        std::size_t bytes;
    };
    std::mutex m_mutex;
    std::vector<Kept> m_kept = room();
    std::size_t m_bytes = 0;
    static std::vector<Kept> room() // what is given back must not need memory
    {
        std::vector<Kept> empty;
        empty.reserve(32);
        return empty;
    }
};
inline KeptPages& keptPages()
{
    static KeptPages pages;
    return pages;
}

/// In large pages where the system has them. What is resized is not filled with zeros.
template <class Value>
struct LargePages {
    using value_type = Value;
    static constexpr std::size_t kPage = std::size_t{2} << 20;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&) // NOLINT: one allocator makes another
    {
    }
    Value* allocate(std::size_t count)
    {
#ifdef __linux__
        if (isLong(count)) {
            const std::size_t bytes = bytesOf(count);
            if (void* const kept = keptPages().take(bytes))
                return static_cast<Value*>(kept);
            void* const memory = std::aligned_alloc(kPage, bytes);
            if (!memory)
                throw std::bad_alloc();
            madvise(memory, bytes, MADV_HUGEPAGE); // a wish: what comes of it is memory in any case
            return static_cast<Value*>(memory);
        }
#endif
        return std::allocator<Value>().allocate(count);
    }
    void deallocate(Value* memory, std::size_t count)
    {
#ifdef __linux__
        if (isLong(count)) {
            keptPages().give(memory, bytesOf(count));
            return;
        }
#endif
        std::allocator<Value>().deallocate(memory, count);
    }
    template <class Made, class... Arguments>
    void construct(Made* place, Arguments&&... arguments)
    {
        if constexpr (sizeof...(Arguments) == 0)
            ::new (static_cast<void*>(place)) Made;
        else
            ::new (static_cast<void*>(place)) Made(std::forward<Arguments>(arguments)...);
    }
    friend bool operator==(const LargePages&, const LargePages&) { return true; }

private:
    static std::size_t bytesOf(std::size_t count) { return (count * sizeof(Value) + kPage - 1) / kPage * kPage; }
    static bool isLong(std::size_t count) { return count >= kPage / 2 / sizeof(Value); }
};

template <class Value>
using LongSeries = std::vector<Value, LargePages<Value>>;

} // namespace lubberline
