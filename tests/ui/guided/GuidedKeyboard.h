#pragma once
/// The page of a guided swing, with a crew at its keyboard.

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/window/Fixture.h"
#include "tests/ui/window/Typing.h"
#include "ui/guided/GuidedPage.h"

namespace lubberline::ui {

struct Pair {
    double magnetic_deg, compass_deg;
};

struct Keyboard {
    SmallFleet fleet;
    GuidedPage page{fleet.stores, [] { return std::string("2026-11-23T10:00:00Z"); }};
    QSignalSpy finished{&page, &GuidedPage::finished};
    QSignalSpy failed{&page, &GuidedPage::failed};

    Keyboard()
    {
        page.resize(1200, 760);
        page.show();
        QApplication::setActiveWindow(&page);
    }
    template <class Widget>
    Widget& find(const char* name)
    {
        return in<Widget>(page, name);
    }
    QString text(const char* label) { return find<QLabel>(label).text(); }
    void begin(ProcedureKind kind = ProcedureKind::Coefficient)
    {
        QVERIFY(page.begin(fleet.compass));
        find<QComboBox>("guidedProcedure").setCurrentIndex(static_cast<int>(kind));
        find<QPlainTextEdit>("guidedChecklist").setPlainText("tools\ndoors");
        find<QPushButton>("beginGuided").click();
        for (const char* box : {"check0", "check1"})
            QTest::keyClick(&find<QCheckBox>(box), Qt::Key_Space);
        find<QPushButton>("prepared").click();
    }
    /// Types where the focus is, then Enter.
    void type(const QString& figures)
    {
        QWidget* at = page.focusWidget();
        QVERIFY(at);
        if (auto* line = qobject_cast<QLineEdit*>(at))
            line->selectAll();
        QTest::keyClicks(at, figures);
        QTest::keyClick(at, Qt::Key_Return);
    }
    void read(Pair pair)
    {
        type(QString::number(pair.magnetic_deg));
        type(QString::number(pair.compass_deg));
    }
    /// Reads, and keeps what the page would look at twice: the worksheets' compasses are far out before they are corrected.
    void readAndKeep(Pair pair)
    {
        const int at = page.job().state().current;
        const auto before = page.job().job().events.size();
        read(pair);
        if (page.job().job().events.size() == before)
            QTest::keyClick(page.focusWidget(), Qt::Key_Return);
        QVERIFY(page.job().state().current != at || page.job().state().turn || page.job().state().phase != JobPhase::Stations);
    }
    void obey() { type(text("turnTarget").chopped(1)); }
    const JobState& state() { return page.job().state(); }
    void key(Qt::Key code) { QTest::keyClick(page.focusWidget(), code); }
};

} // namespace lubberline::ui
