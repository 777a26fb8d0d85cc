#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "core/fleet/ByTwoHands.h"

using namespace lubberline;

TEST(ByTwoHands, eachPlaceIsTakenOnce)
{
    for (const std::size_t together : {1u, 4u, 32u})
        for (const std::size_t count : {0u, 1u, 7u, 8u, 63u, 64u, 65u, 2049u}) {
            std::vector<int> taken(count, 0);
            EXPECT_TRUE(byTwoHands(count, together, {}, [&](std::size_t place) { ++taken[place]; }));
            EXPECT_EQ(taken, std::vector<int>(count, 1)) << together;
        }
}

TEST(ByTwoHands, isCancelledBetweenTurnsAndThrowsWhatIsThrown)
{
    std::vector<int> taken(1000, 0);
    int asked = 0;
    EXPECT_FALSE(byTwoHands(
        taken.size(), 1, [&](double fraction) { return ++asked < 3 && fraction < 1; }, [&](std::size_t place) { ++taken[place]; }));
    EXPECT_EQ(std::accumulate(taken.begin(), taken.end(), 0), 128);
    EXPECT_THROW(byTwoHands(100, 1, {},
                     [](std::size_t place) {
                         if (place == 42)
                             throw 42;
                     }),
        int);
}
