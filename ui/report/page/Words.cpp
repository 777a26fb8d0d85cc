#include "ui/report/page/Words.h"

#include <QStringList>

namespace lubberline::ui {

QString bannerFor(const SwingRecord& record)
{
    QStringList marks;
    if (record.aircraft.demonstration)
        marks += Words::tr("DEMONSTRATION DATA");
    if (record.swing.state == SwingState::Draft)
        marks += Words::tr("DRAFT — NOT SIGNED");
    return joined(marks);
}

QString configurationWords(const Configuration& configuration)
{
    const QString radio
        = configuration.radio == RadioState::NotStated ? QString() : labelled(Words::tr("radio"), wordFor(configuration.radio));
    return joined({labelled(Words::tr("engines"), printable(configuration.engines)), radio,
        labelled(Words::tr("electrics"), printable(configuration.electrics)), printable(configuration.other)});
}

QString printable(const std::string& text)
{
    QString line = QString::fromStdString(text);
    for (QChar& c : line)
        if (c.category() == QChar::Other_Control || c.isNonCharacter())
            c = QChar(' ');
    return line.simplified();
}

QString signedAs(const SignatureState& state)
{
    QStringList parts;
    for (const SwingDifference& one : state.since) {
        const QString before = printable(one.before);
        parts += QStringLiteral("%1: %2").arg(printable(one.what), before.isEmpty() ? notStated() : before);
    }
    return parts.isEmpty() ? QString() : Words::tr("signed as %1").arg(parts.join(QStringLiteral(", ")));
}

QString signedAs(const std::vector<SignatureState>& states)
{
    QStringList all;
    for (const auto& state : states)
        if (state.holds)
            all += signedAs(state);
    all.removeDuplicates();
    return joined(all);
}

QString notStated() { return Words::tr("not stated"); }

QString joined(const QStringList& parts)
{
    QStringList stated = parts;
    stated.removeAll(QString());
    return stated.join(QStringLiteral(" · "));
}

QString labelled(const QString& label, const QString& text)
{
    return text.isEmpty() ? QString() : QStringLiteral("%1 %2").arg(label, text);
}

} // namespace lubberline::ui
