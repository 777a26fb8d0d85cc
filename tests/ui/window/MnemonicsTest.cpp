// Each letter of a menu and of a page is given once, in English and in Polish.

#include <QGroupBox>
#include <QMenuBar>

#include "tests/ui/window/Fixture.h"
#include "ui/kit/keys/Mnemonics.h"
#include "ui/text/Language.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// Every page of a window, with a compass or else a swing.
struct EachPage {
    SmallFleet fleet;
    SwingId swing = fleet.addSwing("2026-11-20", eightPoints());
    OpenWindow open{fleet.stores};
    PageStack& stack = *open.window.findChild<PageStack*>();

    void look(const std::function<void(const QString& page)>& at)
    {
        for (const PageDescription& page : stack.descriptions()) {
            if (!stack.show(Destination{page.id, fleet.compass}))
                QVERIFY2(static_cast<bool>(stack.show(Destination{page.id, swing})), qPrintable(page.id));
            at(page.id);
        }
    }
};

} // namespace

class MnemonicsTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { speak({"en"}); }
    void lettersAreMadeDistinct();
    void everyLetterOfAMenuIsGivenOnce_data();
    void everyLetterOfAMenuIsGivenOnce();
    void everyLetterOfAPageIsGivenOnce_data() { everyLetterOfAMenuIsGivenOnce_data(); }
    void everyLetterOfAPageIsGivenOnce();

private:
    static void checkMenu(const QMenu& menu)
    {
        QString seen;
        for (const QAction* action : menu.actions()) {
            if (action->isSeparator() || !action->isVisible())
                continue;
            if (action->menu())
                checkMenu(*action->menu());
            const QChar letter = mnemonicOf(action->text());
            QVERIFY2(letter.isNull() || !seen.contains(letter), qPrintable(menu.title() + ": " + action->text()));
            if (!letter.isNull())
                seen += letter;
        }
    }
};

void MnemonicsTest::lettersAreMadeDistinct()
{
    QCOMPARE(distinctMnemonics({"&Open", "&Other", "Off && &on", "plain"}), (QStringList{"&Open", "O&ther", "O&ff && on", "plain"}));
    QCOMPARE(distinctMnemonics({"&File"}, "F"), QStringList{"F&ile"});
    QCOMPARE(distinctMnemonics({"&A", "&A"}), (QStringList{"&A", "A"}));
    QCOMPARE(distinctMnemonics({"&Save", "&Sign or amend"}), (QStringList{"&Save", "Sign &or amend"}));
}

void MnemonicsTest::everyLetterOfAMenuIsGivenOnce_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << "en";
    QTest::newRow("Polish") << "pl";
}

void MnemonicsTest::everyLetterOfAMenuIsGivenOnce()
{
    QFETCH(QString, language);
    QCOMPARE(speak({language}), language);
    EachPage each;
    QString bar;
    for (const QAction* action : each.open.window.menuBar()->actions()) {
        const QChar letter = mnemonicOf(action->text());
        QVERIFY2(!letter.isNull() && !bar.contains(letter), qPrintable(action->text()));
        bar += letter;
    }
    each.look([&](const QString&) {
        for (const QAction* action : each.open.window.menuBar()->actions()) {
            emit action->menu()->aboutToShow();
            checkMenu(*action->menu());
        }
    });
}

void MnemonicsTest::everyLetterOfAPageIsGivenOnce()
{
    QFETCH(QString, language);
    QCOMPARE(speak({language}), language);
    EachPage each;
    each.look([&](const QString& page) {
        QMap<QChar, QString> seen;
        const auto take = [&](const QString& text) {
            const QChar letter = mnemonicOf(text);
            if (letter.isNull())
                return;
            QVERIFY2(!seen.contains(letter), qPrintable(page + ": " + text + " and " + seen.value(letter)));
            seen.insert(letter, text);
        };
        for (const QAction* action : each.open.window.menuBar()->actions())
            take(action->text());
        for (const QLabel* label : each.stack.current().findChildren<QLabel*>())
            if (label->buddy() && label->isVisible())
                take(label->text());
        for (const QAbstractButton* button : each.stack.current().findChildren<QAbstractButton*>())
            if (button->isVisible())
                take(button->text());
        for (const QGroupBox* box : each.stack.current().findChildren<QGroupBox*>())
            if (box->isVisible())
                take(box->title());
    });
}

QTEST_MAIN(MnemonicsTest)
#include "MnemonicsTest.moc"
