#include "ui/sensor/ParameterCell.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyle>

#include <algorithm>
#include <cmath>

#include "ui/kit/PlaySlider.h"

namespace lubberline::ui {

namespace {

constexpr int kSliderSteps = 1000; // each side of the middle: finer than a pixel of the slider

/// For Qt's spin box, which reads its own text, with the unit behind it: the signs that core's reader takes.
QString plainDigits(QString text)
{
    for (const char16_t minus : {u'\u2212', u'\u2013', u'\u2010', u'\u2011'})
        text.replace(QChar(minus), '-');
    return text.replace(',', '.');
}

} // namespace

QSize NumberSpin::sizeHint() const
{
    const QSize usual = QDoubleSpinBox::sizeHint();
    const int digits = fontMetrics().horizontalAdvance(QStringLiteral("-00000.0 nT"));
    return {std::min(usual.width(), digits + style()->pixelMetric(QStyle::PM_ScrollBarExtent) + 14), usual.height()};
}

double NumberSpin::valueFromText(const QString& text) const { return QDoubleSpinBox::valueFromText(plainDigits(text)); }

QString NumberSpin::textFromValue(double value) const
{
    // Minus zero is no figure.
    return QString::number(std::abs(value) < 0.5 * std::pow(10.0, -decimals()) ? 0.0 : value, 'f', decimals());
}

QValidator::State NumberSpin::validate(QString& text, int& position) const
{
    QString plain = plainDigits(text); // as long as what was typed
    return QDoubleSpinBox::validate(plain, position);
}

ParameterCell::ParameterCell(const ParameterSpec& spec, QWidget* parent)
    : QWidget(parent)
    , m_label(new QLabel(spec.label))
    , m_spin(new NumberSpin)
    , m_slider(new PlaySlider(Qt::Horizontal))
    , m_low(spec.low)
    , m_high(spec.high)
    , m_curved(spec.curved)
{
    m_spin->setLocale(QLocale::c());
    m_spin->setObjectName(spec.name);
    m_spin->setAccessibleName(spec.meaning);
    m_spin->setToolTip(spec.meaning);
    m_spin->setDecimals(spec.decimals);
    m_spin->setSuffix(spec.suffix);
    m_spin->setRange(spec.least, spec.most);
    m_spin->setSingleStep((spec.high - spec.low) / 200);
    m_slider->setObjectName(spec.name + QStringLiteral("Slider"));
    m_slider->setAccessibleName(spec.meaning);
    m_slider->setToolTip(
        tr("%1\nArrow keys, or Shift while dragging: fine steps; page keys: coarse ones; double click: back to zero").arg(spec.meaning));
    m_slider->setRange(-kSliderSteps, kSliderSteps);
    m_slider->setSingleStep(1);
    m_slider->setPageStep(kSliderSteps / 10);
    m_slider->setMinimumWidth(40);
    m_label->setBuddy(m_spin);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(4);
    layout->setVerticalSpacing(0);
    layout->addWidget(m_label, 0, 0);
    layout->addWidget(m_slider, 0, 1);
    layout->addWidget(m_spin, 1, 0, 1, 2);
    layout->setColumnStretch(1, 1);
    setTabOrder(m_slider, m_spin); // as they stand
    setFocusProxy(m_spin);
    setValue(0);
    connect(m_spin, &QDoubleSpinBox::valueChanged, this, &ParameterCell::playTyped);
    connect(m_spin, &QDoubleSpinBox::editingFinished, this, &ParameterCell::settled);
    connect(m_slider, &QSlider::valueChanged, this, &ParameterCell::playSlider);
    connect(m_slider, &PlaySlider::letGo, this, &ParameterCell::settled);
    connect(m_slider, &PlaySlider::stepped, this, &ParameterCell::playSteps);
    connect(m_slider, &PlaySlider::resetWanted, this, &ParameterCell::reset);
}

double ParameterCell::valueAt(double part) const
{
    if (!m_curved)
        return ((m_high + m_low) + part * (m_high - m_low)) / 2;
    if (m_low == -m_high)
        return part * std::abs(part) * m_high;
    const double way = (part + 1) / 2; // from zero on
    return m_low + way * way * (m_high - m_low);
}

double ParameterCell::partOf(double value) const
{
    if (!m_curved)
        return (2 * value - m_low - m_high) / (m_high - m_low);
    if (m_low == -m_high)
        return std::copysign(std::sqrt(std::abs(value) / m_high), value);
    return 2 * std::sqrt(std::max(0.0, (value - m_low) / (m_high - m_low))) - 1;
}

void ParameterCell::setValue(double value)
{
    m_value = value;
    const bool shown = std::abs(m_spin->value() - value) <= 0.5 * std::pow(10.0, -m_spin->decimals());
    if (!shown || !m_spin->hasFocus()) { // what is being typed is not written anew
        const QSignalBlocker noSpin(m_spin);
        m_spin->setValue(value);
    }
    placeSlider();
}

void ParameterCell::setRange(double low, double high)
{
    m_low = low;
    m_high = high;
    const QSignalBlocker noSpin(m_spin);
    m_spin->setRange(low, high);
    m_spin->setSingleStep((high - low) / 200);
    setValue(std::clamp(m_value, low, high));
}

void ParameterCell::placeSlider()
{
    const QSignalBlocker noSlider(m_slider);
    m_slider->setValue(static_cast<int>(std::lround(std::clamp(partOf(m_value), -1.0, 1.0) * kSliderSteps)));
}

void ParameterCell::playTyped(double value)
{
    m_value = value;
    placeSlider();
    emit played(value);
}

void ParameterCell::playSlider(int position)
{
    const QSignalBlocker noSpin(m_spin);
    m_spin->setValue(valueAt(static_cast<double>(position) / kSliderSteps));
    m_value = m_spin->value(); // what is read is what acts
    emit played(m_value);
}

void ParameterCell::playSteps(int steps, bool coarse)
{
    constexpr double kFine = 1.0 / 4000, kCoarse = 1.0 / 80; // of the slider's way: 10 nT and 500 nT of hard iron
    const double wanted = m_value + steps * (coarse ? kCoarse : kFine) * (m_high - m_low);
    const QSignalBlocker noSpin(m_spin);
    m_spin->setValue(std::clamp(wanted, std::min(m_low, m_value), std::max(m_high, m_value)));
    m_value = m_spin->value();
    placeSlider();
    emit played(m_value);
}

void ParameterCell::reset()
{
    const QSignalBlocker noSpin(m_spin);
    m_spin->setValue(std::clamp(0.0, m_low, m_high));
    m_value = m_spin->value();
    placeSlider();
    emit played(m_value);
    emit settled();
}

} // namespace lubberline::ui
