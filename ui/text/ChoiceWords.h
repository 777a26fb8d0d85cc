#pragma once
/// The choices of core/record in the reader's language (core/record/RecordWords.h).

#include <QStringList>

#include "core/record/RecordWords.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

/// In the order of the enumeration: for combo boxes.
template <class Choice>
[[nodiscard]] QStringList choiceWords()
{
    QStringList words;
    for (const Pattern& word : shownWords<Choice>())
        words += translated(word);
    return words;
}

template <class Choice>
[[nodiscard]] QString wordFor(Choice choice)
{
    return translated(shownWord(choice));
}

/// Empty where nobody stated it: paper and titles leave it out.
template <class Choice>
[[nodiscard]] QString statedWord(Choice choice)
{
    return choice == Choice::NotStated ? QString() : wordFor(choice);
}

} // namespace lubberline::ui
