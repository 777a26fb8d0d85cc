#include "ui/kit/LengthLimits.h"

#include <QApplication>
#include <QEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextCursor>

#include <algorithm>
#include <memory>

#include "core/record/Ranges.h"

namespace lubberline::ui {

namespace {

constexpr int kMost = static_cast<int>(kLongestText);

/// How many letters in front of a place are to go so that the text fits.
int tooMany(const QString& text, int place)
{
    qsizetype over = text.toUtf8().size() - kMost;
    int letters = 0;
    while (over > 0 && letters < place) {
        const QChar letter = text.at(place - ++letters);
        over -= letter.unicode() < 0x80 ? 1 : letter.unicode() < 0x800 || letter.isSurrogate() ? 2 : 3;
        if (letter.isLowSurrogate() && letters < place) { // both halves
            ++letters;
            over -= 2;
        }
    }
    return letters;
}

} // namespace

LengthLimits::LengthLimits(std::function<void(const QString&)> say, QObject* parent) : QObject(parent), m_say(std::move(say))
{
    qApp->installEventFilter(this);
}

bool LengthLimits::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Polish) { // once, before it is seen for the first time
        if (auto* line = qobject_cast<QLineEdit*>(watched))
            limit(*line);
        else if (auto* text = qobject_cast<QPlainTextEdit*>(watched))
            limit(*text);
    }
    return QObject::eventFilter(watched, event);
}

void LengthLimits::limit(QLineEdit& field)
{
    if (field.maxLength() <= kMost)
        return;
    const bool replaced = field.hasSelectedText(); // an editor of a cell: what is typed next takes the place of all of it
    field.setMaxLength(kMost);                     // this takes the selection away
    if (replaced)
        field.selectAll();
    connect(&field, &QLineEdit::inputRejected, this, [this, &field] {
        if (field.text().size() >= kMost)
            tell();
    });
    connect(&field, &QLineEdit::textEdited, this, [this, &field](const QString& text) {
        const int place = field.cursorPosition(), letters = tooMany(text, place);
        if (letters == 0)
            return;
        field.setText(QString(text).remove(place - letters, letters));
        field.setCursorPosition(place - letters);
        tell();
    });
}

void LengthLimits::limit(QPlainTextEdit& field)
{
    const auto changedTo = std::make_shared<int>(0); // where what came in ends: a document may not be changed while it says so
    connect(field.document(), &QTextDocument::contentsChange, this, [changedTo](int place, int, int added) { *changedTo = place + added; });
    connect(&field, &QPlainTextEdit::textChanged, this, [this, &field, changedTo] {
        const QString text = field.toPlainText();
        const int end = std::min(*changedTo, static_cast<int>(text.size())), letters = tooMany(text, end);
        if (letters == 0)
            return;
        QTextCursor rest(field.document());
        rest.setPosition(end - letters);
        rest.setPosition(end, QTextCursor::KeepAnchor);
        rest.removeSelectedText();
        tell();
    });
}

void LengthLimits::tell() { m_say(tr("A field takes %1 letters at most: the rest was not taken.").arg(kMost)); }

} // namespace lubberline::ui
