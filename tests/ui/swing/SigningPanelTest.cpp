// Two people sign, an amendment shows what it changes, and a signature that no longer holds is told.

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolButton>
#include <QUndoStack>

#include "tests/ui/window/Fixture.h"
#include "tests/ui/window/Typing.h"
#include "ui/swing/KeyChecks.h"
#include "ui/swing/SigningPanel.h"
#include "ui/swing/SwingEditor.h"

namespace lubberline::ui {

class SigningPanelTest : public QObject {
    Q_OBJECT

private slots:
    void twoPeopleSignAndAnAmendmentShowsWhatItChanges()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        EditContext context{fleet.stores, [](const Error&) {}};
        QUndoStack stack;
        SwingEditor editor(context, stack);
        KeyChecks keys(fleet.stores);
        SigningPanel panel(context, editor, keys);
        panel.QWidget::show();
        QSignalSpy failed(&panel, &SigningPanel::failed), opened(&panel, &SigningPanel::openSwing);
        const auto refresh = [&](SwingId swing) {
            QVERIFY(editor.open(swing));
            panel.show("In limits.");
        };
        refresh(id);
        QVERIFY(!in<QLineEdit>(panel, "signName").isVisible()); // a draft is not signed
        in<QPushButton>(panel, "changeState").click();
        refresh(id);
        QCOMPARE(fleet.stores.swings.record(id)->swing.state, SwingState::Complete);
        type(in<QLineEdit>(panel, "signName"), "Ada");
        type(in<QLineEdit>(panel, "signLicence"), "PL 12");
        refresh(id);
        QCOMPARE(in<QTableWidget>(panel, "signatures").rowCount(), 1);
        QVERIFY(in<QTableWidget>(panel, "signatures").item(0, 4)->text().startsWith("✓"));
        QCOMPARE(in<QComboBox>(panel, "signRole").currentIndex(), 1); // the inspector is next
        type(in<QLineEdit>(panel, "signLicence"), "");
        QCOMPARE(failed.count(), 1); // nobody's name
        in<QLineEdit>(panel, "signName").setText("Ben");
        in<QPushButton>(panel, "signButton").click();
        refresh(id);
        QCOMPARE(fleet.stores.swings.record(id)->swing.state, SwingState::Signed);
        QVERIFY(!in<QPushButton>(panel, "changeState").isVisible());
        in<QPushButton>(panel, "amendButton").click();
        QCOMPARE(failed.count(), 2); // not without a reason
        in<QLineEdit>(panel, "stateReason").setText("the date was wrong");
        in<QPushButton>(panel, "amendButton").click();
        QCOMPARE(opened.count(), 1);
        Swing amended = fleet.stores.swings.record(opened.front().front().value<SwingId>())->swing;
        amended.date = "2026-11-19";
        QVERIFY(fleet.stores.put(amended));
        refresh(amended.id);
        auto& differences = in<QTableWidget>(panel, "differences");
        QCOMPARE(differences.rowCount(), 1);
        QCOMPARE(differences.item(0, 1)->text() + " > " + differences.item(0, 2)->text(), QString("2026-11-20 > 2026-11-19"));
    }

    /// By the keyboard alone: what opens it is followed by the name, not by a search for its field.
    /// 1980-01-06 is what receivers write that know no day: who knows that it was that day says how, in the field that is shown for it.
    void aDayFromWhichClocksCountIsCompletedByWhoKnowsIt()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("1980-01-06", eightPoints());
        EditContext context{fleet.stores, [](const Error&) {}};
        QUndoStack stack;
        SwingEditor editor(context, stack);
        KeyChecks keys(fleet.stores);
        SigningPanel panel(context, editor, keys);
        panel.QWidget::show();
        QSignalSpy failed(&panel, &SigningPanel::failed);
        QVERIFY(editor.open(id));
        panel.show("In limits.");
        QVERIFY(in<QLineEdit>(panel, "stateReason").isVisible());
        in<QPushButton>(panel, "changeState").click();
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed.front().front().toString().contains("say how it is known"));
        in<QLineEdit>(panel, "stateReason").setText("sheet 114");
        in<QPushButton>(panel, "changeState").click();
        QVERIFY(fleet.stores.swings.swing(id)->state == SwingState::Complete);
        const SwingId other = fleet.addSwing("2026-11-20", eightPoints());
        QVERIFY(editor.open(other));
        panel.show("In limits.");
        QVERIFY(!in<QLineEdit>(panel, "stateReason").isVisible());
    }

    void openingItAsksForTheName()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        QVERIFY(fleet.stores.signing.complete(id));
        OpenWindow open(fleet.stores);
        open.window.go(id);
        open.find<QToolButton>("showSigning").click();
        QCOMPARE(open.window.focusWidget(), &open.find<QLineEdit>("signName"));
    }

    void aSignatureThatNoLongerHoldsIsSaid()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
        QVERIFY(fleet.stores.signing.complete(id) && fleet.stores.signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
        QVERIFY(fleet.stores.signing.reopen(id, "misread"));
        const auto before = fleet.stores.swings.record(id)->swing.readings[0];
        Reading after = before;
        after.compass = CompassHeading::fromDegrees(2);
        QVERIFY(fleet.stores.swings.changeReading(id, before, after));
        EditContext context{fleet.stores, [](const Error&) {}};
        QUndoStack stack;
        SwingEditor editor(context, stack);
        QVERIFY(editor.open(id));
        KeyChecks keys(fleet.stores);
        SigningPanel panel(context, editor, keys);
        panel.show({});
        QVERIFY(in<QTableWidget>(panel, "signatures").item(0, 4)->text().startsWith("✗"));
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::SigningPanelTest)
#include "SigningPanelTest.moc"
