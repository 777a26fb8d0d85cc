#include "ui/due/DueRulesTable.h"

#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>

#include "core/due/DueList.h"
#include "ui/kit/OpenCell.h"
#include "ui/kit/StoredEdit.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

enum RuleColumn { Name, Months, Grace, Warn, Document, Issue, Type, kRuleColumns };

QString allTypes() { return DueRulesTable::tr("all"); }

Result<int> wholeNumber(const QString& text, int least, const QString& what)
{
    bool whole = false;
    const int value = text.trimmed().toInt(&whole);
    if (!whole || value < least || value > 100000)
        return Error{ErrorCode::InvalidInput,
            said(DueRulesTable::tr("'%1' is not allowed for %2; expected a whole number from %3 on").arg(text, what).arg(least))};
    return value;
}

} // namespace

DueRulesTable::DueRulesTable(EditContext& context, QUndoStack& undo, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_stores(context.stores)
    , m_undo(undo)
    , m_table(new QTableWidget(0, kRuleColumns))
    , m_remove(new QPushButton(tr("&Remove the rule")))
    , m_known(new QPushButton(tr("Take over &known rules")))
{
    m_table->setObjectName(QStringLiteral("dueRules"));
    m_table->setHorizontalHeaderLabels(
        {tr("Rule"), tr("Months"), tr("Grace (days)"), tr("Warn (days)"), tr("Document"), tr("Issue"), tr("Aircraft type")});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_remove->setObjectName(QStringLiteral("removeRule"));
    m_known->setObjectName(QStringLiteral("knownRules"));
    m_known->setToolTip(tr("24 months (CASA) and 12 months (South Africa): the only calendar rules whose source could be read"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_known);
    buttons->addWidget(m_remove);
    buttons->addStretch();
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_table, 1);
    column->addLayout(buttons);
    // Queued: storing shows the rules anew, which would delete the item that is just being changed.
    connect(m_table, &QTableWidget::cellChanged, this, &DueRulesTable::takeCell, Qt::QueuedConnection);
    connect(m_remove, &QPushButton::clicked, this, &DueRulesTable::remove);
    connect(m_known, &QPushButton::clicked, this, &DueRulesTable::addKnown);
    connect(&m_stores.changes(), &db::Changes::dueChanged, this, &DueRulesTable::reload);
}

void DueRulesTable::reload()
{
    if (waitsForCell(*m_table, this, &DueRulesTable::reload))
        return;
    auto rules = m_stores.due.rules();
    const auto types = m_stores.fleet.types();
    if (!rules || !types) {
        emit failed(messageOf(rules ? types.error() : rules.error()));
        return;
    }
    m_rules = std::move(rules.value());
    m_typeNames.clear();
    for (const TypeRow& row : *types)
        if (const auto type = m_stores.fleet.type(row.id))
            m_typeNames.emplace_back(type->record, type->name);
    fill();
}

void DueRulesTable::fill()
{
    const QSignalBlocker quiet(m_table);
    const bool writable = !m_stores.readOnly();
    m_table->setRowCount(static_cast<int>(m_rules.size()) + (writable ? 1 : 0));
    m_table->setEditTriggers(writable
            ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed
            : QAbstractItemView::NoEditTriggers);
    m_remove->setEnabled(writable && !m_rules.empty());
    m_known->setEnabled(writable);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const bool there = row < static_cast<int>(m_rules.size());
        const DueRule rule = there ? m_rules[static_cast<std::size_t>(row)] : DueRule();
        const auto type = std::find_if(m_typeNames.begin(), m_typeNames.end(), [&](const auto& one) { return one.first == rule.type; });
        const QStringList cells{toText(rule.name), QString::number(rule.months), QString::number(rule.graceDays),
            QString::number(rule.warnDays), toText(rule.document), toText(rule.issue),
            type != m_typeNames.end() ? toText(type->second)
                : rule.type.empty()   ? allTypes()
                                      : tr("a type without compasses")};
        for (int column = 0; column < kRuleColumns; ++column)
            m_table->setItem(row, column, new QTableWidgetItem(there ? cells[column] : QString()));
        if (!there)
            m_table->item(row, Name)->setToolTip(tr("Type a name to make a new rule"));
    }
    m_table->resizeColumnsToContents();
}

void DueRulesTable::takeCell(int row, int column)
{
    const QTableWidgetItem* item = m_table->item(row, column);
    if (!item)
        return;
    const QString text = item->text().trimmed();
    const bool known = row < static_cast<int>(m_rules.size());
    const DueRule before = known ? m_rules[static_cast<std::size_t>(row)] : DueRule();
    DueRule rule = before;
    if (row >= static_cast<int>(m_rules.size()) && column != Name)
        return; // a rule begins with its name
    Result<int> number = 0;
    switch (column) {
    case Name: rule.name = text.toStdString(); break;
    case Months:
        number = wholeNumber(text, 1, tr("months"));
        if (number)
            rule.months = *number;
        break;
    case Grace:
        number = wholeNumber(text, 0, tr("days of grace"));
        if (number)
            rule.graceDays = *number;
        break;
    case Warn:
        number = wholeNumber(text, 0, tr("days of warning"));
        if (number)
            rule.warnDays = *number;
        break;
    case Document: rule.document = text.toStdString(); break;
    case Issue: rule.issue = text.toStdString(); break;
    case Type: {
        const auto type = std::find_if(m_typeNames.begin(), m_typeNames.end(), [&](const auto& one) { return toText(one.second) == text; });
        if (type == m_typeNames.end() && !text.isEmpty() && text != allTypes())
            number = Error{ErrorCode::InvalidInput, said(tr("there is no aircraft type %1; expected one of the fleet, or all").arg(text))};
        else
            rule.type = type == m_typeNames.end() ? RecordId() : type->first;
        break;
    }
    default: break;
    }
    if (!number) {
        emit failed(messageOf(number.error()));
        reload();
    } else if (known) {
        edit(before, rule, tr("change of the rule %1").arg(toText(rule.name)));
    } else {
        rule.record = newRecordId();
        edit({}, rule, tr("new rule"));
    }
}

void DueRulesTable::edit(std::optional<DueRule> before, std::optional<DueRule> after, const QString& text)
{
    static const StoredBy<DueRule> kBy{[](db::Stores& stores, const DueRule& rule) { return noValue(stores.due.add(rule)); },
        [](db::Stores& stores, const DueRule& known, const DueRule& rule) { return stores.due.change(known, rule); },
        [](db::Stores& stores, const DueRule& rule) { return stores.due.removeRule(rule.record); }};
    m_undo.push(new StoredEdit(m_context, kBy, std::move(before), std::move(after), text, Destination{QStringLiteral("due")}));
    reload();
}

void DueRulesTable::remove()
{
    const int row = m_table->currentRow();
    if (row < 0 || row >= static_cast<int>(m_rules.size()))
        return;
    const DueRule rule = m_rules[static_cast<std::size_t>(row)];
    edit(rule, {}, tr("removal of the rule %1").arg(toText(rule.name)));
}

void DueRulesTable::addKnown()
{
    for (DueRule known : knownRules()) {
        if (std::any_of(m_rules.begin(), m_rules.end(), [&](const DueRule& rule) { return rule.name == known.name; }))
            continue;
        known.record = newRecordId();
        edit({}, known, tr("new rule"));
    }
}

} // namespace lubberline::ui
