#include "ui/text/Translated.h"

#include <QCoreApplication>
#include <QTest>
#include <QTranslator>

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// A language in which every sentence of core and db is longer and told apart at sight.
class Pseudo : public QTranslator {
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char*, int count) const override
    {
        if (count >= 0)
            return QStringLiteral("«%1:%2»").arg(
                QString::fromUtf8(context), count == 1 ? QStringLiteral("jeden") : QStringLiteral("%n odczyty"));
        return QStringLiteral("«%1:%2»").arg(QString::fromUtf8(context), QString::fromUtf8(source));
    }
};

} // namespace

class TranslatedTest : public QObject {
    Q_OBJECT

private slots:
    void englishWithoutATranslation()
    {
        QCOMPARE(translated(Message{MARKED_N("core", "%n reading(s) of %1"), 3, std::string("it")}), "3 readings of it");
        QCOMPARE(translated(Message{MARKED_N("core", "%n reading(s) of %1"), 1, std::string("it")}), "1 reading of it");
        QCOMPARE(messageOf({ErrorCode::Format, {MARKED("db", "there is no %1"), std::string("ż")}, "a.csv", 2}),
            QString("a.csv:2: there is no ż"));
    }

    void eachPatternInTheLanguageOfTheReader()
    {
        Pseudo pseudo;
        QVERIFY(QCoreApplication::installTranslator(&pseudo));
        const Message inner{MARKED("core", "the line %1"), 7};
        QCOMPARE(translated(Message{MARKED("db", "nothing was stored: %1"), inner}), "«db:nothing was stored: «core:the line 7»»");
        QCOMPARE(translated(Message{MARKED_N("core", "%n reading(s)"), 3}), "«core:3 odczyty»");
        QCOMPARE(translated(Message::verbatim(std::string("disk I/O error"))), "disk I/O error");
        QCOMPARE(translated(said(QStringLiteral("już po polsku"))), "już po polsku");
        QCoreApplication::removeTranslator(&pseudo);
    }
};

QTEST_GUILESS_MAIN(TranslatedTest)
#include "TranslatedTest.moc"
