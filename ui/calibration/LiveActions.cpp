#include "ui/calibration/LiveActions.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/base/OutputFile.h"
#include "core/format/csv/ActionsCsv.h"
#include "ui/calibration/TestWidgets.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

const QString kActionsKey = QStringLiteral("sensorTests/liveActions"), kStartKey = QStringLiteral("sensorTests/liveStart_ms");

double secondsBetween(Clock::Time from, Clock::Time to) { return static_cast<double>((to - from).count()) / 1000.0; }

QPushButton* liveButton(const char* name, const QString& text)
{
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(name));
    return button;
}

} // namespace

LiveActions::LiveActions(QSettings& settings, FileQuestions questions, const Clock& clock, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_questions(std::move(questions))
    , m_clock(clock)
    , m_begin(liveButton("liveStart", tr("Start &with the log")))
    , m_save(liveButton("liveSave", tr("Sa&ve the actions…")))
    , m_clear(liveButton("liveClear", tr("Clear")))
    , m_action(new QLineEdit)
    , m_words(new QLabel)
    , m_table(testTable("liveActions", tr("Noted actions")))
{
    m_action->setObjectName(QStringLiteral("liveAction"));
    m_action->setAccessibleName(tr("What is switched now"));
    m_action->setPlaceholderText(tr("landing light on: Enter"));
    m_words->setObjectName(QStringLiteral("liveWords"));
    m_words->setWordWrap(true);
    m_table->setColumnCount(2);
    m_table->setHorizontalHeaderLabels({tr("time (s)"), tr("action")});
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    auto* row = new QHBoxLayout;
    row->addWidget(m_begin);
    row->addWidget(m_action, 1);
    row->addWidget(m_save);
    row->addWidget(m_clear);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_words);
    column->addLayout(row);
    column->addWidget(m_table, 1);
    connect(m_begin, &QPushButton::clicked, this, &LiveActions::start);
    connect(m_action, &QLineEdit::returnPressed, this, &LiveActions::note);
    connect(m_save, &QPushButton::clicked, this, &LiveActions::save);
    connect(m_clear, &QPushButton::clicked, this, &LiveActions::clear);
    recall();
    showActions();
}

void LiveActions::start()
{
    m_start = m_clock.now();
    keep();
    showActions();
    m_action->setFocus();
}

void LiveActions::note()
{
    const QString what = m_action->text().trimmed();
    if (what.isEmpty() || !m_start)
        return;
    m_actions.push_back({secondsBetween(*m_start, m_clock.now()), what.toStdString()});
    m_action->clear();
    keep();
    showActions();
}

void LiveActions::clear()
{
    m_start.reset();
    m_actions.clear();
    keep();
    showActions();
}

void LiveActions::save()
{
    const QString path = m_questions.save(tr("Save the actions"), QStringLiteral("actions.csv"), tr("Actions (*.csv)"));
    if (path.isEmpty())
        return;
    if (const auto written = writeWholeFile(path.toStdString(), writeActions(m_actions)); !written)
        emit failed(messageOf(written.error()));
    else
        emit saved(path);
}

/// Each action as it is noted: a program that dies loses none.
void LiveActions::keep()
{
    QVariantList kept;
    for (const TimedAction& action : m_actions)
        kept.append(QVariant(QVariantList{action.time_s, toText(action.action)})); // << would join the two lists
    m_settings.setValue(kActionsKey, kept);
    if (m_start)
        m_settings.setValue(kStartKey, static_cast<qlonglong>(m_start->time_since_epoch().count()));
    else
        m_settings.remove(kStartKey);
}

void LiveActions::recall()
{
    for (const QVariant& one : m_settings.value(kActionsKey).toList())
        if (const QVariantList pair = one.toList(); pair.size() == 2)
            m_actions.push_back({pair[0].toDouble(), pair[1].toString().toStdString()});
    if (m_settings.contains(kStartKey))
        m_start = Clock::Time(std::chrono::milliseconds(m_settings.value(kStartKey).toLongLong()));
}

void LiveActions::showActions()
{
    m_begin->setEnabled(!m_start);
    m_action->setEnabled(m_start.has_value());
    m_save->setEnabled(!m_actions.empty());
    m_clear->setEnabled(m_start || !m_actions.empty());
    m_words->setText(m_start
            ? tr("Let the log run. Switch one thing at a time, note it with Enter at that moment, and wait ten seconds.")
            : tr(
                "To note the actions while the log runs: press Start at the moment at which the log begins; its time is then counted from 0."));
    m_table->setRowCount(static_cast<int>(m_actions.size()));
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const TimedAction& action = m_actions[static_cast<std::size_t>(i)];
        m_table->setItem(i, 0, new QTableWidgetItem(plainNumber(action.time_s, 1)));
        m_table->setItem(i, 1, new QTableWidgetItem(toText(action.action)));
    }
    m_table->scrollToBottom();
}

} // namespace lubberline::ui
