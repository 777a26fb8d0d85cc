// What people read is marked for translation. In core and db the compiler sees to it (core/base/Message.h); here what it cannot see.
#include <regex>
#include <string>
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

} // namespace
