// A field stops where the stores would refuse, and says so.

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTest>
#include <QVBoxLayout>

#include "core/record/Ranges.h"
#include "ui/kit/LengthLimits.h"

namespace lubberline::ui {

class LengthLimitsTest : public QObject {
    Q_OBJECT

private slots:
    void aFieldStopsAtItsLimitWithAWord()
    {
        QStringList said;
        const LengthLimits limits([&said](const QString& words) { said += words; }, nullptr);
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        auto* line = new QLineEdit;
        auto* text = new QPlainTextEdit;
        layout->addWidget(line);
        layout->addWidget(text);
        line->setText(QString(9'000, 'x')); // as it was stored by an import: shown whole
        window.show();
        QCOMPARE(line->text().size(), 9'000);
        QVERIFY(said.isEmpty());
        QApplication::clipboard()->setText(QString(1'000'000, 'y'));
        line->setCursorPosition(0);
        line->paste();
        QCOMPARE(line->text(), QString(QString(1'000, 'y') + QString(9'000, 'x'))); // what was there stays
        QCOMPARE(said.size(), 1);
        QVERIFY2(said.front().contains("10000"), qPrintable(said.front()));
        QTest::keyClick(line, Qt::Key_Z);
        QCOMPARE(line->text().size(), 10'000);
        QVERIFY(said.size() >= 2);
        line->setText(QString(9'998, 'x'));
        said.clear();
        QApplication::clipboard()->setText(QString::fromUtf8("\xC3\xB3\xC3\xB3")); // two letters, four bytes
        line->end(false);
        line->paste();
        QCOMPARE(line->text().toUtf8().size(), 10'000);
        QCOMPARE(said.size(), 1);
        QApplication::clipboard()->setText(QString(20'000, 'y'));
        text->setPlainText("above\nbelow");
        text->moveCursor(QTextCursor::EndOfLine);
        said.clear();
        text->paste();
        QCOMPARE(text->toPlainText().toUtf8().size(), qsizetype(kLongestText));
        QVERIFY(text->toPlainText().startsWith("above"));
        QVERIFY(text->toPlainText().endsWith("\nbelow"));
        QVERIFY(!said.isEmpty());
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::LengthLimitsTest)
#include "LengthLimitsTest.moc"
