// The window in Polish: a page, a page's error, a document; what is stored, exported and signed has the same bytes in either language.

#include "core/format/csv/SwingCsv.h"
#include "core/format/exchange/Exchange.h"
#include "core/format/exchange/SignedContent.h"
#include "tests/ui/window/Fixture.h"
#include "ui/text/Language.h"

using namespace lubberline;
using namespace lubberline::ui;

class PolishTest : public QObject {
    Q_OBJECT

private slots:
    void init() { QCOMPARE(speak({"pl"}), QString("pl")); }
    void cleanup() { speak({"en"}); }

    void theSwingPageSpeaksPolish()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", {{0, 358}, {90, 88}, {180, 181}, {270, 272}});
        OpenWindow open(fleet.stores);
        open.window.go(id);
        QVERIFY2(open.label("swingTitle").contains("2026-11-20 pomiar kontrolny, stan zastany"), qPrintable(open.label("swingTitle")));
        QCOMPARE(open.find<QTableView>("readingsTable").model()->headerData(1, Qt::Horizontal).toString(), QString("Magnetyczny"));
        QVERIFY2(open.label("meaning").contains("Największa dewiacja"), qPrintable(open.label("meaning")));
    }

    void anErrorOfCoreIsPolishOnThePage()
    {
        SmallFleet fleet;
        OpenWindow open(fleet.stores);
        open.window.go(fleet.addSwing("2026-11-20", {{0, 358}, {90, 88}}));
        QVERIFY2(open.label("meaning").contains("2 odczyty z oboma kursami"), qPrintable(open.label("meaning")));
    }

    void whatIsExportedAndSignedDoesNotChange()
    {
        SmallFleet fleet;
        const SwingId id = fleet.addSwing("2026-11-20", {{0, 358}, {90, 88}, {180, 181}, {270, 272}});
        const auto all = [&] {
            const SwingRecord record = *fleet.stores.swings.record(id);
            return std::vector<std::string>{writeExchange(fleet.stores.whole()), writeSwingCsv(record), signedContent(record, {})};
        };
        const auto polish = all();
        speak({"en"});
        QCOMPARE(all(), polish);
        QVERIFY(polish[0].find("\"as_found\"") != std::string::npos);
    }
};

QTEST_MAIN(PolishTest)
#include "PolishTest.moc"
