#include "ui/report/page/Words.h"

#include <QStringList>

namespace lubberline::ui {

QString wordsFor(SwingKind kind)
{
    switch (kind) {
    case SwingKind::Check: return Words::tr("check swing");
    case SwingKind::Correction: return Words::tr("correction swing");
    case SwingKind::Calibration: return Words::tr("calibration swing");
    case SwingKind::Air: return Words::tr("air swing");
    }
    return {};
}

QString wordsFor(SwingStage stage) { return stage == SwingStage::AsFound ? Words::tr("as found") : Words::tr("as left"); }

QString wordsFor(SwingState state)
{
    switch (state) {
    case SwingState::Draft: return Words::tr("draft");
    case SwingState::Complete: return Words::tr("complete, not yet signed");
    case SwingState::Signed: return Words::tr("signed");
    }
    return {};
}

QString wordsFor(RadioState radio)
{
    switch (radio) {
    case RadioState::NotStated: return {};
    case RadioState::On: return Words::tr("radio on");
    case RadioState::Off: return Words::tr("radio off");
    }
    return {};
}

QString wordsFor(CompassKind kind)
{
    switch (kind) {
    case CompassKind::DirectReading: return Words::tr("direct reading");
    case CompassKind::RemoteUnstabilised: return Words::tr("remote reading, not stabilised");
    case CompassKind::RemoteStabilised: return Words::tr("remote reading, gyro-stabilised");
    }
    return {};
}

QString wordsFor(Compensator compensator)
{
    switch (compensator) {
    case Compensator::Unknown: return {};
    case Compensator::None: return Words::tr("no compensator");
    case Compensator::Screws: return Words::tr("compensated by screws");
    case Compensator::Magnets: return Words::tr("compensated by magnets");
    case Compensator::Electronic: return Words::tr("compensated electronically");
    }
    return {};
}

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
    return joined({labelled(Words::tr("engines"), printable(configuration.engines)), wordsFor(configuration.radio),
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
