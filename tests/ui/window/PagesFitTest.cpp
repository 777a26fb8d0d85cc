// No page makes the window larger than a small screen or scrolls sideways, and on it no words of a label, a button, a group, a heading or a choice
// are clipped and nothing is outside, at any scale and with words a third longer. The scale and the screen are those of a process: each is looked at in
// one of its own, this program once more.

#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QProcess>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTranslator>

#include <cstdio>

#include "tests/ui/window/EveryPage.h"
#include "ui/plots/base/Plot.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

constexpr QSize kSmallScreen{1024, 700};

/// Every text of the window, a third longer.
class LongerWords final : public QTranslator {
public:
    QString translate(const char* context, const char* source, const char*, int) const override
    {
        const QString text = QString::fromUtf8(source);
        static const QRegularExpression keys(QStringLiteral("^((Ctrl|Alt|Shift)\\+.*|F\\d+)$"));
        if (QByteArrayView(context) == "QShortcut" || text.contains(keys))
            return {};
        QString more;
        for (qsizetype left = (text.size() + 2) / 3; left > 0; left -= 4)
            more += QStringLiteral(" äöüw").left(static_cast<int>(std::min<qsizetype>(left + 1, 5)));
        return text.contains(' ') ? text + more : text + more.remove(' ');
    }
    bool isEmpty() const override { return false; }
};

QString nameOf(const QWidget& widget)
{
    QString name = QString::fromLatin1(widget.metaObject()->className()) + ' ' + widget.objectName();
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        name += QStringLiteral(" “%1”").arg(label->text().left(60));
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        name += QStringLiteral(" “%1”").arg(button->text());
    return name;
}

template <class Ancestor>
bool inside(const QWidget& widget)
{
    for (const QWidget* above = widget.parentWidget(); above; above = above->parentWidget())
        if (qobject_cast<const Ancestor*>(above))
            return true;
    return false;
}

/// What of a widget cannot be read or reached; empty: all of it can.
QString misfit(const QWidget& widget, const QWidget& window)
{
    const bool scrolled = inside<QAbstractScrollArea>(widget);
    if (!scrolled && !window.rect().contains(QRect(widget.mapTo(&window, QPoint()), widget.size())))
        return QStringLiteral("outside the window");
    const auto* label = qobject_cast<const QLabel*>(&widget);
    if (label && label->text().isEmpty())
        return {};
    if (label && label->wordWrap() && label->heightForWidth(label->width()) > label->height() + 1)
        return QStringLiteral("wants %1 px of height, has %2").arg(label->heightForWidth(label->width())).arg(label->height());
    const bool worded = label || qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QGroupBox*>(&widget);
    const QSize least = widget.minimumSizeHint();
    if (worded && (least.width() > widget.width() + 1 || least.height() > widget.height() + 1))
        return QStringLiteral("wants %1×%2 px, has %3×%4").arg(least.width()).arg(least.height()).arg(widget.width()).arg(widget.height());
    return {};
}

/// What scrolls in a form or a page does so downwards.
QString sideways(const QWidget& widget)
{
    const auto* area = qobject_cast<const QScrollArea*>(&widget);
    if (!area || !area->widget())
        return {};
    const int wanted = area->widget()->minimumSizeHint().width(), has = area->viewport()->width();
    return area->horizontalScrollBar()->maximum() > 0 || wanted > has
        ? QStringLiteral("scrolls sideways: wants %1 px, has %2").arg(wanted).arg(has)
        : QString();
}

QString cutHeading(const QWidget& widget)
{
    const auto* header = qobject_cast<const QHeaderView*>(&widget);
    if (!header || header->orientation() != Qt::Horizontal)
        return {};
    if (header->sizeHint().height() > header->height() + 1)
        return QStringLiteral("headings want %1 px of height, have %2").arg(header->sizeHint().height()).arg(header->height());
    for (int section = 0; section < header->count(); ++section)
        if (!header->isSectionHidden(section) && header->sectionSizeHint(section) > header->sectionSize(section))
            return QStringLiteral("the heading “%1” wants %2 px, has %3")
                .arg(header->model()->headerData(section, Qt::Horizontal).toString())
                .arg(header->sectionSizeHint(section))
                .arg(header->sectionSize(section));
    return {};
}

QString cutChoice(const QWidget& widget)
{
    const auto* box = qobject_cast<const QComboBox*>(&widget);
    if (!box)
        return {};
    QStyleOptionComboBox option;
    option.initFrom(box);
    const int has = box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box).width();
    const int wants = box->fontMetrics().horizontalAdvance(box->currentText());
    return wants > has ? QStringLiteral("“%1” wants %2 px, has %3").arg(box->currentText()).arg(wants).arg(has) : QString();
}

/// Of the cells that are seen: a word that is broken, lines that have no room.
QString cutCell(const QWidget& widget)
{
    const auto* table = qobject_cast<const QTableView*>(&widget);
    if (!table || table->verticalHeader()->count() == 0 || table->verticalHeader()->sectionResizeMode(0) == QHeaderView::Fixed)
        return {};
    const QAbstractItemView& view = *table;
    for (int row = std::max(0, table->rowAt(0)); row <= table->rowAt(table->viewport()->height() - 1); ++row)
        if (view.sizeHintForRow(row) > table->rowHeight(row) + 1)
            return QStringLiteral("row %1 wants %2 px of height, has %3").arg(row).arg(view.sizeHintForRow(row)).arg(table->rowHeight(row));
    return {};
}

