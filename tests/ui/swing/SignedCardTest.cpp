// What a card says of its own standing, on the page and on paper: out of limits, not signed, printed again; and that a signature does not
// take a compass that is out of its limits off the list of what is due.

#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include "db/engine/Statement.h"
#include "tests/ui/window/Fixture.h"
#include "ui/due/DueWork.h"
#include "ui/fleet/FleetModel.h"
#include "ui/swing/RecordDocuments.h"

using namespace lubberline;
using namespace lubberline::ui;

class SignedCardTest : public QObject {
    Q_OBJECT

private slots:
    void aCompleteCardIsNotSignedAndTheFirstSignedOneIsNoReprint();
    void aSignatureTakesNoCompassOutOfItsLimitsOffTheDueList();
    void whatNoSignatureStandsOverIsSignedNowhere_data();
    void whatNoSignatureStandsOverIsSignedNowhere();

private:
    static void sign(SmallFleet& fleet, SwingId id)
    {
        Signature signature;
        for (const auto& [role, name] : {std::pair{SignatureRole::Performer, "Ada"}, {SignatureRole::Inspector, "Ben"}}) {
            signature.role = role;
            signature.name = name;
            if (const auto done = fleet.stores.signing.sign(id, signature); !done)
                qFatal("not signed: %s", describe(done.error()).c_str());
        }
    }
    static QString reprintOf(SmallFleet& fleet, SwingId id)
    {
        return cardOf(fleet.stores, id, {}, "2026-11-23T10:00:00Z", true)->reprintOf;
    }
    static DueLine dueLine(SmallFleet& fleet) { return dueNews(fleet.stores, "2026-11-23", {})->lines.front(); }
};

void SignedCardTest::aCompleteCardIsNotSignedAndTheFirstSignedOneIsNoReprint()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-20", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    open.trigger("showCard");
    QCOMPARE(open.label("cardBanner"), QString::fromUtf8("DRAFT — NOT SIGNED"));
    open.trigger("complete");
    QCOMPARE(open.label("cardBanner"), QString("NOT SIGNED"));
    sign(fleet, id);
    QVERIFY(!open.find<QLabel>("cardBanner").isVisible());
    QVERIFY(reprintOf(fleet, id).isEmpty());
    open.dialogs.answer = open.folder.filePath("card.pdf");
    open.trigger("card30");
    QVERIFY(QFile::exists(open.dialogs.answer));
    QCOMPARE(reprintOf(fleet, id), QString::fromStdString(fleet.stores.swings.swing(id)->signatures.back().timeUtc.substr(0, 10)));
    // What amends it has had no card yet.
    const SwingId amended = *fleet.stores.signing.amend(id, "a heading was misread");
    QVERIFY(fleet.stores.signing.complete(amended));
    sign(fleet, amended);
    QVERIFY(reprintOf(fleet, amended).isEmpty());
    // A look at it is none; printed from the look it is one.
    open.window.go(amended);
    open.trigger("printCard");
    QVERIFY(reprintOf(fleet, amended).isEmpty());
    open.dialogs.prints = true;
    open.trigger("printCard");
    QVERIFY(!reprintOf(fleet, amended).isEmpty());
}

void SignedCardTest::aSignatureTakesNoCompassOutOfItsLimitsOffTheDueList()
{
    SmallFleet fleet;
    std::vector<std::pair<double, double>> far = eightPoints();
    for (auto& [magnetic, compass] : far)
        magnetic += 12;
    const SwingId id = fleet.addSwing("2026-11-20", far);
    QVERIFY(fleet.stores.signing.complete(id));
    OpenWindow open(fleet.stores);
    open.window.go(id);
    open.trigger("showCard");
    QCOMPARE(open.label("cardBanner"), QString::fromUtf8("OUT OF LIMITS · NOT SIGNED"));
    sign(fleet, id);
    QCOMPARE(open.label("cardBanner"), QString("OUT OF LIMITS"));
    const DueLine line = dueLine(fleet);
    QCOMPARE(line.answer.state, DueState::Due);
    QVERIFY2(line.answer.flags.front().reason.english().starts_with("OUT OF LIMITS by the swing of 2026-11-20: up to 1"),
        line.answer.flags.front().reason.english().c_str());
    QVERIFY(line.answer.flags.front().reason.english().ends_with("10° is allowed (14 CFR 25.1327)"));
    const SwingId mended = fleet.addSwing("2026-11-22", eightPoints());
    QVERIFY(fleet.stores.signing.complete(mended));
    QCOMPARE(dueLine(fleet).answer.state, DueState::Due);
    sign(fleet, mended);
    QCOMPARE(dueLine(fleet).answer.state, DueState::NotDue);
}

void SignedCardTest::whatNoSignatureStandsOverIsSignedNowhere_data()
{
    QTest::addColumn<QString>("forgery");
    QTest::newRow("one signature of two is gone") << "DELETE FROM signature WHERE name = 'Ben'";
    QTest::newRow("both are gone") << "DELETE FROM signature";
    QTest::newRow("a reading was changed") << "UPDATE reading SET compass_heading_deg = 3 WHERE position = 0";
}

void SignedCardTest::whatNoSignatureStandsOverIsSignedNowhere()
{
    QFETCH(QString, forgery);
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-22", eightPoints());
    QVERIFY(fleet.stores.signing.complete(id));
    sign(fleet, id);
    QCOMPARE(dueLine(fleet).answer.lastSigned, Date("2026-11-22"));
    db::Database& database = fleet.stores.database();
    db::Statement triggers(database, "SELECT name FROM sqlite_master WHERE type = 'trigger'");
    const auto names = db::rowsOf<std::string>(triggers, [](db::Statement& row) { return row.text(0); });
    for (const auto& name : *names)
        QVERIFY(db::execute(database, "DROP TRIGGER " + QString::fromStdString(name)));
    QVERIFY(db::execute(database, forgery));
    const QString said = "NOT SIGNED (no signatures stand)";
    QVERIFY(dueLine(fleet).answer.lastSigned.empty());
    FleetModel model(fleet.stores);
    QVERIFY(model.find({fleet.type, fleet.aircraft, fleet.compass, id}).data(Qt::ToolTipRole).toString().contains(said));
    OpenWindow open(fleet.stores);
    auto& today = open.find<QTableWidget>("overviewToday");
    QVERIFY(!today.findItems(said, Qt::MatchContains).isEmpty());
    open.window.go(fleet.compass);
    QVERIFY(!open.find<QTableWidget>("swingTable").findItems(said, Qt::MatchExactly).isEmpty());
    open.window.go(id);
    QCOMPARE(open.label("swingState"), said);
    QVERIFY2(open.label("readOnlyReason").contains("it is printed as not signed"), qPrintable(open.label("readOnlyReason")));
    QVERIFY(!cardOf(fleet.stores, id, {}, "2026-11-23T10:00:00Z", true)->columns.front().isSigned());
}

QTEST_MAIN(SignedCardTest)
#include "SignedCardTest.moc"
