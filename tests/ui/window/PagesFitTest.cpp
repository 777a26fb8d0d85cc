// No page makes the window larger than a small screen, and on it nothing is clipped, cut or outside, at any scale and with words a third
// longer. The scale and the screen are those of a process: each is looked at in one of its own, this program once more.

#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QListView>
#include <QProcess>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStyleOptionComboBox>
#include <QTableView>
#include <QTranslator>
#include <QTreeView>

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

QStringList cutCells(const QAbstractItemView& view)
{
    QStringList cut;
    const auto* model = view.model();
    if (!model)
        return cut;
    const auto* table = qobject_cast<const QTableView*>(&view);
    if (table && table->horizontalHeader()->isVisible())
        for (int column = 0; column < model->columnCount(); ++column)
            if (!table->isColumnHidden(column) && table->horizontalHeader()->sectionSizeHint(column) > table->columnWidth(column) + 1)
                cut += QStringLiteral("heading %1 “%2”: %3 of %4 px")
                           .arg(column)
                           .arg(model->headerData(column, Qt::Horizontal).toString())
                           .arg(table->columnWidth(column))
                           .arg(table->horizontalHeader()->sectionSizeHint(column));
    for (int row = 0; row < std::min(model->rowCount(), 12); ++row)
        for (int column = 0; column < model->columnCount(); ++column) {
            const QModelIndex index = model->index(row, column);
            const QRect room = view.visualRect(index);
            const int wanted = view.sizeHintForIndex(index).width();
            if (room.isValid() && wanted > room.width() + 1 && !(table && table->wordWrap()) && !qobject_cast<const QListView*>(&view))
                cut += QStringLiteral("cell %1, %2 “%3”: %4 of %5 px")
                           .arg(row)
                           .arg(column)
                           .arg(index.data().toString())
                           .arg(room.width())
                           .arg(wanted);
        }
    return cut;
}

/// What of a widget cannot be read or reached; empty: all of it can.
QString misfit(const QWidget& widget, const QWidget& window)
{
    const bool scrolled = inside<QAbstractScrollArea>(widget);
    if (!scrolled && !window.rect().contains(QRect(widget.mapTo(&window, QPoint()), widget.size())))
        return QStringLiteral("outside the window");
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
        QStyleOptionComboBox option;
        option.initFrom(box);
        option.subControls = QStyle::SC_All;
        const int room = box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box).width();
        const int wanted = box->fontMetrics().horizontalAdvance(box->currentText());
        return wanted > room ? QStringLiteral("“%1” wants %2 px, has %3").arg(box->currentText()).arg(wanted).arg(room) : QString();
    }
    const auto* label = qobject_cast<const QLabel*>(&widget);
    if (label && label->text().isEmpty())
        return {};
    if (label && label->wordWrap() && label->heightForWidth(label->width()) > label->height() + 1)
        return QStringLiteral("wants %1 px of height, has %2").arg(label->heightForWidth(label->width())).arg(label->height());
    const bool worded = label || qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QGroupBox*>(&widget);
    const QSize least = widget.minimumSizeHint();
    if (worded && (least.width() > widget.width() + 1 || least.height() > widget.height() + 1))
        return QStringLiteral("wants %1×%2 px, has %3×%4").arg(least.width()).arg(least.height()).arg(widget.width()).arg(widget.height());
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget))
        return cutCells(*view).join(QStringLiteral("; "));
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
        if (!widget->isVisible() || widget->objectName().startsWith(QStringLiteral("qt_")) || inside<QAbstractItemView>(*widget)
            || inside<QComboBox>(*widget) || inside<Plot>(*widget) || inside<QAbstractButton>(*widget))
            continue;
        if (const QString what = misfit(*widget, window); !what.isEmpty())
            found += nameOf(*widget) + QStringLiteral(": ") + what;
    }
    for (const auto* scroll : window.findChildren<QScrollArea*>(QStringLiteral("pageScroll")))
        if (scroll->isVisible() && scroll->widget()->width() > scroll->viewport()->width())
            found
                += QStringLiteral("the page scrolls sideways: %1 of %2 px").arg(scroll->widget()->width()).arg(scroll->viewport()->width());
    return found;
}

int lookAtAll(int argc, char** argv)
{
    QApplication application(argc, argv);
    LongerWords words;
    QApplication::installTranslator(&words);
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.resize(kSmallScreen);
    if (open.window.screen()->size() != kSmallScreen) {
        std::printf("the screen is %d x %d\n", open.window.screen()->size().width(), open.window.screen()->size().height());
        return 2;
    }
    QSet<QString> said;
    everyPage(open, fleet, [&](const QString& where) {
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
