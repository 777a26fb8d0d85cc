#include "ui/fleet/StartPage.h"

#include <QCommandLinkButton>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/kit/Theme.h"

namespace lubberline::ui {

namespace {

constexpr int kWidth = 560;

QCommandLinkButton* choice(const QString& name, const QString& title, const QString& explanation, const QString& iconName)
{
    auto* button = new QCommandLinkButton(title, explanation);
    button->setObjectName(name);
    button->setIcon(icon(iconName));
    button->setIconSize({32, 32});
    button->setStyleSheet(QStringLiteral("QCommandLinkButton:focus { border: 2px solid palette(highlight); border-radius: 3px; }")); // seen
    button->setMinimumHeight(button->heightForWidth(kWidth)); // the whole explanation, whatever the font
    return button;
}

} // namespace

StartPage::StartPage(QWidget* parent) : Page(parent)
{
    setTitle(tr("Compass swings, from the readings to the correction card"));
    auto* subtitle = new QLabel(tr("This database is empty. How do you want to begin?"));
    auto* demonstration = choice("demonstrationChoice", tr("&Open the demonstration fleet"),
        tr("Invented aircraft with several years of swings, to look around in. Marked as demonstration data everywhere."), "fleet");
    auto* import = choice("importChoice", tr("&Import a swing"),
        tr("A CSV of readings, an exchange file (.lubberline.json), or a report PDF of Lubberline. You can also drop it on the window."),
        "import");
    auto* start = choice("newSwingChoice", tr("Start a &new swing"),
        tr("Name the aircraft and its compass, then type the readings: curve and coefficients follow every key."), "swing");
    connect(demonstration, &QCommandLinkButton::clicked, this, &StartPage::demonstrationWanted);
    connect(import, &QCommandLinkButton::clicked, this, &StartPage::importWanted);
    connect(start, &QCommandLinkButton::clicked, this, &StartPage::newSwingWanted);

    auto* inner = new QWidget;
    inner->setFixedWidth(kWidth);
    auto* column = new QVBoxLayout(inner);
    column->setSpacing(12);
    for (QWidget* widget : {static_cast<QWidget*>(subtitle), static_cast<QWidget*>(demonstration), static_cast<QWidget*>(import),
             static_cast<QWidget*>(start)})
        column->addWidget(widget);
    body().addStretch(2);
    body().addWidget(inner, 0, Qt::AlignHCenter);
    body().addStretch(3);
    setFocusProxy(demonstration);
}

} // namespace lubberline::ui
