#pragma once
/// One figure with its unit and a slider beside it: dragging plays, letting go settles.

#include <QDoubleSpinBox>
#include <QWidget>

class QLabel;

namespace lubberline::ui {

class PlaySlider;

/// Figures as everywhere in the window: decimal point (a comma is taken as one), and the wheel scrolls the page.
class NumberSpin : public QDoubleSpinBox {
    Q_OBJECT

public:
    using QDoubleSpinBox::QDoubleSpinBox;
    /// Narrow enough for three beside each other; what does not fit can be scrolled to.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QString textFromValue(double value) const override;
    QValidator::State validate(QString& text, int& position) const override;
};

struct ParameterSpec {
    QString name;  ///< of the spin box; the slider's ends on "Slider"
    QString label; ///< "P"
    QString meaning;
    QString suffix; ///< " nT"
    int decimals = 1;
    double low = 0, high = 1;   ///< the slider's ends
    double least = 0, most = 1; ///< what may be typed
    bool curved = false;        ///< the slider is finer near zero: it goes with the square
};

class ParameterCell : public QWidget {
    Q_OBJECT

public:
    explicit ParameterCell(const ParameterSpec& spec, QWidget* parent = nullptr);

    /// Shown without a signal.
    void setValue(double value);
    [[nodiscard]] double value() const { return m_value; }
    /// Other ends of the slider, which are those of typing too.
    void setRange(double low, double high);

signals:
    void played(double value); ///< by the slider, a step or a key
    void settled();            ///< the slider was let go, or the cell left; also when nothing was changed

private:
    void playTyped(double value);
    void playSlider(int position);
    void playSteps(int steps, bool coarse);
    void reset();
    [[nodiscard]] double valueAt(double part) const; ///< −1 … 1 of the slider's way
    [[nodiscard]] double partOf(double value) const;
    void placeSlider();

    QLabel* m_label;
    NumberSpin* m_spin;
    PlaySlider* m_slider;
    double m_low, m_high;
    bool m_curved;
    double m_value = 0; ///< as given, whatever is shown of it
};

} // namespace lubberline::ui
