// A word that was meant: of few edits, and of no words of two letters.

#include <gtest/gtest.h>

#include "core/base/NearWord.h"

namespace lubberline::test {

TEST(NearWord, editsInWords)
{
    EXPECT_EQ(editDistance("field", "field"), 0u);
    EXPECT_EQ(editDistance("feild", "field"), 1u) << "neighbours swapped";
    EXPECT_EQ(editDistance("filde", "field"), 2u);
    EXPECT_EQ(editDistance("fields", "field"), 1u);
    EXPECT_EQ(editDistance("fild", "field"), 1u);
    EXPECT_EQ(editDistance("FIELD", "field"), 0u);
    EXPECT_EQ(editDistance("", "field"), 5u);
    EXPECT_EQ(editDistance("field", ""), 5u);
}

TEST(NearWord, nearOrNot)
{
    const std::string_view known[] = {"on", "name", "current_A"};
    EXPECT_EQ(nearWord("nam", known), "name");
    EXPECT_EQ(nearWord("curent_a", known), "current_A");
    EXPECT_EQ(nearWord("xy", known), "") << "two edits make any word of two letters";
    EXPECT_EQ(nearWord("colour", known), "");
    EXPECT_EQ(nearWord(std::string(1'000'000, 'x'), known), "");
    EXPECT_EQ(nearWord("name", {}), "");
}

} // namespace lubberline::test
