#include "ui/earth/AssumedIronForm.h"

#include <QFormLayout>
#include <QLineEdit>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

AssumedIronForm::AssumedIronForm(QFormLayout& form, QObject* parent)
    : QObject(parent)
    , m_sizes{Size{tr("Soft iron c, f:"), &AssumedIron::verticalSoft}, {tr("Hard iron P, Q (nT):"), &AssumedIron::hardIron_nT},
          {tr("Compensating magnets (nT):"), &AssumedIron::compensator_nT},
          {tr("One cycle of the compass (°):"), &AssumedIron::compassOneCycle_deg}}
{
    static constexpr std::array names{"assumedSoft", "assumedHard", "assumedMagnets", "assumedOneCycle"};
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        Size& size = m_sizes[i];
        size.line = new QLineEdit(toText(shortestNumber(AssumedIron{}.*size.value)));
        size.line->setObjectName(QString::fromLatin1(names[i]));
        size.line->setToolTip(
            tr("How large it may be (a standard deviation), where the swing cannot tell: the band and the verdict rest on it"));
        connect(size.line, &QLineEdit::editingFinished, this, &AssumedIronForm::changed);
        form.addRow(size.name, size.line);
    }
}

Result<AssumedIron> AssumedIronForm::assumed() const
{
    AssumedIron assumed;
    for (const Size& size : m_sizes) {
        const std::string typed = size.line->text().trimmed().toStdString();
        const FileNumber number = readNumber(typed, true);
        const double most = kMostAssumed.*size.value;
        if (number.fault != NumberFault::None || !(number.value > 0) || number.value > most)
            return Error{ErrorCode::InvalidInput,
                said(tr("%1 %2 is no size; expected a number above 0, %3 at most")
                         .arg(size.name, toText(inQuotes(typed)), toText(shortestNumber(most))))};
        assumed.*size.value = number.value;
    }
    return assumed;
}

} // namespace lubberline::ui
