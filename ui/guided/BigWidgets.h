#pragma once
/// Figures and words large enough for cold hands and bright sun.

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace lubberline::ui {

inline constexpr int kFigure_px = 52, kSentence_px = 24, kTitle_px = 20, kTarget_px = 96;

/// Vermilion that stands 4.5 : 1 apart from the window, light or dark: it is read in the sun.
inline QColor urgentColour(const QPalette& palette)
{
    const bool dark = palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
    return dark ? QColor(0xff, 0x8c, 0x40) : QColor(0xa8, 0x45, 0x00);
}

inline QFont bigFont(QFont font, int pixels, bool bold = false)
{
    font.setPixelSize(pixels);
    font.setBold(bold);
    return font;
}

inline QLabel* bigLabel(const char* name, int pixels, bool bold = false)
{
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setFont(bigFont(label->font(), pixels, bold));
    label->setWordWrap(pixels < kFigure_px);
    return label;
}

/// A line for up to three figures.
inline QLineEdit* bigLine(const char* name, int width_px)
{
    auto* line = new QLineEdit;
    line->setObjectName(QString::fromLatin1(name));
    line->setFont(bigFont(line->font(), kFigure_px));
    line->setMinimumWidth(width_px);
    line->setMaximumWidth(width_px * 2);
    return line;
}

inline QPushButton* bigButton(const QString& text, const char* name)
{
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    button->setFont(bigFont(button->font(), kTitle_px));
    button->setMinimumHeight(48);
    button->setAutoDefault(true); // Enter presses the one that has the focus
    return button;
}

/// Lines of at most so many characters: for buttons and boxes, which do not wrap by themselves.
inline QString inLines(const QString& text, qsizetype most = 54)
{
    QString lines;
    qsizetype length = 0;
    for (const QString& word : text.split(' ')) {
        if (!lines.isEmpty()) {
            const bool over = length + 1 + word.size() > most;
            lines += over ? '\n' : ' ';
            length = over ? 0 : length + 1;
        }
        lines += word;
        length += word.size();
    }
    return lines;
}

} // namespace lubberline::ui
