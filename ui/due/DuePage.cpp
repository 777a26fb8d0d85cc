#include "ui/due/DuePage.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

#include "core/base/OutputFile.h"
#include "ui/due/DueRulesTable.h"
#include "ui/kit/DueBadge.h"
#include "ui/kit/Words.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

enum Column { State, TypeName, Compass, Since, Reason, LastSigned, Next, kColumns };
enum Filter { DueNow, DueOrSoon, Everything };

QTableWidgetItem* cell(const QString& text)
{
    auto* item = new QTableWidgetItem(inAngleStyle(text));
    item->setToolTip(item->text());
    return item;
}

void plain(QTableWidget& table, const char* name, const QStringList& heads)
{
    table.setObjectName(QString::fromLatin1(name));
    table.setHorizontalHeaderLabels(heads);
    table.verticalHeader()->hide();
    table.horizontalHeader()->setStretchLastSection(true);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setSelectionMode(QAbstractItemView::SingleSelection);
    table.setTabKeyNavigation(false);
}

} // namespace

DuePage::DuePage(EditContext& context, QUndoStack& undo, std::function<Date()> today, FileQuestions questions, QWidget* parent)
    : Page(parent)
    , m_stores(context.stores)
    , m_today(std::move(today))
    , m_questions(std::move(questions))
    , m_state(new QComboBox)
    , m_type(new QComboBox)
    , m_words(new QLineEdit)
    , m_table(new QTableWidget(0, kColumns))
    , m_count(new QLabel)
    , m_flags(new QTableWidget(0, 3))
    , m_reason(new QLineEdit)
    , m_by(new QLineEdit)
    , m_waive(new QPushButton(tr("&Waive")))
    , m_open(new QPushButton(tr("&Open the compass")))
    , m_rules(new DueRulesTable(context, undo))
{
    build();
}

void DuePage::build()
{
    auto* tabs = new QTabWidget;
    tabs->addTab(buildList(), tr("What is due"));
    tabs->addTab(m_rules, tr("Calendar rules"));
    setTitle(tr("What is due"));
    body().addWidget(tabs, 1);
    connect(m_rules, &DueRulesTable::failed, this, &DuePage::failed);
    connect(tabs, &QTabWidget::currentChanged, this, [this](int tab) {
        if (tab == 1)
            m_rules->reload();
    });
    setFocusProxy(m_table);
}

QWidget* DuePage::buildList()
{
    m_state->setObjectName(QStringLiteral("dueFilter"));
    m_state->addItems({tr("due now"), tr("due now or soon"), tr("everything")});
    m_state->setCurrentIndex(DueOrSoon);
    m_type->setObjectName(QStringLiteral("dueType"));
    m_words->setObjectName(QStringLiteral("dueWords"));
    m_words->setPlaceholderText(tr("aircraft, compass or reason"));
    m_words->setClearButtonEnabled(true);
    auto* calendar = new QPushButton(tr("Write a &calendar (.ics)…"));
    calendar->setObjectName(QStringLiteral("dueCalendar"));
    plain(*m_table, "dueTable", {tr("State"), tr("Type"), tr("Compass"), tr("Since"), tr("Reason"), tr("Last signed"), tr("By calendar")});
    plain(*m_flags, "dueFlags", {tr("State"), tr("Since"), tr("Reason")});
    m_flags->setMaximumHeight(130);
    m_reason->setObjectName(QStringLiteral("waiverReason"));
    m_reason->setPlaceholderText(tr("why no swing is needed, as: two headings 90° apart show no change"));
    m_by->setObjectName(QStringLiteral("waiverBy"));
    m_by->setPlaceholderText(tr("who answers for it"));
    m_waive->setObjectName(QStringLiteral("waiveButton"));
    m_waive->setToolTip(tr("A waiver is kept for ever and answers this one event"));
    m_open->setObjectName(QStringLiteral("dueOpen"));
    m_open->setToolTip(tr("Its page, where swings are begun and events recorded"));
    for (QWidget* part : {static_cast<QWidget*>(m_reason), static_cast<QWidget*>(m_by)})
        part->setEnabled(!m_stores.readOnly());
    auto* filters = new QHBoxLayout;
    for (QWidget* part :
        {static_cast<QWidget*>(m_state), static_cast<QWidget*>(m_type), static_cast<QWidget*>(m_words), static_cast<QWidget*>(calendar)})
        filters->addWidget(part);
    auto* waiver = new QHBoxLayout;
    waiver->addWidget(m_reason, 3);
    waiver->addWidget(m_by, 1);
    waiver->addWidget(m_waive);
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->addLayout(filters);
    column->addWidget(m_table, 1);
    auto* below = new QHBoxLayout;
    m_count->setWordWrap(true);
    below->addWidget(m_count, 1);
    below->addWidget(m_open);
    column->addLayout(below);
    column->addWidget(m_flags);
    column->addLayout(waiver);
    connect(m_state, &QComboBox::currentIndexChanged, this, &DuePage::fill);
    connect(m_type, &QComboBox::currentIndexChanged, this, &DuePage::fill);
    connect(m_words, &QLineEdit::textChanged, this, &DuePage::fill);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, [this] {
        showFlags();
        keepChoice();
    });
    const auto open = [this] {
        if (const DueLine* line = current())
            emit openCompass(line->compass.aircraft, line->compass.compass);
    };
    connect(m_table, &QTableWidget::itemActivated, this, open);
    connect(m_open, &QPushButton::clicked, this, open);
    connect(m_flags, &QTableWidget::itemSelectionChanged, this, [this] {
        offerWaiver();
        keepChoice();
    });
    connect(m_by, &QLineEdit::returnPressed, this, &DuePage::waive);
    connect(m_waive, &QPushButton::clicked, this, &DuePage::waive);
    connect(calendar, &QPushButton::clicked, this, &DuePage::exportCalendar);
    return page;
}

