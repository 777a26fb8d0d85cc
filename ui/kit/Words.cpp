#include "ui/kit/Words.h"

#include <QCoreApplication>

#include <cmath>

namespace lubberline::ui {

namespace {

struct CommonWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Words)
};

} // namespace

QString titleOf(const SwingRecord& record)
{
    QStringList parts;
    for (const std::string& part : {record.type.name, record.aircraft.registration, record.compass.name})
        if (!part.empty())
            parts += toText(part);
    QStringList swing{statedWord(record.swing.kind), statedWord(record.swing.stage)};
    if (record.swing.revision > 1)
        swing += QCoreApplication::translate("lubberline::ui::FleetModel", "rev. %1").arg(record.swing.revision);
    swing.removeAll(QString());
    const QString date
        = record.swing.date.empty() ? QCoreApplication::translate("lubberline::ui::FleetModel", "no date") : toText(record.swing.date);
    parts += QString(date + " " + swing.join(QStringLiteral(", "))).trimmed();
    return parts.join(QStringLiteral(" · "));
}

QString numberText(std::optional<double> value) { return value ? QString::number(*value, 'g', 10) : QString(); }

} // namespace lubberline::ui
