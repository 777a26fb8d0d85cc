#pragma once
/// Memory for the figures of an hour, 180,000 a series: page by page of 4 KiB the system would take as long to hand it out as all
/// instruments take to be carried through the flight.

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace lubberline {

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
            const std::size_t bytes = (count * sizeof(Value) + kPage - 1) / kPage * kPage;
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
            std::free(memory);
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
    static bool isLong(std::size_t count) { return count >= kPage / 2 / sizeof(Value); }
};

template <class Value>
using LongSeries = std::vector<Value, LargePages<Value>>;

} // namespace lubberline
