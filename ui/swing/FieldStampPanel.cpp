#include "ui/swing/FieldStampPanel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>

#include "core/angle/AngleText.h"
#include "core/swing/SwingField.h"
#include "ui/kit/Words.h"
#include "ui/swing/SwingEditor.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

QString angleText(double angle_deg) { return shownAngle(angle_deg); }

QString valuesOf(const FieldStamp& stamp)
{
    return FieldStampPanel::tr("Earth's field: H %1 nT · dip %2 · variation %3 · %4 for %5")
        .arg(QString::number(stamp.field.horizontal_nT(), 'f', 0), angleText(toDegrees(stamp.field.inclination_rad())),
            angleText(stamp.field.variation().degrees()), toText(stamp.model), toText(stamp.date));
}

QLabel* wrappingLabel(const QString& name)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    return label;
}

} // namespace

FieldStampPanel::FieldStampPanel(SwingEditor& editor, QWidget* parent)
    : QWidget(parent)
    , m_editor(editor)
    , m_values(new QLabel)
    , m_difference(wrappingLabel(QStringLiteral("fieldDifference")))
    , m_take(new QPushButton)
    , m_variation(wrappingLabel(QStringLiteral("fieldVariation")))
{
    setObjectName(QStringLiteral("fieldStampPanel"));
    m_values->setObjectName(QStringLiteral("fieldValues"));
    m_values->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_take->setObjectName(QStringLiteral("takeField"));
    m_values->setMinimumWidth(1); // a narrow window cuts it; the tip has all figures
    auto* line = new QHBoxLayout;
    line->setSpacing(12);
    line->addWidget(m_values);
    line->addWidget(m_difference, 1);
    line->addWidget(m_take);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(line);
    layout->addWidget(m_variation);
    connect(m_take, &QPushButton::clicked, this, &FieldStampPanel::take);
    connect(&editor, &SwingEditor::opened, this, &FieldStampPanel::showRecord);
    connect(&editor, &SwingEditor::changed, this, &FieldStampPanel::showRecord);
    showRecord();
}

void FieldStampPanel::showRecord()
{
    const SwingRecord& record = m_editor.record();
    const auto& stamp = record.swing.field;
    m_now = stampFor(record.swing, record.site);
    m_values->setText(stamp ? valuesOf(*stamp) : tr("Earth's field: not kept with this swing."));
    m_values->setToolTip(stamp ? tr("X %1, Y %2, Z %3 nT at %4, %5, %6 m")
                                     .arg(signedNumber(stamp->field.north_nT, 1), signedNumber(stamp->field.east_nT, 1),
                                         signedNumber(stamp->field.down_nT, 1), signedNumber(stamp->place.latitude_deg, 4),
                                         signedNumber(stamp->place.longitude_deg, 4), QString::number(stamp->place.height_m, 'f', 0))
                               : QString());
    const QString difference = this->difference();
    m_difference->setText(inAngleStyle(difference));
    m_take->setText(stamp ? tr("&Take the new values") : tr("&Keep the field of site and date"));
    m_take->setVisible(m_now && (!stamp || !difference.isEmpty()) && m_editor.particularsEditable());
    const QString doubtful = doubtfulVariation();
    m_variation->setText(inAngleStyle(doubtful));
    m_variation->setVisible(!doubtful.isEmpty());
    setVisible(stamp || m_now || !doubtful.isEmpty());
}

QString FieldStampPanel::difference() const
{
    const Swing& swing = m_editor.record().swing;
    const StampState state = stateOf(swing, m_editor.record().site);
    if (state == StampState::None || state == StampState::Current)
        return {};
    const QString now = tr("H %1 nT · dip %2 · variation %3")
                            .arg(QString::number(m_now->field.horizontal_nT(), 'f', 0),
                                angleText(toDegrees(m_now->field.inclination_rad())), angleText(m_now->field.variation().degrees()));
    return state == StampState::PlaceChanged ? tr("Site or date have changed since: there it is %1.").arg(now)
                                             : tr("By %1 it is now %2.").arg(toText(m_now->model), now);
}

QString FieldStampPanel::doubtfulVariation() const
{
    const Swing& swing = m_editor.record().swing;
    const auto beyond_deg = variationBeyondStamp_deg(swing);
    QStringList words;
    if (beyond_deg && std::abs(*beyond_deg) > kDoubtfulVariation_deg)
        words += tr("The variation stated, %1, differs by %2 from the field's: look at variation, site and date again.")
                     .arg(angleText(*swing.variation_deg), angleText(*beyond_deg));
    // The base and its survey may disagree with the model, or with each other, though the swing states nothing.
    const auto& site = m_editor.record().site;
    if (const Message doubt = variationDisagreement(site, swing.field ? swing.field : m_now, swing.variation_deg); !doubt.empty())
        words += QStringLiteral("▲ ") + toText(doubt);
    return words.join(QStringLiteral(" "));
}

void FieldStampPanel::take()
{
    if (!m_now)
        return;
    Swing after = m_editor.record().swing;
    after.field = m_now;
    m_editor.changeParticulars(after, tr("Earth's field"));
}

} // namespace lubberline::ui
