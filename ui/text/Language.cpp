#include "ui/text/Language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QRegularExpression>
#include <QTranslator>

#include <memory>

namespace lubberline::ui {

namespace {

/// "pl" of "pl-PL", "pl_PL.UTF-8" and "PL".
QString languageOf(const QString& name)
{
    static const QRegularExpression kEnd(QStringLiteral("[-_.@]"));
    return name.trimmed().section(kEnd, 0, 0).toLower();
}

/// "3 readings" and "1 reading" of "%n reading(s)": English has no catalogue that says so.
class EnglishPlurals final : public QTranslator {
public:
    QString translate(const char*, const char* source, const char*, int count) const override
    {
        QString text = QString::fromUtf8(source);
        return count < 0 || !text.contains(QStringLiteral("(s)"))
            ? QString()
            : text.replace(QStringLiteral("(s)"), QStringLiteral("s").left(count != 1));
    }
    bool isEmpty() const override { return false; }
};

/// It ends with the application, as Qt wants it.
void install(std::unique_ptr<QTranslator> translator)
{
    translator->setParent(QCoreApplication::instance());
    QCoreApplication::installTranslator(translator.release());
}

} // namespace

QStringList wantedLanguages(const QString& preferred)
{
    const QString chosen = qEnvironmentVariable("LUBBERLINE_LANGUAGE");
    if (!chosen.trimmed().isEmpty())
        return {chosen};
    return preferred.isEmpty() ? QLocale::system().uiLanguages() : QStringList{preferred};
}

QString speak(const QStringList& languages)
{
    qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly));
    const QString english = QStringLiteral("en");
    install(std::make_unique<EnglishPlurals>()); // another language stands before it
    for (const QString& wanted : languages) {
        const QString language = languageOf(wanted);
        if (language == english || language == QStringLiteral("c"))
            return english;
        auto ours = std::make_unique<QTranslator>();
        if (!ours->load(QStringLiteral(":/translations/lubberline_%1.qm").arg(language)))
            continue;
        auto qts = std::make_unique<QTranslator>(); // the buttons of Qt's own dialogs, where the system has them
        if (qts->load(QStringLiteral("qtbase_") + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            install(std::move(qts));
        install(std::move(ours));
        return language;
    }
    return english;
}

} // namespace lubberline::ui
