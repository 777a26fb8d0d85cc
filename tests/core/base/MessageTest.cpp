#include "core/base/Message.h"

#include <gtest/gtest.h>

#include "core/base/Result.h"

namespace lubberline {
namespace {

TEST(Message, aPatternIsFilledInItsOwnOrder)
{
    const Message message{MARKED("core", "%2 before %1, %2 again, 10 % and %9 stay"), std::string("one"), 2};
    EXPECT_EQ(message.english(), "2 before one, 2 again, 10 % and %9 stay");
}

TEST(Message, aCountHasItsPlural)
{
    const auto said = [](int count) { return Message{MARKED_N("core", "%n reading(s) of %1"), count, std::string("it")}.english(); };
    EXPECT_EQ(said(0), "0 readings of it");
    EXPECT_EQ(said(1), "1 reading of it");
    EXPECT_EQ(said(24), "24 readings of it");
}

TEST(Message, whatIsPutInIsNotFilledAgain)
{
    EXPECT_EQ((Message{MARKED("core", "%1 and %2"), std::string("%2"), std::string("%n")}).english(), "%2 and %n");
    EXPECT_EQ(Message::verbatim(std::string("100 %1")).english(), "100 %1");
}

TEST(Message, onlyPatternsAreTranslatedAndEachByItself)
{
    const Message inner{MARKED("core", "inside %1"), std::string("it")};
    const Message outer = together({Message{MARKED("db", "outside: %1"), inner}, Message::verbatim(std::string("disk error"))});
    std::vector<std::string> asked;
    const auto text = outer.in([&](const Pattern& pattern, std::int64_t) {
        asked.push_back(std::string(pattern.context) + "/" + pattern.english);
        return std::string(pattern.english) == "inside %1" ? std::string("w %1") : std::string("poza: %1");
    });
    EXPECT_EQ(text, "poza: w it; disk error");
    EXPECT_EQ(asked, (std::vector<std::string>{"db/outside: %1", "core/inside %1"}));
}

TEST(Message, nothingToSayIsEmpty)
{
    EXPECT_TRUE(Message().empty());
    EXPECT_TRUE(Message::verbatim(std::string()).empty());
    EXPECT_EQ(Message().english(), "");
    EXPECT_EQ(together({Message(), MARKED("core", "one")}).english(), "one");
}

TEST(Message, anErrorNamesFileAndLine)
{
    EXPECT_EQ(describe({ErrorCode::Format, MARKED("core", "is empty"), "a.csv", 3}), "a.csv:3: is empty");
    EXPECT_EQ(describe({ErrorCode::Format, MARKED("core", "is empty"), "a.csv"}), "a.csv: is empty");
    EXPECT_EQ(describe({ErrorCode::Format, MARKED("core", "is empty")}), "is empty");
}

// A sentence without MARKED does not compile: neither as a message nor put into one.
static_assert(!std::is_constructible_v<Message, const char*>);
static_assert(!std::is_constructible_v<Message, std::string>);
static_assert(!std::is_convertible_v<const char (&)[5], Message>);
static_assert(!std::is_constructible_v<Message::Argument, const char*>);
static_assert(!std::is_constructible_v<Message::Argument, double>);
static_assert(std::is_constructible_v<Message, Pattern, std::string, int, Message>);

} // namespace
} // namespace lubberline
