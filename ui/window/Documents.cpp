#include "ui/window/Documents.h"

#include <QDateTime>
#include <QRegularExpression>

#include "ui/readings/SwingEditor.h"
#include "ui/style/Words.h"

namespace lubberline::ui {

namespace {

QString nowUtc() { return QDateTime::currentDateTimeUtc().toString(Qt::ISODate); }

Result<std::shared_ptr<const Analysis>> analysisOf(const SwingEditor& editor)
{
    if (editor.analysis())
        return editor.analysis();
    return Error{ErrorCode::InvalidInput, editor.whyNoAnalysis().toStdString()};
}

} // namespace

Result<ReportInput> reportOf(const SwingEditor& editor, AngleStyle style)
{
    const auto analysis = analysisOf(editor);
    if (!analysis)
        return analysis.error();
    ReportInput input;
    input.record = editor.record();
    input.analysis = **analysis;
    input.previous = editor.previous();
    input.angleStyle = style;
    input.madeAtUtc = nowUtc();
    return input;
}

Result<CardInput> cardOf(const SwingEditor& editor, int step_deg)
{
    const auto analysis = analysisOf(editor);
    if (!analysis)
        return analysis.error();
    CardOptions options;
    options.step_deg = step_deg;
    auto card = makeCard(**analysis, options);
    if (!card)
        return card.error();
    return CardInput{editor.record(), {{SwingEditor::tr("STEER"), std::move(card.value())}}, nowUtc(), options};
}

QString fileStem(const SwingRecord& record)
{
    QString stem = toText(record.aircraft.registration + " " + record.compass.name + " " + record.swing.date);
    static const QRegularExpression disliked(QStringLiteral("[^\\w .-]"), QRegularExpression::UseUnicodePropertiesOption);
    return stem.replace(disliked, QStringLiteral("-")).simplified();
}

} // namespace lubberline::ui
