#include "ui/kit/Theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>

// In a static library, resources must be asked for; the macro wants to be outside any namespace.
static void initResources() { Q_INIT_RESOURCE(lubberline); }

namespace lubberline::ui {

namespace {

QPalette darkPalette()
{
    const QColor window(0x2b, 0x2d, 0x30), base(0x1f, 0x21, 0x24), text(0xe2, 0xe4, 0xe6), disabled(0x82, 0x86, 0x8a);
    const QColor accent(0x3d, 0x7e, 0xbd);
    QPalette palette(window);
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::AlternateBase, QColor(0x26, 0x28, 0x2b));
    palette.setColor(QPalette::ToolTipBase, window);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText}) {
        palette.setColor(role, text);
        palette.setColor(QPalette::Disabled, role, disabled);
    }
    palette.setColor(QPalette::PlaceholderText, disabled);
    palette.setColor(QPalette::Highlight, accent);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, QColor(0x6f, 0xb1, 0xec));
    return palette;
}

/// Fusion's outlines are darker than the window: around what is filled in or ticked on a dark one nobody sees them. There they are drawn
/// again between the colours of window and text, 3 : 1 apart from what is beside them.
class Outlined : public QProxyStyle {
public:
    Outlined() : QProxyStyle(QStringLiteral("Fusion")) {}

    void drawPrimitive(PrimitiveElement what, const QStyleOption* option, QPainter* painter, const QWidget* widget) const override
    {
        QProxyStyle::drawPrimitive(what, option, painter, widget);
        const bool tabbed = option->state & State_KeyboardFocusChange; // a tick shows focus to who came by keyboard
        if (what == PE_IndicatorCheckBox || what == PE_IndicatorRadioButton)
            outline(*option, tabbed, *painter, what == PE_IndicatorRadioButton ? option->rect.width() : 0);
        else if (what == PE_FrameLineEdit)
            outline(*option, true, *painter, kRounded);
    }

    void drawComplexControl(ComplexControl what, const QStyleOptionComplex* option, QPainter* painter, const QWidget* widget) const override
    {
        QProxyStyle::drawComplexControl(what, option, painter, widget);
        if (what == CC_SpinBox || what == CC_ComboBox)
            outline(*option, true, *painter, kRounded);
    }

    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* more) const override
    {
        if (hint == SH_Table_GridLineColor && option && isDark(option->palette)) // else nobody sees where the next cell is to be filled in
            return static_cast<int>(between(option->palette, 25).rgba());
        return QProxyStyle::styleHint(hint, option, widget, more);
    }

private:
    static constexpr double kRounded = 4;

    static bool isDark(const QPalette& palette)
    {
        return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
    }

    /// @param share  of the text's colour [%]
    static QColor between(const QPalette& palette, int share)
    {
        const QColor window = palette.color(QPalette::Window), text = palette.color(QPalette::WindowText);
        const auto mixed = [share](int from, int to) { return (from * (100 - share) + to * share) / 100; };
        return {mixed(window.red(), text.red()), mixed(window.green(), text.green()), mixed(window.blue(), text.blue())};
    }

    static void outline(const QStyleOption& option, bool showsFocus, QPainter& painter, double rounded)
    {
        if (!isDark(option.palette))
            return;
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing, rounded > 0);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(showsFocus && option.state & State_HasFocus ? option.palette.color(QPalette::Link) : between(option.palette, 45));
        painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), rounded / 2, rounded / 2);
        painter.restore();
    }
};

} // namespace

void applyTheme(bool dark)
{
    if (!dynamic_cast<Outlined*>(QApplication::style()))
        QApplication::setStyle(new Outlined);
    QApplication::setPalette(dark ? darkPalette() : QApplication::style()->standardPalette());
}

void applyTextSize(int percent)
{
    static const double desktops_pt = QApplication::font().pointSizeF(); // asked once: what follows is ours
    QFont font = QApplication::font();
    const double wanted_pt = desktops_pt * percent / 100.0;
    if (desktops_pt <= 0 || font.pointSizeF() == wanted_pt) // a font in pixels is a test's
        return;
    font.setPointSizeF(wanted_pt);
    QApplication::setFont(font);
}

QIcon icon(const QString& name)
{
    static const bool initialised = (initResources(), true);
    Q_UNUSED(initialised);
    return QIcon(QStringLiteral(":/icons/%1.svg").arg(name));
}

} // namespace lubberline::ui
