#include "ui/style/Words.h"

#include <QCoreApplication>

#include <cmath>

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Words)
};

} // namespace

QStringList swingKindWords()
{
    return {Words::tr("check swing"), Words::tr("correction swing"), Words::tr("calibration swing"), Words::tr("air swing")};
}

QStringList swingStageWords() { return {Words::tr("as found"), Words::tr("as left")}; }

QStringList radioStateWords() { return {Words::tr("not stated"), Words::tr("on"), Words::tr("off")}; }

QStringList compassKindWords()
{
    return {Words::tr("direct reading"), Words::tr("remote, not stabilised"), Words::tr("remote, gyro-stabilised")};
}

QStringList compensatorWords()
{
    return {Words::tr("not known"), Words::tr("none"), Words::tr("screws"), Words::tr("magnets"), Words::tr("electronic")};
}

QString wordFor(SwingKind kind) { return swingKindWords().at(static_cast<int>(kind)); }
QString wordFor(SwingStage stage) { return swingStageWords().at(static_cast<int>(stage)); }

QString wordFor(SwingState state)
{
    switch (state) {
    case SwingState::Draft:
        return Words::tr("draft");
    case SwingState::Complete:
        return Words::tr("complete");
    case SwingState::Signed:
        break;
    }
    return Words::tr("signed");
}

QString titleOf(const SwingRecord& record)
{
    QStringList parts;
    for (const std::string& part : {record.type.name, record.aircraft.registration, record.compass.name})
        if (!part.empty())
            parts += toText(part);
    const QString swing = Words::tr("%1, %2").arg(wordFor(record.swing.kind), wordFor(record.swing.stage));
    parts += toText(record.swing.date) + " " + swing;
    return parts.join(QStringLiteral(" · "));
}

QString messageOf(const Error& error) { return toText(describe(error)); }

QString signedNumber(double value, int decimals)
{
    const QString digits = QString::number(std::abs(value), 'f', decimals);
    if (digits.toDouble() == 0.0)
        return digits;
    return (value < 0 ? QString(QChar(0x2212)) : QStringLiteral("+")) + digits;
}

QString numberText(std::optional<double> value) { return value ? QString::number(*value, 'g', 10) : QString(); }

} // namespace lubberline::ui
