// The catalogues that are built in: a core error in Polish with its plural forms, and English that stays where files need it.

#include <QCoreApplication>
#include <QFile>
#include <QTest>
#include <QXmlStreamReader>

#include "core/base/Message.h"
#include "ui/text/ChoiceWords.h"
#include "ui/text/Language.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

Message countedReadings(int readings)
{
    return {MARKED_N("core", "%n reading(s) with both headings; expected at least 3 on different headings"), readings};
}

} // namespace

class LanguageTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { speak({"en"}); }

    void theFirstThatThereIsIsSpoken()
    {
        QCOMPARE(speak({"pl_PL.UTF-8"}), QString("pl"));
        QCOMPARE(speak({"tlh", "pl-PL", "en"}), QString("pl"));
        QCOMPARE(speak({"en-GB", "pl"}), QString("en"));
        QCOMPARE(speak({"C"}), QString("en"));
        QCOMPARE(speak({"tlh"}), QString("en"));
        QCOMPARE(speak({}), QString("en"));
        QCOMPARE(wordFor(SwingKind::Check), QString("check swing"));
    }

    void theEnvironmentGoesBeforeTheSystem()
    {
        const QByteArray before = qgetenv("LUBBERLINE_LANGUAGE");
        qputenv("LUBBERLINE_LANGUAGE", "pl");
        QCOMPARE(wantedLanguages(), QStringList{"pl"});
        qunsetenv("LUBBERLINE_LANGUAGE");
        QVERIFY(!wantedLanguages().isEmpty());
        if (!before.isNull())
            qputenv("LUBBERLINE_LANGUAGE", before);
    }

    void coreSpeaksPolishWithItsThreePlurals()
    {
        QCOMPARE(speak({"pl"}), QString("pl"));
        QCOMPARE(translated(countedReadings(1)), QString("1 odczyt z oboma kursami; oczekiwano co najmniej 3 na różnych kursach"));
        QCOMPARE(translated(countedReadings(2)), QString("2 odczyty z oboma kursami; oczekiwano co najmniej 3 na różnych kursach"));
        QCOMPARE(translated(countedReadings(5)), QString("5 odczytów z oboma kursami; oczekiwano co najmniej 3 na różnych kursach"));
        QCOMPARE(translated(countedReadings(12)), QString("12 odczytów z oboma kursami; oczekiwano co najmniej 3 na różnych kursach"));
        QCOMPARE(translated(countedReadings(22)), QString("22 odczyty z oboma kursami; oczekiwano co najmniej 3 na różnych kursach"));
        QCOMPARE(wordFor(SwingKind::Correction), QString("pomiar kompensacyjny"));
        QCOMPARE(choiceWords<SwingStage>(), (QStringList{"stan zastany", "stan końcowy", "nie podano"}));
        // What is not translated yet is English, with its plural.
        QCOMPARE(translated(Message{MARKED_N("core", "%n thing(s) nobody translated"), 2}), QString("2 things nobody translated"));
        QCOMPARE(QCoreApplication::translate("nobody", "%n thing(s)", nullptr, 1), QString("1 thing"));
        QCOMPARE(QCoreApplication::translate("nobody", "%n thing(s)", nullptr, 5), QString("5 things"));
        // Commands and files do not ask the language.
        QCOMPARE(QString::fromStdString(countedReadings(2).english()),
            QString("2 readings with both headings; expected at least 3 on different headings"));
        QCOMPARE(QString::fromStdString(std::string(fileWord(SwingKind::Correction))), QString("correction"));
    }

    /// What is filled in stays filled in: a translation that loses %1 would lose a figure.
    void aTranslationHasThePlacesOfItsSource()
    {
        QFile file(QStringLiteral(LUBBERLINE_CATALOGUE));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&file);
        QString source;
        int translated = 0;
        const auto places = [](const QString& text) {
            QStringList all;
            for (qsizetype at = text.indexOf('%'); at >= 0; at = text.indexOf('%', at + 1))
                if (const QString place = text.mid(at, 2); place.size() == 2 && (place[1].isDigit() || place[1] == 'n'))
                    all += place;
            all.sort();
            return all;
        };
        const auto check = [&](const QString& text) {
            if (text.isEmpty())
                return;
            ++translated;
            QVERIFY2(places(text) == places(source), qPrintable(source + " | " + text));
        };
        while (!xml.atEnd()) {
            xml.readNext();
            if (!xml.isStartElement())
                continue;
            if (xml.name() == QLatin1String("source"))
                source = xml.readElementText();
            else if (xml.name() == QLatin1String("numerusform"))
                check(xml.readElementText());
            else if (xml.name() == QLatin1String("translation"))
                if (QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements); !source.contains("%n"))
                    check(text);
        }
        QVERIFY(!xml.hasError());
        QVERIFY(translated > 1000);
    }
};

QTEST_MAIN(LanguageTest)
#include "LanguageTest.moc"
