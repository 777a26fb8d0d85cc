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
