// What people read is marked for translation. In core and db the compiler sees to it (core/base/Message.h); here what it cannot see.
#include <cctype>
#include <regex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/structure/Sources.h"

namespace {

using namespace lubberline::test;

std::vector<std::string> placesOf(const std::vector<std::string>& folders, const std::regex& pattern)
{
    std::vector<std::string> places;
    for (const auto& [file, text] : sourcesBelow(folders))
        for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found)
            places.push_back(file + ": " + found->str());
    return places;
}

/// A text in the code, pieces that stand behind each other as one, and the code before it.
struct Literal {
    std::string text, before;
};

/// The literals of a source; comments, characters and raw strings are none.
std::vector<Literal> literalsOf(const std::string& source)
{
    std::vector<Literal> literals;
    std::string code; // without comments, every literal as ""
    bool joined = false;
    for (std::size_t i = 0; i < source.size();) {
        const auto at = [&](std::size_t place) { return place < source.size() ? source[place] : '\0'; };
        if (at(i) == '/' && (at(i + 1) == '/' || at(i + 1) == '*')) {
            const bool line = at(i + 1) == '/';
            const auto end = source.find(line ? "\n" : "*/", i + 2);
            i = end == std::string::npos ? source.size() : end + (line ? 0 : 2);
        } else if (at(i) == '"' && i > 0 && source[i - 1] == 'R') {
            const std::string fence = ")" + source.substr(i + 1, source.find('(', i) - i - 1) + "\"";
            i = source.find(fence, i) + fence.size();
        } else if (at(i) == '\'' && i > 0 && std::isdigit(static_cast<unsigned char>(source[i - 1]))) {
            code += source[i++]; // 10'000
        } else if (at(i) == '"' || at(i) == '\'') {
            const char quote = at(i);
            std::string text;
            for (++i; i < source.size() && source[i] != quote; ++i) {
                text += source[i];
                if (source[i] == '\\')
                    text += source[++i];
            }
            ++i;
            if (quote == '\'')
                code += "' '";
            else if (joined)
                literals.back().text += text;
            else
                literals.push_back({text, code.substr(code.size() > 400 ? code.size() - 400 : 0)});
            joined = quote == '"';
            continue;
        } else {
            const bool space = std::isspace(static_cast<unsigned char>(source[i])) != 0;
            if (!space && joined)
                code += "\"\"";
            joined = joined && space;
            code += source[i++];
            continue;
        }
    }
    return literals;
}

bool isMarked(const Literal& literal)
{
    const std::string_view before = std::string_view(literal.before).substr(0, literal.before.find_last_not_of(" \n") + 1);
    for (const char* mark :
        {"tr(", "QT_TR_NOOP(", "QT_TR_N_NOOP(", "MARKED(", "MARKED_N(", "MARKED(\"\",", "MARKED_N(\"\",", "MARKED( \"\","})
        if (before.ends_with(mark))
            return true;
    const auto begin = before.find_last_of(";{}"); // of the statement
    const std::string_view statement = begin == std::string_view::npos ? before : before.substr(begin);
    const bool afterAnother = statement.ends_with(',');
    return afterAnother
        && (statement.find("LUBBERLINE_EXPECT(") != std::string_view::npos || statement.rfind("translate(") > statement.rfind(')'));
}

/// What is no sentence of the window: names that are stored or sought, and the language of style sheets and pages.
bool isNoSentence(const std::string& file, const std::string& text)
{
    static const std::regex language("[<{;]|^[a-z-]+: |^# ");
    static const std::vector<std::pair<std::string, std::string>> kStored{{"ui/guided/", "read again"}, {"ui/guided/", "read after all"},
        {"ui/report/page/", "it holds more than it may"}, {"ui/guided/", "read again after the review"},
        {"ui/guided/", "after the check swing"}, {"ui/guided/", "magnetic heading, as read"}, {"ui/fleet/", "completion undone"},
        {"ui/", "from the log "}, {"ui/inflight/", "in flight, "}, {"ui/calibration/", "calibrated from "},
        {"ui/calibration/", "; the dip is not known: what rests on it needs it entered"}, {"ui/swing/", " job card.pdf"},
        {"ui/report/forms/", "compensator at zero"}, {"ui/report/forms/", "variation setter"}, {"ui/sensor/", "soft iron "},
        {"ui/sensor/", "hard iron "}, {"ui/sensor/", "soft constant "}, {"ui/report/swing/", "(d − b) / 2λ, with the turn of the mount"}};
    for (const auto& [place, stored] : kStored)
        if (file.starts_with(place) && text == stored)
            return true;
    return std::regex_search(text, language);
}

