#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "ui/report/page/Page.h"

namespace lubberline::test {

namespace {

ui::Block block(double height, bool keepWithNext = false)
{
    ui::Block made;
    made.height = height;
    made.keepWithNext = keepWithNext;
    return made;
}

} // namespace

TEST(Paginate, fillsPagesInOrderAndLosesNothing)
{
    std::minstd_rand bits(7);
    for (int round = 0; round < 200; ++round) {
        const auto head = std::make_shared<const ui::Block>(block(10));
        std::vector<ui::Block> blocks;
        for (unsigned i = 0; i < 60; ++i) {
            const double height = 5.0 + bits() % 40; // arguments are evaluated in any order
            blocks.push_back(block(height, bits() % 7 == 0));
            blocks.back().newPage = bits() % 31 == 0;
            if (bits() % 2 == 0)
                blocks.back().repeatedHead = head;
        }
        std::vector<const ui::Block*> seen;
        for (const auto& page : ui::paginate(blocks, 200)) {
            ASSERT_FALSE(page.empty());
            double bottom = 0;
            for (const auto& placed : page) {
                EXPECT_GE(placed.top, bottom);
                bottom = placed.top + placed.block->height;
                if (placed.block != head.get())
                    seen.push_back(placed.block);
            }
            EXPECT_LE(bottom, 200);
        }
        ASSERT_EQ(seen.size(), blocks.size());
        for (std::size_t i = 0; i < blocks.size(); ++i)
            EXPECT_EQ(seen[i], &blocks[i]);
    }
}

TEST(Paginate, keepsAHeadingWithWhatItHeads)
{
    const std::vector<ui::Block> blocks{block(80), block(10, true), block(5, true), block(10)};
    const auto pages = ui::paginate(blocks, 100);
    ASSERT_EQ(pages.size(), 2u);
    EXPECT_EQ(pages[1].front().block, &blocks[1]);
}

TEST(Paginate, repeatsTheHeadOnlyWhereATableGoesOn)
{
    const auto head = std::make_shared<const ui::Block>(block(10));
    std::vector<ui::Block> blocks(30, block(10));
    for (auto& row : blocks)
        row.repeatedHead = head;
    blocks.insert(blocks.begin(), *head);
    blocks.front().keepWithNext = true;
    const auto pages = ui::paginate(blocks, 100);
    ASSERT_EQ(pages.size(), 4u); // 9 rows on each page, 3 on the last
    EXPECT_EQ(pages[0].front().block, &blocks[0]);
    for (std::size_t i = 1; i < pages.size(); ++i)
        EXPECT_EQ(pages[i].front().block, head.get());
}

TEST(Paginate, whatIsHigherThanAPageGetsOneOfItsOwn)
{
    const std::vector<ui::Block> blocks{block(10), block(500), block(10)};
    const auto pages = ui::paginate(blocks, 100);
    ASSERT_EQ(pages.size(), 3u);
    EXPECT_EQ(pages[1].size(), 1u);
}

} // namespace lubberline::test