void DuePage::show(std::shared_ptr<const DueNews> news)
{
    m_news = std::move(news);
    const QSignalBlocker quiet(m_type);
    const QString kept = m_type->currentText();
    QStringList types{tr("all types")};
    for (const auto& line : m_news->lines)
        if (const QString name = toText(line.compass.typeName); !types.contains(name))
            types += name;
    m_type->clear();
    m_type->addItems(types);
    m_type->setCurrentIndex(std::max(0, m_type->findText(kept)));
    fill();
}

bool DuePage::wanted(const DueLine& line) const
{
    const DueState least = m_state->currentIndex() == DueNow ? DueState::Due
        : m_state->currentIndex() == DueOrSoon               ? DueState::DueSoon
                                                             : DueState::NotDue;
    if (line.answer.state < least)
        return false;
    if (m_type->currentIndex() > 0 && toText(line.compass.typeName) != m_type->currentText())
        return false;
    QString all = toText(line.compass.registration + ' ' + line.compass.compassName);
    for (const auto& flag : line.answer.flags)
        all += ' ' + toText(flag.reason);
    return all.contains(m_words->text().trimmed(), Qt::CaseInsensitive);
}

void DuePage::fill()
{
    if (!m_news)
        return;
    m_shown.clear();
    for (const auto& line : m_news->lines)
        if (wanted(line))
            m_shown.push_back(&line);
    const QSignalBlocker quiet(m_table);
    m_table->setRowCount(static_cast<int>(m_shown.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const DueLine& line = *m_shown[static_cast<std::size_t>(row)];
        const auto* flag = line.answer.flags.empty() ? nullptr : &line.answer.flags.front();
        auto* state = cell(dueWord(line.answer.state));
        state->setIcon(dueIcon(line.answer.state));
        m_table->setItem(row, State, state);
        m_table->setItem(row, TypeName, cell(toText(line.compass.typeName)));
        // In one column, whose words go on beneath: with one for each the table scrolled sideways on small screens.
        m_table->setItem(row, Compass, cell(toText(line.compass.registration + " · " + line.compass.compassName)));
        m_table->setItem(row, Since, cell(flag ? toText(flag->since) : QString()));
        m_table->setItem(row, Reason, cell(flag ? toText(flag->reason) : QString()));
        m_table->setItem(row, LastSigned, cell(line.answer.lastSigned.empty() ? tr("none") : toText(line.answer.lastSigned)));
        m_table->setItem(row, Next, cell(toText(line.answer.nextByCalendar)));
    }
    m_table->resizeColumnsToContents();
    QString count = tr("%1 of %2 compasses, on %3").arg(m_shown.size()).arg(m_news->lines.size()).arg(toText(m_today()));
    if (m_news->rules.empty())
        count += tr(". No calendar rule is set: see the second tab.");
    if (!m_news->forecastsAreNew)
        count += tr(". What the fleet's history expects is being computed.");
    if (!m_news->warnings.empty())
        count += tr(". Not predicted after a move: %1").arg(toText(m_news->warnings.front()));
    m_count->setText(count);
    const auto chosen
        = std::find_if(m_shown.begin(), m_shown.end(), [this](const DueLine* line) { return line->compass.compass == m_chosen; });
    m_table->clearSelection();
    m_table->setCurrentItem(nullptr);
    if (!m_shown.empty())
        m_table->selectRow(chosen == m_shown.end() ? 0 : static_cast<int>(chosen - m_shown.begin()));
    showFlags();
    keepChoice();
}

void DuePage::keepChoice()
{
    const DueLine* line = current();
    const DueFlag* flag = currentFlag();
    m_chosen = line ? line->compass.compass : CompassId();
    const RecordId event = flag ? flag->event : RecordId();
    if (event != std::exchange(m_chosenEvent, event))
        m_reason->clear(); // it was meant for another
}

const DueLine* DuePage::current() const
{
    const int row = m_table->currentRow();
    return row >= 0 && row < static_cast<int>(m_shown.size()) ? m_shown[static_cast<std::size_t>(row)] : nullptr;
}

const DueFlag* DuePage::currentFlag() const
{
    const DueLine* line = current();
    const int row = m_flags->currentRow();
    return line && row >= 0 && row < static_cast<int>(line->answer.flags.size()) ? &line->answer.flags[static_cast<std::size_t>(row)]
                                                                                 : nullptr;
}

/// Only events are waived: a calendar rule or a move is answered by a swing.
void DuePage::offerWaiver()
{
    const DueFlag* flag = currentFlag();
    m_waive->setEnabled(flag && !flag->event.empty() && !m_stores.readOnly());
}

/// The flag that was chosen stays chosen; else the first that can be waived is.
void DuePage::showFlags()
{
    const QSignalBlocker quiet(m_flags);
    const DueLine* line = current();
    const auto count = line ? line->answer.flags.size() : 0;
    m_flags->setRowCount(static_cast<int>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const DueFlag& flag = line->answer.flags[i];
        auto* state = cell(dueWord(flag.state));
        state->setIcon(dueIcon(flag.state));
        m_flags->setItem(static_cast<int>(i), 0, state);
        m_flags->setItem(static_cast<int>(i), 1, cell(toText(flag.since)));
        m_flags->setItem(static_cast<int>(i), 2, cell(toText(flag.reason)));
    }
    m_open->setEnabled(line);
    m_flags->clearSelection();
    m_flags->setCurrentItem(nullptr);
    std::size_t chosen = count;
    for (std::size_t i = count; i-- > 0;)
        if (const RecordId& event = line->answer.flags[i].event;
            !event.empty() && (chosen == count || line->answer.flags[chosen].event != m_chosenEvent))
            chosen = i;
    if (chosen < count)
        m_flags->selectRow(static_cast<int>(chosen));
    offerWaiver();
}

void DuePage::waive()
{
    const DueFlag* flag = currentFlag();
    if (!flag || flag->event.empty()) {
        emit failed(tr("Only an event is waived; a calendar rule or a move is answered by a swing."));
        return;
    }
    Waiver waiver;
    waiver.event = flag->event;
    waiver.date = m_today();
    waiver.reason = m_reason->text().trimmed().toStdString();
    waiver.by = m_by->text().trimmed().toStdString();
    if (waiver.reason.empty() || waiver.by.empty()) {
        emit failed(tr("A waiver is kept for ever: state why no swing is needed, and who answers for it."));
        return;
    }
    if (const auto stored = m_stores.due.add(waiver); !stored) {
        emit failed(messageOf(stored.error()));
        return;
    }
    m_reason->clear();
    m_by->clear();
}

void DuePage::exportCalendar()
{
    if (!m_news)
        return;
    const QString path = m_questions.save(tr("Write a calendar"), QStringLiteral("compass-swings.ics"), tr("Calendar (*.ics)"));
    if (path.isEmpty())
        return;
    const auto entries = calendarOf(m_news->lines);
    if (const auto written = writeWholeFile(path.toStdString(), writeCalendar(entries, m_today().text() + "T00:00:00Z")); !written)
        emit failed(messageOf(written.error()));
    else
        emit done(tr("%1: %n dates", nullptr, static_cast<int>(entries.size())).arg(path));
}

} // namespace lubberline::ui