/// Wherever it stands: in a choice, behind a plus, in a table of texts, in what a function gives back.
TEST(Words, aSentenceOfTheWindowIsMarked)
{
    const std::regex sentence("[A-Za-z]{2,},? [a-z]{2,}");
    std::size_t marked = 0;
    for (const auto& [file, text] : sourcesBelow({"ui"}))
        for (const Literal& literal : literalsOf(text)) {
            if (!std::regex_search(literal.text, sentence))
                continue;
            marked += isMarked(literal);
            EXPECT_TRUE(isMarked(literal) || isNoSentence(file, literal.text))
                << file << ": \"" << literal.text << "\" is not marked by tr()";
        }
    EXPECT_GT(marked, 1000u) << "the test does not see what it looks for";
}

TEST(Words, whatIsNotMarkedIsSeen)
{
    const auto unmarked = [](const std::string& code) {
        int found = 0;
        for (const Literal& literal : literalsOf(code))
            found += !isMarked(literal) && !isNoSentence("ui/x.cpp", literal.text);
        return found;
    };
    EXPECT_EQ(unmarked("label->setText(on ? \"No result yet\" : tr(\"A result\"));"), 1);
    EXPECT_EQ(unmarked("return name + QStringLiteral(\" is not known\"); // \"in a comment\""), 1);
    EXPECT_EQ(unmarked("tr(\"one sentence in \"\n   \"two pieces\"); tr(\"a \\\"b\\\" c\")"), 0);
    EXPECT_EQ(unmarked("constexpr char c = '\"'; x = 10'000; y = MARKED(\"ui\", \"a pattern of ours\");"), 0);
}

TEST(Words, aTextOfAWidgetIsMarked)
{
    const std::regex unmarked("\\b(setText|setToolTip|setWindowTitle|setTitle|setStatusTip|setPlaceholderText|addAction|addTab|addRow|"
                              "addItem|setWhatsThis|setAccessibleName|QLabel|QPushButton|QCheckBox|QGroupBox|QAction|say|refuse)"
                              "\\(\\s*(QStringLiteral\\(|QLatin1String\\()?\"[^\"]*[A-Za-z]{3}");
    for (const auto& place : placesOf({"ui"}, unmarked))
        ADD_FAILURE() << place << "… is not marked by tr()";
    for (const auto& place : placesOf({"ui"}, std::regex("\\.help\\s*=\\s*(QStringLiteral\\()?\"")))
        ADD_FAILURE() << place << "… is not marked by tr()";
}

TEST(Words, whatIsSaidAsItIsIsNoSentenceOfOurs)
{
    for (const auto& place : placesOf({"core", "db", "ui", "app"}, std::regex("Message::verbatim\\([^;]*\"[^\"]*[A-Za-z]{3} [^\"]*\"")))
        ADD_FAILURE() << place << "… is a sentence: MARKED, so that it can be translated";
}

/// English goes to commands, files and the audit trail; what a window shows is translated.
TEST(Words, theWindowShowsNoEnglishOfCore)
{
    const std::regex shown("(toText|fromStdString)\\([^;()]*(\\([^;()]*\\)[^;()]*)*\\.english\\(\\)");
    for (const auto& place : placesOf({"ui"}, shown))
        ADD_FAILURE() << place << "… shows English: translated(message)";
}

/// lupdate takes a pattern's context from the mark: it says whose words they are.
TEST(Words, aMarkNamesItsFloor)
{
    for (const std::string floor : {"core", "db", "ui", "app"})
        for (const auto& place : placesOf({floor}, std::regex("\\bMARKED(_N)?\\(\\s*\"(?!" + floor + "\")[^\"]*\"")))
            ADD_FAILURE() << place << "… names another floor";
}

/// Words that lupdate gives to a namespace are asked for under a class, and never found: a brace among the initialisers of members, or a class
/// without its macro, does that.
TEST(Words, everyTranslationBelongsToAClass)
{
    const std::string text = textOf(LUBBERLINE_SOURCE "/resources/translations/lubberline_pl.ts");
    ASSERT_FALSE(text.empty());
    for (const char* context : {"<name>lubberline</name>", "<name>lubberline::ui</name>", "<name>lubberline::app</name>", "<name></name>"})
        EXPECT_EQ(text.find(context), std::string::npos) << context;
}

} // namespace
