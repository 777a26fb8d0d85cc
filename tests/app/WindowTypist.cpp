// Types readings into the real window on a real database, as fast as it can, until it is killed. After each cell is left it
// says on standard output what was typed: the row, the column and the figure. With `over` it types one compass reading over each row that is
// there, and waits; with `put` it takes the offer to put in what was kept. Run by WindowKillTest.

#include <QApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTest>

#include <cstdio>

#include "app/OpenStores.h"
#include "ui/swing/readings/ReadingsModel.h"
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

void say(const char* column, int row, double figure)
{
    std::printf("%s %d %g\n", column, row, figure);
    std::fflush(stdout);
}

void typeCell(QTableView& table, double figure)
{
    // The first key opens the editor of the current cell, the others go to it.
    const QString text = QString::number(figure);
    QTest::keyClick(&table, text.at(0).toLatin1());
    for (qsizetype i = 1; i < text.size(); ++i)
        QTest::keyClick(QApplication::focusWidget(), text.at(i).toLatin1());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
}

void typeOver(QTableView& table)
{
    for (int row = 0; row < table.model()->rowCount() - 1; ++row) { // the last one is empty
        table.setCurrentIndex(table.model()->index(row, static_cast<int>(ui::ReadingColumn::Compass)));
        const double compass = row * 45 + 7;
        typeCell(table, compass);
        say("compass", row, compass);
    }
}

int putIn(ui::MainWindow& window)
{
    QPushButton* answer = nullptr;
    const auto offered = [&] {
        for (auto* button : window.findChildren<QPushButton*>())
            if (button->text() == ui::MainWindow::tr("Put them in"))
                answer = button;
        return answer != nullptr;
    };
    if (!QTest::qWaitFor(offered))
        return 4;
    answer->click();
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    auto stores = app::openStores(argv[1], db::OpenMode::ReadWriteCreate);
    if (!stores)
        return 1;
    NoDialogs dialogs;
    QSettings settings(QString(argv[1]) + ".ini", QSettings::IniFormat);
    ui::MainWindow window(**stores, {dialogs, settings, {}, {}, {QString(argv[1]) + ".recovery"}});
    window.show();
    if (!QTest::qWaitForWindowActive(&window))
        return 2;
    window.go(SwingId{std::atoi(argv[2])});
    auto* table = window.findChild<QTableView*>("readingsTable");
    if (!table)
        return 3;
    const QString how = argv[3];
    if (how == "put")
        return putIn(window);
    if (how == "over") {
        typeOver(*table);
        return application.exec();
    }
    const int first = how.toInt(); // rows that are there from earlier rounds
    table->setFocus();
    for (int row = first; row < first + 10000; ++row) {
        table->setCurrentIndex(table->model()->index(row, 1));
        const double magnetic = (row * 45) % 360, compass = (row * 45 + 3) % 360;
        typeCell(*table, magnetic);
        say("magnetic", row, magnetic);
        typeCell(*table, compass);
        say("compass", row, compass);
    }
    return 0;
}
