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

namespace {

/// The panel of a swing's signatures, without its page.
struct Signing {
    SmallFleet fleet;
    EditContext context{fleet.stores, [](const Error&) {}};
    QUndoStack stack;
    SwingEditor editor{context, stack};
    KeyChecks keys{fleet.stores};
    SigningPanel panel{context, editor, keys};
    QSignalSpy failed{&panel, &SigningPanel::failed}, opened{&panel, &SigningPanel::openSwing};

    void show(SwingId swing)
    {
        QVERIFY(editor.open(swing));
        panel.QWidget::show();
        panel.show("In limits.");
    }
    template <class Widget>
    Widget& find(const char* name)
    {
        return in<Widget>(panel, name);
    }
};

} // namespace

class SigningPanelTest : public QObject {
    Q_OBJECT

private slots:
    void twoPeopleSignAndAnAmendmentShowsWhatItChanges()
    {
        Signing at;
        auto& stores = at.fleet.stores;
        const SwingId id = at.fleet.addSwing("2026-11-20", eightPoints());
        at.show(id);
        QVERIFY(!at.find<QLineEdit>("signName").isVisible()); // a draft is not signed
        at.find<QPushButton>("changeState").click();
        at.show(id);
        QCOMPARE(stores.swings.record(id)->swing.state, SwingState::Complete);
        type(at.find<QLineEdit>("signName"), "Ada");
        type(at.find<QLineEdit>("signLicence"), "PL 12");
        at.show(id);
        QCOMPARE(at.find<QTableWidget>("signatures").rowCount(), 1);
        QVERIFY(at.find<QTableWidget>("signatures").item(0, 4)->text().startsWith("✓"));
        QCOMPARE(at.find<QComboBox>("signRole").currentIndex(), 1); // the inspector is next
        type(at.find<QLineEdit>("signLicence"), "");
        QCOMPARE(at.failed.count(), 1); // nobody's name
        at.find<QLineEdit>("signName").setText("Ben");
        at.find<QPushButton>("signButton").click();
        at.show(id);
        QCOMPARE(stores.swings.record(id)->swing.state, SwingState::Signed);
        QVERIFY(!at.find<QPushButton>("changeState").isVisible());
        at.find<QPushButton>("amendButton").click();
        QCOMPARE(at.failed.count(), 2); // not without a reason
        at.find<QLineEdit>("stateReason").setText("the date was wrong");
        at.find<QPushButton>("amendButton").click();
        QCOMPARE(at.opened.count(), 1);
        Swing amended = stores.swings.record(at.opened.front().front().value<SwingId>())->swing;
        amended.date = "2026-11-19";
        QVERIFY(stores.put(amended));
        at.show(amended.id);
        auto& differences = at.find<QTableWidget>("differences");
        QCOMPARE(differences.rowCount(), 1);
        QCOMPARE(differences.item(0, 1)->text() + " > " + differences.item(0, 2)->text(), QString("2026-11-20 > 2026-11-19"));
    }

    /// 1980-01-06 is what receivers write that know no day: who knows that it was that day says how, in the field that is shown for it.
    void aDayFromWhichClocksCountIsCompletedByWhoKnowsIt()
    {
        Signing at;
        const SwingId id = at.fleet.addSwing("1980-01-06", eightPoints());
        at.show(id);
        QVERIFY(at.find<QLineEdit>("stateReason").isVisible());
        at.find<QPushButton>("changeState").click();
        QCOMPARE(at.failed.count(), 1);
        QVERIFY(at.failed.front().front().toString().contains("say how it is known"));
        at.find<QLineEdit>("stateReason").setText("sheet 114");
        at.find<QPushButton>("changeState").click();
        QVERIFY(at.fleet.stores.swings.swing(id)->state == SwingState::Complete);
        at.show(at.fleet.addSwing("2026-11-20", eightPoints()));
        QVERIFY(!at.find<QLineEdit>("stateReason").isVisible());
    }

    /// By the keyboard alone: what opens it is followed by the name, not by a search for its field.
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
        Signing at;
        auto& stores = at.fleet.stores;
        const SwingId id = at.fleet.addSwing("2026-11-20", eightPoints());
        QVERIFY(stores.signing.complete(id) && stores.signing.sign(id, {SignatureRole::Performer, "Ada", "", "", ""}));
        QVERIFY(stores.signing.reopen(id, "misread"));
        const auto before = stores.swings.record(id)->swing.readings[0];
        Reading after = before;
        after.compass = CompassHeading::fromDegrees(2);
        QVERIFY(stores.swings.changeReading(id, before, after));
        at.show(id);
        QVERIFY(at.find<QTableWidget>("signatures").item(0, 4)->text().startsWith("✗"));
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::SigningPanelTest)
#include "SigningPanelTest.moc"
