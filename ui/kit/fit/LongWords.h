#pragma once
/// Text for labels that wrap: a path or a name without any space would make its window as wide as itself.

#include <QRegularExpression>
#include <QString>

namespace lubberline::ui {

/// The same to read; a word of more than forty characters may be broken after every twenty.
[[nodiscard]] inline QString breakable(QString text)
{
    static const QRegularExpression longWord(QStringLiteral("\\S{40,}"));
    auto found = longWord.match(text);
    for (qsizetype from = 0; found.hasMatch(); found = longWord.match(text, from)) {
        QString word = found.captured();
        for (qsizetype at = 20; at < word.size(); at += 21)
            word.insert(at, QChar(0x200B)); // of no width
        text.replace(found.capturedStart(), found.capturedLength(), word);
        from = found.capturedStart() + word.size();
    }
    return text;
}

} // namespace lubberline::ui
