#include "ui/help/HelpPage.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QListWidget>
#include <QPushButton>
#include <QSplitter>
#include <QTextBrowser>

#include <algorithm>

#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

HelpPage::HelpPage(PageContext& context, std::shared_ptr<QString> wanted, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_wanted(std::move(wanted))
    , m_list(new QListWidget)
    , m_text(new QTextBrowser)
    , m_copy(new QPushButton(tr("&Copy this")))
    , m_save(new QPushButton(tr("Save &as text…")))
{
    setTitle(tr("Help"));
    m_list->setObjectName(QStringLiteral("helpTopics"));
    m_list->setAccessibleName(tr("Topics"));
    m_list->setWordWrap(true);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_text->setObjectName(QStringLiteral("helpText"));
    m_text->setAccessibleName(tr("Text of the topic"));
    m_text->setOpenExternalLinks(true);
    m_copy->setObjectName(QStringLiteral("copyHelp"));
    m_save->setObjectName(QStringLiteral("saveHelp"));
    head().addWidget(m_copy);
    head().addWidget(m_save);
    auto* splitter = new QSplitter;
    splitter->addWidget(m_list);
    splitter->addWidget(m_text);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({240, 700});
    body().addWidget(splitter, 1);
    setFocusProxy(m_list);
    connect(m_list, &QListWidget::currentRowChanged, this, &HelpPage::showTopic);
    connect(m_copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_text->toPlainText()); });
    connect(m_save, &QPushButton::clicked, this, &HelpPage::saveText);
}

QString HelpPage::topic() const
{
    const int row = m_list->currentRow();
    return row < 0 ? QString() : m_topics[static_cast<std::size_t>(row)].id;
}

/// The topics are made anew: shortcuts and figures may be others.
Result<void> HelpPage::open(const FleetItem&)
{
    const QString wanted = m_wanted->isEmpty() ? topic() : *m_wanted;
    m_wanted->clear();
    m_topics = helpTopics(m_context);
    m_list->clear();
    for (const HelpTopic& one : m_topics)
        m_list->addItem(one.title);
    const auto found = std::find_if(m_topics.begin(), m_topics.end(), [&](const HelpTopic& one) { return one.id == wanted; });
    m_list->setCurrentRow(found == m_topics.end() ? 0 : static_cast<int>(found - m_topics.begin()));
    return {};
}

void HelpPage::showTopic()
{
    if (const int row = m_list->currentRow(); row >= 0) {
        const HelpTopic& shown = m_topics[static_cast<std::size_t>(row)];
        m_text->setHtml(QStringLiteral("<h2>%1</h2>%2").arg(shown.title.toHtmlEscaped(), shown.html));
    }
}

void HelpPage::saveText()
{
    const QString path = m_context.files.save(tr("Save as text"), QStringLiteral("lubberline-%1.txt").arg(topic()), tr("Text (*.txt)"));
    if (path.isEmpty())
        return;
    if (const auto written = writeWholeFile(path.toStdString(), m_text->toPlainText().toStdString()); !written)
        emit failed(messageOf(written.error()));
}

PageDescription HelpPage::description(PageContext& context)
{
    auto wanted = std::make_shared<QString>();
    PageDescription page{QStringLiteral("help"), [&context, wanted] { return new HelpPage(context, wanted); }};
    const auto topic = [&context, wanted](const QString& id) {
        return [&context, wanted, id](Page&) {
            *wanted = id;
            context.go({"help", {}, true});
        };
    };
    page.commands = {{MenuId::Help, 100, tr("&Help on this page"), QKeySequence::HelpContents, "help",
                         [&context, wanted](Page&) {
                             *wanted = context.pageInFront();
                             context.go({"help", {}, true});
                         }},
        {MenuId::Help, 110, tr("&Contents"), tr("Shift+F1"), "helpContents", topic(QStringLiteral("begin"))},
        {MenuId::Help, 120, tr("&Shortcuts"), {}, "helpShortcuts", topic(QStringLiteral("shortcuts"))},
        {MenuId::Help, 130, tr("&Glossary"), {}, "helpGlossary", topic(QStringLiteral("glossary"))},
        {MenuId::Help, 140, tr("Where a &number comes from"), {}, "helpDerivation", topic(QStringLiteral("derivation"))},
        {MenuId::Help, 200, tr("&Licences and data sources"), {}, "helpLicences", topic(QStringLiteral("licences"))},
        {MenuId::Help, 210, tr("&Report a problem…"), {}, "helpProblem", topic(QStringLiteral("problem"))},
        {MenuId::Help, 300, tr("&About this program and database"), {}, "about", topic(QStringLiteral("about"))}};
    page.help = tr(
        "Topics at the left, the one that is chosen at the right. F1 on any page opens its topic; a topic is copied or saved as text with the buttons above.");
    return page;
}

} // namespace lubberline::ui
