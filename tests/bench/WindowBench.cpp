// Start to first painted window against a bare Qt main window with two docks and tables, in the same process and harness: with
// the demonstration fleet (limit 1.6) and with BENCH_SWINGS (100,000) swings in the database (not slower). The keystroke that
// ends a figure in a 32-point swing, to stored, computed and repainted (limit: 16 ms median), a swing of 20,000 readings from a log to
// its painted page (200 ms) and a keystroke in it (50 ms), a click on a type in a tree of 20,000 aircraft (50 ms) and a screen further in it
// (16 ms): here the reference is that number itself.

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMainWindow>
#include <QProcess>
#include <QScrollBar>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include <cstdlib>

#include "app/OpenStores.h"
#include "core/demo/DemoFleet.h"
#include "db/engine/Transaction.h"
#include "db/transfer/Transfer.h"
#include "tests/bench/BenchFleet.h"
#include "tests/bench/Ratio.h"
#include "ui/window/MainWindow.h"

namespace {

using namespace lubberline;

class NoDialogs final : public ui::Dialogs {
    QString openFile(QWidget*, const QString&, const QString&) override { return {}; }
    QString saveFile(QWidget*, const QString&, const QString&, const QString&) override { return {}; }
    QString chooseFolder(QWidget*, const QString&, const QString&) override { return {}; }
    Result<bool> printPreview(QWidget*, const PaintPages&, Where) override { return false; }
    bool openOutside(const QString&) override { return false; }
};

class BareWindow : public QMainWindow {
public:
    BareWindow()
    {
        for (const auto area : {Qt::LeftDockWidgetArea, Qt::RightDockWidgetArea}) {
            auto* dock = new QDockWidget("dock", this);
            dock->setWidget(new QTableWidget(20, 4, dock));
            addDockWidget(area, dock);
        }
        setCentralWidget(new QTableWidget(20, 6, this));
        resize(1280, 720);
    }
    bool painted = false;

protected:
    bool event(QEvent* event) override
    {
        const bool done = QMainWindow::event(event);
        painted = painted || event->type() == QEvent::Paint;
        return done;
    }
};

/// This program again, to show one window and leave: a start is a process of its own.
int showOnce(int argc, char** argv)
{
    QApplication application(argc, argv);
    if (QString(argv[1]) == "bare") {
        BareWindow window;
        window.show();
        while (!window.painted)
            QApplication::processEvents();
        return 0;
    }
    auto stores = app::openStores(argv[2], db::OpenMode::ReadWriteCreate);
    NoDialogs dialogs;
    const QTemporaryDir folder;
    QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
    ui::MainWindow window(**stores, {dialogs, settings, {}, {}});
    bool painted = false;
    QObject::connect(&window, &ui::MainWindow::firstPainted, [&] { painted = true; });
    window.resize(1280, 720);
    window.show();
    while (!painted)
        QApplication::processEvents();
    return 0;
}

void run(const QStringList& arguments)
{
    if (QProcess::execute(QCoreApplication::applicationFilePath(), arguments) != 0)
        std::abort();
}

bool benchStart(const QString& folder)
{
    const QString demo = folder + "/demo.lubberline", large = folder + "/large.lubberline";
    {
        auto stores = app::openStores(demo.toStdString(), db::OpenMode::ReadWriteCreate);
        if (!db::importFleet((*stores)->database(), demoFleet(), {}))
            std::abort();
        const char* wanted = std::getenv("BENCH_SWINGS");
        auto many = app::openStores(large.toStdString(), db::OpenMode::ReadWriteCreate);
        bench::fillFleet((*many)->database(), wanted ? std::atoi(wanted) : 100'000, 8);
    }
    const auto bare = [] { run({"bare"}); };
    const auto few = [&] { run({"ours", demo}); };
    const auto many = [&] { run({"ours", large}); };
    const bool first = bench::report("start, demonstration fleet", bench::compare(few, bare, 15), "a bare window", 1.6);
    const bool second = bench::report("start, very many swings", bench::compare(many, few, 15), "the demonstration", 1.1);
    return first && second;
}

/// A window on a database, in front.
struct Opened {
    explicit Opened(const QString& database)
        : stores(std::move(app::openStores(database.toStdString(), db::OpenMode::ReadWriteCreate).value()))
        , settings(database + ".ini", QSettings::IniFormat)
        , window(*stores, {dialogs, settings, {}, {}})
    {
        window.resize(1366, 768);
        window.show();
        if (!QTest::qWaitForWindowActive(&window))
            std::abort();
    }
    std::unique_ptr<db::Stores> stores;
    NoDialogs dialogs;
    QSettings settings;
    ui::MainWindow window;
};

/// The key that ends a figure: stored on disk, computed, table and plots painted. @return the median [s] of `count` of them.
double keystroke_s(ui::MainWindow& window, int count)
{
    auto* table = window.findChild<QTableView*>("readingsTable");
    table->setFocus();
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
        table->setCurrentIndex(table->model()->index(i % 32, 2));
        const QByteArray figure = QByteArray::number((i % 32) * 11.25 + (i % 3)); // another one than is there
        for (qsizetype k = 0; k < figure.size(); ++k)
            QTest::keyClick(k == 0 ? static_cast<QWidget*>(table) : QApplication::focusWidget(), figure[k]);
        QApplication::processEvents();
        times.push_back(bench::seconds([] {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
            QApplication::processEvents();
        }));
    }
    return bench::median(times);
}

bool benchKeystroke(const QString& folder)
{
    const QString database = folder + "/keys.lubberline";
    bench::fillFleet((*app::openStores(database.toStdString(), db::OpenMode::ReadWriteCreate))->database(), 2, 32);
    Opened opened(database);
    opened.window.go(SwingId{1});
    QTest::qWait(200);
    return bench::report("keystroke in a 32-point swing", {keystroke_s(opened.window, 64), 0.016}, "16 ms", 1.0);
}

/// What a log of half an hour gives at ten figures a second, in a swing that is opened from the tree and corrected by hand.
bool benchLog(const QString& folder)
{
    const QString database = folder + "/log.lubberline";
    bench::fillFleet((*app::openStores(database.toStdString(), db::OpenMode::ReadWriteCreate))->database(), 2, 20'000);
    Opened opened(database);
    std::vector<double> times;
    for (int i = 0; i < 7; ++i)
        times.push_back(bench::seconds([&] {
            opened.window.go(SwingId{1 + i % 2});
            QApplication::processEvents();
        }));
    const bool opens = bench::report("opening a swing of 20,000 readings", {bench::median(times), 0.2}, "200 ms", 1.0);
    return bench::report("keystroke in a swing of 20,000 readings", {keystroke_s(opened.window, 12), 0.05}, "50 ms", 1.0) && opens;
}

/// A click on a type in a tree of 20,000 aircraft: opened, its page shown, painted; then a screen of its 1,000 aircraft further.
bool benchTree(const QString& folder)
{
    const QString database = folder + "/tree.lubberline";
    {
        auto stores = app::openStores(database.toStdString(), db::OpenMode::ReadWriteCreate);
        auto transaction = db::Transaction::begin((*stores)->database());
        for (int type = 0; type < 20; ++type) {
            const auto id = *(*stores)->fleet.add(AircraftType{{}, {}, "Type " + std::to_string(type), "", ""});
            for (int i = 0; i < 1000; ++i) {
                Aircraft aircraft;
                aircraft.type = id;
                aircraft.registration = "B-" + std::to_string(1000 * type + i);
                if (!(*stores)->fleet.add(aircraft))
                    std::abort();
            }
        }
        if (!transaction->commit())
            std::abort();
    }
    Opened opened(database);
    QTest::qWait(200); // the tree is filled after the first paint
    auto* tree = opened.window.findChild<QTreeView*>("fleetTree");
    std::vector<double> clicks, screens;
    for (int type = 0; type < 7; ++type) {
        const QModelIndex index = tree->model()->index(type, 0);
        tree->scrollTo(index);
        const QPoint place = tree->visualRect(index).center();
        clicks.push_back(bench::seconds([&] {
            QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, place);
            tree->expand(index);
            QApplication::processEvents();
        }));
        screens.push_back(bench::seconds([&] {
            tree->verticalScrollBar()->triggerAction(QAbstractSlider::SliderPageStepAdd);
            QApplication::processEvents();
        }));
        tree->collapse(index);
    }
    const bool click = bench::report("a type in a tree of 20,000 aircraft", {bench::median(clicks), 0.05}, "50 ms", 1.0);
    return bench::report("a screen further in it", {bench::median(screens), 0.016}, "16 ms", 1.0) && click;
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    if (argc > 1)
        return showOnce(argc, argv);
    QApplication application(argc, argv);
    const QTemporaryDir folder;
    const QByteArray only = qgetenv("BENCH_ONLY"); // keystroke, log, tree or start, where one is looked at alone
    const auto wanted = [&](const char* part) { return only.isEmpty() || only == part; };
    const bool keystroke = !wanted("keystroke") || benchKeystroke(folder.path());
    const bool log = !wanted("log") || benchLog(folder.path());
    const bool tree = !wanted("tree") || benchTree(folder.path());
    const bool start = !wanted("start") || benchStart(folder.path());
    return start && keystroke && log && tree ? 0 : 1;
}
