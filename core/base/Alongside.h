#pragma once
/// Work on many things that do not know of each other, by two hands: which of them takes which changes nothing of what comes out.

#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>

namespace lubberline {

/// @param each takes a place below `count`, and touches nothing that it touches for another one. What it throws is thrown here.
template <class Each>
void alongside(std::size_t count, const Each& each)
{
    std::atomic<std::size_t> next{0};
    const auto take = [&](std::exception_ptr& thrown) {
        try {
            for (std::size_t place = next++; place < count; place = next++)
                each(place);
        } catch (...) {
            thrown = std::current_exception();
            next = count;
        }
    };
    std::exception_ptr here, there;
    {
        constexpr std::size_t kWorthIt = 8;
        std::thread other;
        if (count >= kWorthIt)
            other = std::thread([&] { take(there); });
        take(here);
        if (other.joinable())
            other.join();
    }
    if (here || there)
        std::rethrow_exception(here ? here : there);
}

} // namespace lubberline
