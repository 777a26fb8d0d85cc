// A file that another program has written into, looked at through the window: whatever a cell holds, the window stands, shows no figure
// that is none, and what cannot be shown is told.

#include <QRegularExpression>

#include "tests/db/RawDatabase.h"
#include "tests/ui/window/EveryPage.h"

namespace lubberline::ui {

namespace {

/// Of another kind, out of every range, no UTF-8, a block, absurdly long, something to run.
constexpr const char* kBad[] = {"NULL", "''", "'x'", "-1", "99", "1e308", "9e999", "-9e999", "9223372036854775807", "zeroblob(10)",
    "x'1b5d00ff'", "hex(zeroblob(10000))", "CAST(x'41fffe42' AS TEXT)", "'2026-02-30'", "'[[1e999]]'", "'<b>%1</b>'"};

struct Cell {
    const char *table, *column;
};
constexpr Cell kCells[] = {{"swing", "kind"}, {"swing", "date"}, {"swing", "stage"}, {"swing", "state"}, {"swing", "status"},
    {"swing", "record"}, {"swing", "compass_id"}, {"swing", "variation_deg"}, {"swing", "readings"}, {"swing", "site_id"},
    {"reading", "magnetic_heading_deg"}, {"reading", "compass_heading_deg"}, {"reading", "position"}, {"reading", "note"},
    {"reading", "swing_id"}, {"signature", "role"}, {"signature", "name"}, {"signature", "hash"}, {"signature", "contents"},
    {"signature", "particulars"}, {"aircraft", "registration"}, {"aircraft", "record"}, {"aircraft", "note"}, {"aircraft", "type_id"},
    {"aircraft_type", "name"}, {"aircraft_type", "record"}, {"compass", "name"}, {"compass", "kind"}, {"compass", "status"},
    {"compass", "aircraft_id"}, {"compass", "limits_id"}, {"limits_profile", "max_deviation_deg"}, {"limits_profile", "name"},
    {"audit_entry", "time_utc"}, {"audit_entry", "link"}, {"audit_entry", "detail"}, {"audit_head", "head"}, {"audit_head", "entries"}};

void expectNoFigureThatIsNone(OpenWindow& open, const QString& damage)
{
    static const QRegularExpression none(QStringLiteral("(?<![A-Za-z])(nan|-?inf)(?![A-Za-z])"), QRegularExpression::CaseInsensitiveOption);
    for (const auto* label : open.window.findChildren<QLabel*>())
        if (label->isVisible())
            QVERIFY2(!none.match(label->text()).hasMatch(), qPrintable(damage + ": " + label->text()));
    for (const auto* table : open.window.findChildren<QTableView*>())
        for (int row = 0; table->isVisible() && table->model() && row < std::min(table->model()->rowCount(), 20); ++row)
            for (int column = 0; column < table->model()->columnCount(); ++column) {
                const QString text = table->model()->index(row, column).data().toString();
                QVERIFY2(!none.match(text).hasMatch(), qPrintable(damage + ": " + text));
            }
}

} // namespace

class DamagedWindowTest : public QObject {
    Q_OBJECT

private:
    SwingId m_signed;

    /// Another program holds itself to none of our rules.
    static void loosen(db::Stores& stores)
    {
        test::RawDatabase raw(stores.location());
        QVERIFY(raw.run({"PRAGMA writable_schema = ON", "DELETE FROM sqlite_master WHERE type = 'trigger'",
            "UPDATE sqlite_master SET sql = replace(sql, ' NOT NULL', '') WHERE type = 'table'", "PRAGMA writable_schema = OFF"}));
    }

    void fill(SmallFleet& fleet)
    {
        m_signed = fleet.addSwing("2026-11-21", eightPoints());
        QVERIFY(fleet.stores.signing.complete(m_signed));
        QVERIFY(fleet.stores.signing.sign(m_signed, {SignatureRole::Performer, "Ada", "PL 12", "", ""}));
        QVERIFY(fleet.stores.signing.sign(m_signed, {SignatureRole::Inspector, "Ben", "PL 7", "", ""}));
        loosen(fleet.stores);
    }

    static bool damage(const QString& path, const Cell& cell, const char* value)
    {
        test::RawDatabase raw(path);
        return raw.run({"PRAGMA ignore_check_constraints = ON", "PRAGMA foreign_keys = OFF",
            QStringLiteral("UPDATE %1 SET %2 = %3 WHERE rowid = (SELECT MAX(rowid) FROM %1)")
                .arg(QString(cell.table), QString(cell.column), QString(value))});
    }

private slots:
    void recordsStandWhateverACellHolds()
    {
        int damaged = 0, told = 0;
        std::size_t next = 0;
        for (const Cell& cell : kCells)
            for (int turn = 0; turn < 2; ++turn) {
                const char* value = kBad[next++ * 7 % std::size(kBad)];
                static const QRegularExpression figures(QStringLiteral("_deg$|_id$|position|entries"));
                if (QString(value).contains(QStringLiteral("9e999")) && !figures.match(cell.column).hasMatch())
                    value = "''"; // a column of texts would hold the word Inf, which is one
                const QString name = QStringLiteral("%1.%2 = %3").arg(QString(cell.table), QString(cell.column), QString(value));
                SmallFleet fleet;
                fill(fleet);
                if (!damage(fleet.stores.location(), cell, value))
                    continue; // SQLite itself refuses it
                ++damaged;
                OpenWindow open(fleet.stores);
                for (const FleetItem& item : {FleetItem(fleet.type), FleetItem(fleet.aircraft), FleetItem(fleet.compass),
                         FleetItem(fleet.swing), FleetItem(m_signed)}) {
                    open.window.go(item);
                    every::settle();
                    expectNoFigureThatIsNone(open, name);
                }
                if (fleet.stores.swings.record(m_signed))
                    continue;
                ++told;
                QVERIFY2(!open.window.messages().messages().isEmpty(), qPrintable(name + ": nothing is said"));
            }
        QVERIFY2(damaged > 50, qPrintable(QString::number(damaged)));
        QVERIFY2(told > 10, qPrintable(QString::number(told)));
    }

    void everyPageStandsOnADamagedFile()
    {
        for (const auto& [cell, value] : {std::pair(Cell{"swing", "kind"}, "99"), std::pair(Cell{"compass", "name"}, "zeroblob(5)"),
                 std::pair(Cell{"reading", "compass_heading_deg"}, "9e999"),
                 std::pair(Cell{"limits_profile", "max_deviation_deg"}, "'x'")}) {
            SmallFleet fleet;
            fill(fleet);
            QVERIFY(damage(fleet.stores.location(), cell, value));
            OpenWindow open(fleet.stores);
            auto* stack = open.window.findChild<PageStack*>();
            for (const PageDescription& page : stack->descriptions()) {
                for (const FleetItem& item : {FleetItem(fleet.compass), FleetItem(m_signed)})
                    static_cast<void>(stack->show(Destination{page.id, item}));
                every::settle();
                expectNoFigureThatIsNone(open, page.id);
            }
        }
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::DamagedWindowTest)
#include "DamagedWindowTest.moc"
