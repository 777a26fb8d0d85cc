// A crew at the keyboard of the real window on a real database: the guided swing of worksheet example Q1, from wherever it
// stands to its end, until it is killed. After each step it says on standard output how many are stored. Run by GuidedKillTest.
//   guided_crew DATABASE COMPASS SWING    (SWING 0: a new one)

#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTest>

#include <array>
#include <cstdio>

#include "app/OpenStores.h"
#include "ui/guided/GuidedPage.h"
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

/// Compass Compensation Worksheet, Q1: the correction swing and the check swing, in the order of the stations.
constexpr std::array<std::pair<int, int>, 12> kWorksheet{
    {{359, 3}, {91, 85}, {178, 170}, {267, 265}, {317, 316}, {0, 358}, {47, 42}, {93, 89}, {135, 134}, {179, 177}, {225, 220}, {273, 269}}};

void type(QLineEdit* line, const QString& text)
{
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
}

/// One step of the crew, whatever is asked for.
void step(ui::GuidedPage& page)
{
    const auto line = [&](const char* name) { return page.findChild<QLineEdit*>(QString::fromLatin1(name)); };
    const JobState state = page.job().state();
    switch (state.phase) {
    case JobPhase::Prepare:
        for (auto* box : page.findChildren<QCheckBox*>())
            if (!box->isChecked()) {
                box->setFocus();
                QTest::keyClick(box, Qt::Key_Space);
                return;
            }
        page.findChild<QPushButton*>("prepared")->click();
        return;
    case JobPhase::Stations:
    case JobPhase::Index: {
        if (state.turn) {
            type(line("guidedAfter"), page.findChild<QLabel*>("turnTarget")->text().chopped(1));
            return;
        }
        const auto [magnetic, compass] = kWorksheet[static_cast<std::size_t>(state.current)];
        type(line("guidedDatum"), QString::number(magnetic));
        type(line("guidedCompass"), QString::number(compass));
        if (page.job().state().current == state.current && !page.job().state().turn)
            QTest::keyClick(line("guidedCompass"), Qt::Key_Return); // looked at again: it is so
        return;
    }
    default: type(line("acceptedBy"), "Dora");
    }
}

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    auto stores = app::openStores(argv[1], db::OpenMode::ReadWriteCreate);
    if (!stores || argc < 4)
        return 1;
    NoDialogs dialogs;
    QSettings settings(QString(argv[1]) + ".ini", QSettings::IniFormat);
    ui::MainWindow window(**stores, {dialogs, settings, {}, {}});
    window.resize(1300, 740);
    window.show();
    if (!QTest::qWaitForWindowActive(&window))
        return 2;
    const SwingId swing{std::atoi(argv[3])};
    if (swing.valid()) {
        window.go(swing); // a guided swing in work is taken up
    } else {
        window.go(CompassId{std::atoi(argv[2])});
        window.findChild<QAction*>("guidedSwing")->trigger();
        window.findChild<QPushButton*>("beginGuided")->click();
    }
    auto* page = window.findChild<ui::GuidedPage*>();
    if (!page || !page->job().isOpen())
        return 3;
    std::printf("swing %lld\n", static_cast<long long>(page->swing().value));
    bool finished = false;
    QObject::connect(page, &ui::GuidedPage::finished, [&finished] { finished = true; });
    while (!finished) {
        step(*page);
        QTest::qWait(15); // a crew is slower than a test, and can be killed
        std::printf("steps %zu\n", page->job().job().events.size());
        std::fflush(stdout);
    }
    std::printf("done\n");
    return 0;
}
