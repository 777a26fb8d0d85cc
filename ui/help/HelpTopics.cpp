#include "ui/help/HelpTopics.h"

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSysInfo>

#include "ui/help/HelpWords.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct TopicWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::HelpTopics)
};

QString escaped(const QString& text) { return text.toHtmlEscaped(); }

QString paragraphs(const QString& text)
{
    QString html;
    for (const QString& line : text.split(u'\n', Qt::SkipEmptyParts))
        html += QStringLiteral("<p>%1</p>").arg(escaped(line));
    return html;
}

QString rowOf(const QStringList& cells)
{
    QString html = QStringLiteral("<tr>");
    for (const QString& cell : cells)
        html += QStringLiteral("<td style='padding: 1px 12px 1px 0'>%1</td>").arg(escaped(cell));
    return html + QStringLiteral("</tr>");
}

/// Without its letter, its dots and its shortcut.
QString plain(QString text)
{
    text.remove(u'&').remove(QStringLiteral("…"));
    return text.section(u'\t', 0, 0);
}

void addShortcuts(QString& html, const QMenu& menu)
{
    for (const QAction* action : menu.actions()) {
        if (action->menu())
            addShortcuts(html, *action->menu());
        if (action->shortcut().isEmpty())
            continue;
        QStringList keys;
        for (const QKeySequence& one : action->shortcuts())
            keys += one.toString(QKeySequence::NativeText);
        html += rowOf({keys.join(QStringLiteral(", ")), plain(action->text())});
    }
}

/// As they are: what the menus of this window have.
QString shortcuts(const PageContext& context)
{
    QString html;
    for (const QMenuBar* bar : context.window.findChildren<QMenuBar*>())
        for (const QAction* action : bar->actions())
            if (action->menu()) {
                html += QStringLiteral("<h3>%1</h3><table>").arg(escaped(plain(action->text())));
                addShortcuts(html, *action->menu());
                html += QStringLiteral("</table>");
            }
    html += QStringLiteral("<h3>%1</h3><table>").arg(escaped(TopicWords::tr("Everywhere")));
    for (const auto& [keys, what] : keysEverywhere())
        html += rowOf({keys, what});
    return html + QStringLiteral("</table>");
}

QString glossaryTable()
{
    QString html = QStringLiteral("<dl>");
    for (const auto& [term, meaning] : glossary())
        html += QStringLiteral("<dt><b>%1</b></dt><dd>%2</dd>").arg(escaped(term), escaped(meaning));
    return html + QStringLiteral("</dl>");
}

QString licenceTable()
{
    QString html = paragraphs(licenceText());
    for (const LicenceTable& table : licences()) {
        html += QStringLiteral("<h3>%1</h3><table>").arg(escaped(table.title));
        for (const QStringList& row : table.rows)
            html += rowOf(row);
        html += QStringLiteral("</table>");
    }
    return html;
}

QString titleOf(const PageDescription& page)
{
    if (const QString name = pageName(page.id); !name.isEmpty())
        return name;
    return page.commands.empty() ? page.id : plain(page.commands.front().text);
}

QString thisDatabase(const PageContext& context)
{
    const auto totals = context.stores.fleet.totals();
    QString html = QStringLiteral("<table>");
    html += rowOf({TopicWords::tr("Version"), QStringLiteral("Lubberline ") + QCoreApplication::applicationVersion()});
    html += rowOf({TopicWords::tr("Database"), QDir::toNativeSeparators(QFileInfo(context.stores.location()).absoluteFilePath())});
    html += rowOf({TopicWords::tr("Size"), QLocale().formattedDataSize(QFileInfo(context.stores.location()).size())});
    if (totals)
        html += rowOf({TopicWords::tr("Aircraft, compasses, swings"),
            QStringLiteral("%1, %2, %3").arg(totals->aircraft).arg(totals->compasses).arg(totals->swings)});
    html += rowOf({TopicWords::tr("Settings"), QDir::toNativeSeparators(context.settings.fileName())});
    return html + QStringLiteral("</table>")
        + paragraphs(TopicWords::tr(
            "Aircraft magnetic deviation: from the readings to the correction card. Deviation = magnetic − compass, east positive.\n"
            "Based in part on the work of the Qwt project (http://qwt.sf.net). Free software under the GNU General Public License, version 3 or later, without any warranty."));
}

} // namespace

QString problemReport(const PageContext& context)
{
    const QSize screen = QGuiApplication::primaryScreen() ? QGuiApplication::primaryScreen()->size() : QSize();
    const QScreen* shown = context.window.screen();
    return QStringList{QStringLiteral("Lubberline %1").arg(QCoreApplication::applicationVersion()),
        QStringLiteral("Qt %1, %2, %3").arg(QLatin1String(qVersion()), QGuiApplication::platformName(), QSysInfo::prettyProductName()),
        QStringLiteral("%1 %2").arg(QSysInfo::kernelType(), QSysInfo::currentCpuArchitecture()),
        TopicWords::tr("locale %1, time %2").arg(QLocale().name(), toText(context.stores.clock().nowUtc())),
        TopicWords::tr("screen %1x%2, scale %3, window %4x%5")
            .arg(screen.width())
            .arg(screen.height())
            .arg(shown ? shown->devicePixelRatio() : 1.0)
            .arg(context.window.width())
            .arg(context.window.height()),
        TopicWords::tr("database of %1 bytes%2")
            .arg(QFileInfo(context.stores.location()).size())
            .arg(context.stores.readOnly() ? TopicWords::tr(", read only") : QString()),
        TopicWords::tr("undo steps %1, last: %2").arg(context.undo.count()).arg(context.undo.undoText()), QString(),
        TopicWords::tr("What was done:"), QString(), TopicWords::tr("What happened, and what was expected:"), QString()}
        .join(u'\n');
}

std::vector<HelpTopic> helpTopics(const PageContext& context)
{
    std::vector<HelpTopic> topics{{QStringLiteral("begin"), TopicWords::tr("How to begin"), paragraphs(beginText())},
        {QStringLiteral("shortcuts"), TopicWords::tr("Shortcuts"), shortcuts(context)},
        {QStringLiteral("glossary"), TopicWords::tr("Glossary"), glossaryTable()},
        {QStringLiteral("derivation"), TopicWords::tr("Where a number comes from"), paragraphs(derivationText())},
        {QStringLiteral("licences"), TopicWords::tr("Licences and data sources"), licenceTable()},
        {QStringLiteral("about"), TopicWords::tr("This program and this database"), thisDatabase(context)},
        {QStringLiteral("problem"), TopicWords::tr("Report a problem"),
            paragraphs(problemText()) + QStringLiteral("<pre>%1</pre>").arg(escaped(problemReport(context)))}};
    for (const PageDescription& page : context.pages())
        if (!page.help.isEmpty())
            topics.push_back({page.id, titleOf(page), paragraphs(page.help)});
    return topics;
}

} // namespace lubberline::ui
