#include "ui/swing/Documents.h"

#include <QRegularExpression>

#include "ui/kit/Words.h"

namespace lubberline::ui {

QString fileStem(const SwingRecord& record)
{
    QString stem = toText(record.aircraft.registration + " " + record.compass.name + " " + record.swing.date.text());
    static const QRegularExpression disliked(QStringLiteral("[^\\w .-]"), QRegularExpression::UseUnicodePropertiesOption);
    return stem.replace(disliked, QStringLiteral("-")).simplified();
}

} // namespace lubberline::ui
