#include "ui/kit/Theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

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

} // namespace

void applyTheme(bool dark)
{
    if (QApplication::style()->objectName().compare("fusion", Qt::CaseInsensitive) != 0)
        QApplication::setStyle(QStyleFactory::create("Fusion"));
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
