#include "ui/text/Translated.h"

#include <QCoreApplication>

namespace lubberline::ui {

namespace {

/// English where nothing is translated: Qt would leave "reading(s)" as it stands.
std::string inReadersLanguage(const Pattern& pattern, std::int64_t count)
{
    const QString source = QString::fromUtf8(pattern.english);
    QString text = QCoreApplication::translate(pattern.context, pattern.english, nullptr, static_cast<int>(count));
    if (count < 0)
        return text.toStdString();
    if (text == QString(source).replace(QLatin1String("%n"), QString::number(count)))
        text.replace(QLatin1String("(s)"), count == 1 ? QString() : QStringLiteral("s"));
    return text.toStdString(); // %n is in it already
}

} // namespace

QString translated(const Message& message) { return QString::fromStdString(message.in(inReadersLanguage)); }

QString messageOf(const Error& error) { return translated(described(error)); }

Message said(const QString& text) { return Message::verbatim(text.toStdString()); }

} // namespace lubberline::ui
