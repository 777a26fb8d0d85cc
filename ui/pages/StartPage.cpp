#include "ui/pages/StartPage.h"

#include <QCommandLinkButton>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/style/Theme.h"

namespace lubberline::ui {

namespace {

constexpr int kWidth = 560;

QCommandLinkButton* choice(const QString& name, const QString& title, const QString& explanation, const QString& iconName)
{
    auto* button = new QCommandLinkButton(title, explanation);
    button->setObjectName(name);
    button->setIcon(icon(iconName));
    button->setIconSize({32, 32});
    button->setMaximumWidth(kWidth);
    return button;
}

} // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent)
{
    auto* title = new QLabel(tr("Compass swings, from the readings to the correction card"));
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * 1.5);
    title->setFont(large);
    title->setWordWrap(true);
    title->setMaximumWidth(kWidth);
    auto* subtitle = new QLabel(tr("This database is empty. How do you want to begin?"));
    auto* demonstration = choice("demonstrationChoice", tr("&Open the demonstration fleet"),
        tr("Invented aircraft with several years of swings, to look around in. Marked as demonstration data everywhere."), "fleet");
    auto* import = choice("importChoice", tr("&Import a swing"),
        tr("A CSV of readings, an exchange file (.lubberline.json), or a report PDF of Lubberline. You can also drop it on the window."), "import");
    auto* start = choice("newSwingChoice", tr("Start a &new swing"),
        tr("Name the aircraft and its compass, then type the readings: curve and coefficients follow every key."), "swing");
    connect(demonstration, &QCommandLinkButton::clicked, this, &StartPage::demonstrationWanted);
    connect(import, &QCommandLinkButton::clicked, this, &StartPage::importWanted);
    connect(start, &QCommandLinkButton::clicked, this, &StartPage::newSwingWanted);

    auto* layout = new QVBoxLayout(this);
    layout->addStretch(2);
    for (QWidget* widget : {static_cast<QWidget*>(title), static_cast<QWidget*>(subtitle), static_cast<QWidget*>(demonstration),
             static_cast<QWidget*>(import), static_cast<QWidget*>(start)}) {
        widget->setMinimumWidth(kWidth);
        layout->addWidget(widget, 0, Qt::AlignHCenter);
        layout->addSpacing(8);
    }
    layout->addStretch(3);
    setFocusProxy(demonstration);
}

} // namespace lubberline::ui
