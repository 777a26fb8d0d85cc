#include "ui/kit/Words.h"

#include <QCoreApplication>

#include <cmath>

namespace lubberline::ui {

namespace {

struct CommonWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Words)
};

} // namespace

QStringList swingKindWords()
{
    return {CommonWords::tr("check swing"), CommonWords::tr("correction swing"), CommonWords::tr("calibration swing"),
        CommonWords::tr("air swing")};
}

QStringList swingStageWords() { return {CommonWords::tr("as found"), CommonWords::tr("as left")}; }

QStringList radioStateWords() { return {CommonWords::tr("not stated"), CommonWords::tr("on"), CommonWords::tr("off")}; }

QStringList compassKindWords()
{
    return {CommonWords::tr("direct reading"), CommonWords::tr("remote, not stabilised"), CommonWords::tr("remote, gyro-stabilised")};
}

QStringList compensatorWords()
{
    return {CommonWords::tr("not known"), CommonWords::tr("none"), CommonWords::tr("screws"), CommonWords::tr("magnets"),
        CommonWords::tr("electronic")};
}

QString wordFor(SwingKind kind) { return swingKindWords().at(static_cast<int>(kind)); }
QString wordFor(SwingStage stage) { return swingStageWords().at(static_cast<int>(stage)); }

QString wordFor(SwingState state)
{
    switch (state) {
    case SwingState::Draft: return CommonWords::tr("draft");
    case SwingState::Complete: return CommonWords::tr("complete");
    case SwingState::Signed: break;
    }
    return CommonWords::tr("signed");
}

QString titleOf(const SwingRecord& record)
{
    QStringList parts;
    for (const std::string& part : {record.type.name, record.aircraft.registration, record.compass.name})
        if (!part.empty())
            parts += toText(part);
    const QString swing = CommonWords::tr("%1, %2").arg(wordFor(record.swing.kind), wordFor(record.swing.stage));
    parts += toText(record.swing.date) + " " + swing;
    return parts.join(QStringLiteral(" · "));
}

QString numberText(std::optional<double> value) { return value ? QString::number(*value, 'g', 10) : QString(); }

} // namespace lubberline::ui
