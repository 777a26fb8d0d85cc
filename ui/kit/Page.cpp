#include "ui/kit/Page.h"

#include <QAction>
#include <QLineEdit>
#include <QScrollArea>

#include <algorithm>

#include "ui/kit/fit/LongWords.h"
#include "ui/plots/base/Plot.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

FleetItem Shown::item() const
{
    if (compass.valid())
        return compass;
    return aircraft.valid() ? FleetItem(aircraft) : FleetItem();
}

namespace {

/// Not by a style sheet: with one, a label keeps the colours of the theme that it was given in.
void setBold(QWidget& widget, bool bold)
{
    QFont font; // all else is that of the page
    font.setBold(bold);
    widget.setFont(font);
}

/// Is scrolled when its window is smaller than its parts at their smallest, and not before: left to itself, Qt reckons with the heights that
/// they wish, as soon as one of them wraps its words.
class PageBody final : public QWidget {
public:
    [[nodiscard]] int heightForWidth(int width) const override { return layout()->minimumHeightForWidth(width); }
};

/// The title stands beside the buttons while they leave it two lines; where it would become a column of words it stands above them.
class PageHead final : public QHBoxLayout {
public:
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override
    {
        return above(width) ? titleHeight(width) + spacing() + toolsHeight() : QHBoxLayout::heightForWidth(width);
    }
    [[nodiscard]] int minimumHeightForWidth(int width) const override
    {
        return above(width) ? heightForWidth(width) : QHBoxLayout::minimumHeightForWidth(width);
    }
    void setGeometry(const QRect& rect) override
    {
        if (!above(rect.width()))
            return QHBoxLayout::setGeometry(rect);
        QLayout::setGeometry(rect);
        const int title = titleHeight(rect.width());
        itemAt(0)->setGeometry({rect.left(), rect.top(), rect.width(), title});
        const bool tight = toolsWidth(false) > rect.width();
        QPoint at(rect.left(), rect.top() + title + spacing());
        for (QLayoutItem* tool : tools()) {
            const int width = tight ? tool->minimumSize().width() : tool->sizeHint().width();
            tool->setGeometry({at, QSize(width, toolsHeight())});
            at.rx() += width + spacing();
        }
    }

private:
    [[nodiscard]] std::vector<QLayoutItem*> tools() const
    {
        std::vector<QLayoutItem*> all;
        for (int i = 1; i < count(); ++i)
            if (!itemAt(i)->isEmpty())
                all.push_back(itemAt(i));
        return all;
    }
    [[nodiscard]] int toolsWidth(bool withGapBefore) const
    {
        int width = withGapBefore ? spacing() : -spacing();
        for (const QLayoutItem* tool : tools())
            width += tool->sizeHint().width() + spacing();
        return width;
    }
    [[nodiscard]] int toolsHeight() const
    {
        int height = 0;
        for (const QLayoutItem* tool : tools())
            height = std::max(height, tool->sizeHint().height());
        return height;
    }
    [[nodiscard]] int titleHeight(int width) const { return itemAt(0)->heightForWidth(width); }
    [[nodiscard]] bool above(int width) const
    {
        const auto beside = tools();
        if (beside.empty() || std::any_of(beside.begin(), beside.end(), [](const QLayoutItem* tool) { return tool->hasHeightForWidth(); }))
            return false;
        const int left = width - toolsWidth(true), line = QFontMetrics(itemAt(0)->widget()->font()).lineSpacing();
        return left <= 0 || (titleHeight(left) > 2 * line + line / 2 && titleHeight(width) < titleHeight(left));
    }
};

/// A page that is larger than its window is scrolled: it never makes the window larger than the screen.
QScrollArea* scrolled(QVBoxLayout& body)
{
    auto* inner = new PageBody;
    inner->setLayout(&body);
    body.setContentsMargins(0, 0, 0, 0);
    body.setSpacing(4);
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("pageScroll"));
    scroll->setWidget(inner);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus); // it stands in nobody's way from field to field
    inner->setAutoFillBackground(false);
    scroll->viewport()->setAutoFillBackground(false);
    return scroll;
}

} // namespace

Page::Page(QWidget* parent) : QWidget(parent), m_title(new QLabel), m_message(new QLabel), m_head(new PageHead), m_body(new QVBoxLayout)
{
    m_title->setObjectName(QStringLiteral("pageTitle"));
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.15);
    large.setBold(true);
    m_title->setFont(large);
    m_title->setWordWrap(true); // whose record it is can always be read, and makes no page wider
    m_message->setObjectName(QStringLiteral("pageMessage"));
    m_message->setWordWrap(true);
    m_message->hide();
    m_head->addWidget(m_title, 1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(8, 6, 8, 6);
    outer->setSpacing(4);
    outer->addLayout(m_head);
    outer->addWidget(m_message);
    outer->addWidget(scrolled(*m_body), 1);
}

/// A field that has the focus loses it while the page goes, and says once more that it was left: to nobody then, as the part of the page
/// that would hear it is gone already.
Page::~Page()
{
    for (QObject* part : findChildren<QObject*>())
        part->disconnect(this);
}

void Page::setTitle(const QString& title)
{
    m_title->setText(breakable(title));
    setAccessibleName(title);
    setWindowTitle(title); // whose record is in front stands in the window's title, too
}

void Page::say(const QString& message)
{
    m_said = message;
    m_message->setText(breakable(inAngleStyle(message)));
    setBold(*m_message, false);
    m_message->setVisible(!message.isEmpty());
}

void Page::restyle()
{
    m_message->setText(breakable(inAngleStyle(m_said)));
    for (Plot* plot : findChildren<Plot*>())
        plot->restyle();
    for (QWidget* part : findChildren<QWidget*>())
        part->update(); // what is painted by hand
    anglesChanged();
}

void Page::refuse(const QString& message)
{
    say(QStringLiteral("✗ ") + message);
    setBold(*m_message, true);
}

void Page::follow(Plot& plot)
{
    connect(&plot, &Plot::readOut, this, &Page::readOut);
    connect(&plot, &Plot::failed, this, &Page::failed);
}

Result<void> Page::open(const FleetItem&) { return {}; }

bool Page::isOf(const FleetItem&) const { return false; }

QStringList Page::unstored() const
{
    QStringList texts;
    for (const QAction* sign : findChildren<QAction*>(QStringLiteral("refusedSign")))
        if (const auto* line = qobject_cast<const QLineEdit*>(sign->parent()))
            texts += line->text();
    return texts;
}

void Page::takeLook(const Page&) {}

} // namespace lubberline::ui
