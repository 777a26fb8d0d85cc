// Records of years on paper through the page: columns are mapped, the first swings are seen, the whole is stored and undone.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "tests/db/TestStores.h"
#include "ui/intake/YearsImportPage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// Six aircraft with four years each; `turned` more with D of the other sign.
QByteArray table(int turned)
{
    QByteArray text = "Nr;Datum;Muster;stage;0;45;90;135;180;225;270;315\n";
    for (int aircraft = 0; aircraft < 6 + turned; ++aircraft)
        for (int year = 0; year < 4; ++year) {
            text += QString("32%1;1.5.%2;Su-22M4;as_found").arg(aircraft, 2, 10, QLatin1Char('0')).arg(2010 + year).toUtf8();
            for (int heading = 0; heading < 360; heading += 45) {
                const double D = (aircraft < 6 ? -2.2 : 2.2) * std::sin(heading * 3.14159265 / 90);
                text += ";" + QByteArray::number(D + 0.1 * ((aircraft + year + heading / 45) % 3), 'f', 1).replace('.', ',');
            }
            text += "\n";
        }
    return text;
}

struct OpenYears {
    test::TestStores stores;
    QTemporaryDir folder;
    QString path;
    std::unique_ptr<YearsImportPage> page;
    QStringList failures, told;

    OpenYears()
    {
        FileQuestions questions;
        questions.open = [this](const QString&, const QString&) { return path; };
        page = std::make_unique<YearsImportPage>(stores, questions);
        QObject::connect(page.get(), &YearsImportPage::failed, page.get(), [this](const QString& message) { failures += message; });
        QObject::connect(page.get(), &YearsImportPage::done, page.get(), [this](const QString& message) { told += message; });
        page->resize(1000, 620);
        page->show();
    }
    void write(const QByteArray& text)
    {
        path = folder.filePath("years.csv");
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("the table is written");
        file.close();
        find<QPushButton>("yearsOpen")->click();
    }
    template <class T>
    T* find(const char* name) const
    {
        auto* found = page->findChild<T*>(QString::fromLatin1(name));
        if (!found)
            qFatal("there is no widget named %s", name);
        return found;
    }
    void choose(const char* name, int index) const
    {
        auto* box = find<QComboBox>(name);
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    void means(int row, const QString& key) const
    {
        auto* box = find<QComboBox>(QString("yearsMeaning%1").arg(row).toLatin1().constData());
        choose(box->objectName().toLatin1().constData(), box->findData(key));
    }
    QString state() const { return find<QLabel>("yearsState")->text(); }
    void map() const
    {
        means(0, "aircraft");
        means(1, "date");
        means(2, "type");
        choose("yearsDates", 1);
        choose("yearsCells", 3);
    }
};

} // namespace

class YearsImportPageTest : public QObject {
    Q_OBJECT

private slots:
    void columnsAreMappedSeenStoredAndUndone()
    {
        OpenYears open;
        open.write(table(0));
        QVERIFY(open.state().contains("is not said")); // nothing is guessed
        QVERIFY(!open.find<QPushButton>("yearsStore")->isEnabled());
        open.map();
        auto* swings = open.find<QTableWidget>("yearsSwings");
        QCOMPARE(swings->rowCount(), 20);
        QCOMPARE(swings->item(0, 2)->text(), QString("3200"));
        QCOMPARE(swings->item(0, 4)->text(), QString("2010-05-01"));
        QVERIFY(std::abs(swings->item(0, 10)->text().replace(QChar(0x2212), '-').toDouble() + 2.2) < 0.1);
        auto* store = open.find<QPushButton>("yearsStore");
        QTRY_VERIFY(store->isEnabled());
        QVERIFY(open.state().startsWith("24 swings with 192 readings; 6 aircraft and 6 compasses are new"));
        QVERIFY(open.stores.whole().swings.empty());
        store->click();
        QTRY_COMPARE(open.told.size(), 1);
        QCOMPARE(open.stores.whole().swings.size(), std::size_t(24));
        QVERIFY(!store->isEnabled());
        auto* undo = open.find<QPushButton>("yearsUndo");
        QVERIFY(undo->isEnabled());
        undo->click();
        QTRY_COMPARE(open.told.size(), 2);
        QVERIFY(open.stores.whole().swings.empty());
        QVERIFY(open.stores.whole().aircraft.empty());
        QVERIFY(!undo->isEnabled());
        QVERIFY(open.failures.isEmpty());
    }

    void suspectSignsAreShownBeforeAnythingIsStored()
    {
        OpenYears open;
        open.write(table(1));
        open.map();
        QTRY_VERIFY(open.find<QPushButton>("yearsStore")->isEnabled());
        auto* findings = open.find<QListWidget>("yearsFindings");
        QCOMPARE(findings->count(), 1);
        QVERIFY(findings->item(0)->text().startsWith("3206"));
        QVERIFY(findings->item(0)->text().contains("suspect"));
        QVERIFY(open.stores.whole().swings.empty());
    }

    void aRowThatIsWrongIsToldWithItsLine()
    {
        OpenYears open;
        open.write(table(0) + "3299;31.2.2012;Su-22M4;as_found;1;1;1;1;1;1;1;1\n");
        open.map();
        QTRY_VERIFY(open.state().contains("years.csv:26: date: \"31.2.2012\" is no day"));
        QVERIFY(!open.find<QPushButton>("yearsStore")->isEnabled());
        open.path = open.folder.filePath("none.csv");
        open.find<QPushButton>("yearsOpen")->click();
        QCOMPARE(open.failures.size(), 1);
    }

    void aSelectedTypeIsOffered()
    {
        OpenYears open;
        AircraftType type;
        type.name = "Su-22M4";
        QVERIFY(open.page->open(*open.stores.save(type)).ok());
        QCOMPARE(open.find<QLineEdit>("yearsType")->text(), QString("Su-22M4"));
    }
};

QTEST_MAIN(YearsImportPageTest)
#include "YearsImportPageTest.moc"