/// Parts of one layout that lie over each other.
QString overlap(const QWidget& widget)
{
    if (!widget.layout() || widget.objectName().startsWith(QStringLiteral("qt_")))
        return {};
    QList<const QWidget*> seen;
    for (int i = 0; i < widget.layout()->count(); ++i)
        if (const QWidget* part = widget.layout()->itemAt(i)->widget(); part && part->isVisible()) {
            for (const QWidget* other : seen)
                if (other->geometry().intersects(part->geometry()))
                    return nameOf(*part) + QStringLiteral(" lies over ") + nameOf(*other);
            seen += part;
        }
    return {};
}

QStringList misfitsOf(MainWindow& window)
{
    QStringList found;
    const QSize screen = window.screen()->availableSize(), least = window.minimumSizeHint();
    if (least.width() > screen.width() || least.height() > screen.height())
        found += QStringLiteral("the window wants at least %1×%2").arg(least.width()).arg(least.height());
    if (window.width() > screen.width() || window.height() > screen.height())
        found += QStringLiteral("the window has grown to %1×%2").arg(window.width()).arg(window.height());
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible())
            continue;
        for (const QString& what : {sideways(*widget), cutHeading(*widget), cutChoice(*widget), cutCell(*widget), overlap(*widget)})
            if (!what.isEmpty())
                found
                    += nameOf(*(qobject_cast<const QHeaderView*>(widget) ? widget->parentWidget() : widget)) + QStringLiteral(": ") + what;
        if (widget->objectName().startsWith(QStringLiteral("qt_")) || inside<QAbstractItemView>(*widget) || inside<QComboBox>(*widget)
            || inside<QTabBar>(*widget) || inside<Plot>(*widget) || inside<QAbstractButton>(*widget))
            continue;
        if (const QString what = misfit(*widget, window); !what.isEmpty())
            found += nameOf(*widget) + QStringLiteral(": ") + what;
    }
    return found;
}

int lookAtAll(int argc, char** argv)
{
    QApplication application(argc, argv);
    LongerWords words;
    QApplication::installTranslator(&words);
    SmallFleet fleet;
    OpenWindow large(fleet.stores); // as it was left on a large screen
    large.window.resize(2500, 1400);
    large.window.resizeDocks({&large.find<QDockWidget>("fleetDock")}, {1500}, Qt::Horizontal);
    every::settle();
    large.window.close();
    OpenWindow open(fleet.stores, false, &large.settings);
    open.window.resize(kSmallScreen);
    if (open.window.screen()->size() != kSmallScreen) {
        std::printf("the screen is %d x %d\n", open.window.screen()->size().width(), open.window.screen()->size().height());
        return 2;
    }
    QSet<QString> said;
    everyPage(open, fleet, [&](const QString& where) {
        // What a worker has just brought (an icon, a count) is laid out before it is looked at, as a person would see it.
        for (int nested = 0; nested < 3; ++nested)
            QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        for (const QString& what : misfitsOf(open.window))
            if (!said.contains(where.section(',', 0, 0) + what)) {
                said.insert(where.section(',', 0, 0) + what);
                std::printf("%s: %s\n", qPrintable(where), qPrintable(what));
            }
        if (const QString folder = qEnvironmentVariable("LUBBERLINE_FIT_PICTURES"); !folder.isEmpty())
            open.window.grab().save(QStringLiteral("%1/%2.png").arg(folder, QString(where).replace(' ', '_').replace('/', '_')));
    });
    return said.isEmpty() ? 0 : 1;
}

} // namespace

class PagesFitTest : public QObject {
    Q_OBJECT

private slots:
    void everyPageFitsASmallScreen_data();
    void everyPageFitsASmallScreen();
};

void PagesFitTest::everyPageFitsASmallScreen_data()
{
    QTest::addColumn<double>("scale");
    QTest::newRow("1") << 1.0;
    QTest::newRow("1.5") << 1.5;
    QTest::newRow("2") << 2.0;
}

void PagesFitTest::everyPageFitsASmallScreen()
{
    QFETCH(double, scale);
    QTemporaryDir folder;
    QFile screens(folder.filePath("screens.json"));
    QVERIFY(screens.open(QIODevice::WriteOnly));
    screens.write(
        QStringLiteral("{\"screens\": [{\"name\": \"small\", \"x\": 0, \"y\": 0, \"width\": %1, \"height\": %2, \"logicalDpi\": 96, "
                       "\"logicalBaseDpi\": 96, \"dpr\": 1}]}")
            .arg(kSmallScreen.width() * scale)
            .arg(kSmallScreen.height() * scale)
            .toUtf8());
    screens.close();
    QProcess child;
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen:configfile=") + screens.fileName());
    environment.insert(QStringLiteral("QT_SCALE_FACTOR"), QString::number(scale));
    child.setProcessEnvironment(environment);
    child.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--look")});
    QVERIFY(child.waitForFinished(180000));
    const QByteArray found = child.readAllStandardOutput();
    QVERIFY2(child.exitStatus() == QProcess::NormalExit && child.exitCode() == 0, ("\n" + found).constData());
}

int main(int argc, char** argv)
{
    if (argc > 1 && QByteArrayView(argv[1]) == "--look")
        return lookAtAll(argc, argv);
    QCoreApplication application(argc, argv);
    PagesFitTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "PagesFitTest.moc"
