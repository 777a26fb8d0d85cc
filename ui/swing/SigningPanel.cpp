#include "ui/swing/SigningPanel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

#include "core/record/ClockDates.h"
#include "core/record/SwingDifferences.h"
#include "ui/audit/AuditWords.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/TableFit.h"
#include "ui/swing/KeyChecks.h"
#include "ui/swing/SwingEditor.h"

namespace lubberline::ui {

namespace {

constexpr int kRowHeight_px = 22, kMostShown = 6;

/// As high as its rows, up to a few.
void fit(QTableWidget& table)
{
    const int shown = std::min(table.rowCount(), kMostShown);
    int height = heightOfRows(table, 0) + 2;
    for (int row = 0; row < shown; ++row)
        height += table.rowHeight(row);
    table.setFixedHeight(height);
    table.setVisible(table.rowCount() > 0);
}

QTableWidget* readOnlyTable(const char* name, const QStringList& heads)
{
    auto* table = new QTableWidget(0, static_cast<int>(heads.size()));
    table->setObjectName(QString::fromLatin1(name));
    wrapHeadings(*table);
    table->setHorizontalHeaderLabels(heads);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(kRowHeight_px);
    table->horizontalHeader()->setStretchLastSection(true);
    table->setTabKeyNavigation(false);
    // Words that go on beneath make a row higher: the table is as high as its rows are then.
    // Later: rows are fitted while the panel is laid out, which then knows nothing of it.
    QObject::connect(
        table->verticalHeader(), &QHeaderView::sectionResized, table,
        [table] {
            fit(*table);
            if (QWidget* panel = table->parentWidget(); panel && panel->layout()) {
                panel->layout()->invalidate();
                panel->layout()->activate();
            }
        },
        Qt::QueuedConnection);
    return table;
}

void addRow(QTableWidget& table, const QStringList& cells)
{
    const int row = table.rowCount();
    table.insertRow(row);
    for (int column = 0; column < cells.size(); ++column) {
        auto* item = new QTableWidgetItem(cells[column]);
        item->setToolTip(cells[column]);
        table.setItem(row, column, item);
    }
}

} // namespace

QString SigningPanel::standsFor(const Signature& one, const SignatureState& state)
{
    QStringList words{isForged(state.key) ? tr("✗")
            : state.holds                 ? tr("✓ what the swing says now (%1…)").arg(toText(one.hash.substr(0, 12)))
            : state.since.empty()         ? tr("✗ no longer: the swing was changed after it")
                                          : tr("✗ no longer")};
    for (const SwingDifference& difference : state.since)
        words += tr("signed as %1: %2").arg(toText(difference.what), toText(difference.before));
    words += !one.hasKey() || state.key.state == KeyState::NameOnly ? tr("name not verified")
        : state.key.words.empty()                                   ? tr("the key is being checked …")
                                                                    : toText(state.key.words);
    return words.join(QStringLiteral(" · "));
}

SigningPanel::SigningPanel(EditContext& context, const SwingEditor& editor, KeyChecks& keys, QWidget* parent)
    : QFrame(parent)
    , m_context(context)
    , m_editor(editor)
    , m_keys(keys)
    , m_strip(new QLabel)
    , m_statement(new QLabel)
    , m_signatures(readOnlyTable("signatures", {tr("role"), tr("name"), tr("licence"), tr("time (UTC)"), tr("stands for")}))
    , m_trail(new QLabel)
    , m_signRow(new QWidget)
    , m_role(new QComboBox)
    , m_key(new QComboBox)
    , m_name(new QLineEdit)
    , m_licence(new QLineEdit)
    , m_sign(new QPushButton(tr("&Sign")))
    , m_cancel(new QPushButton(tr("Waiting for the key: cancel")))
    , m_reason(new QLineEdit)
    , m_change(new QPushButton)
    , m_amend(new QPushButton(tr("Amend in a new &revision")))
    , m_differences(readOnlyTable("differences", {tr("what"), tr("before"), tr("now")}))
    , m_showAudit(new QToolButton)
    , m_audit(readOnlyTable("auditTrail", {tr("time (UTC)"), tr("what was done"), tr("from"), tr("to"), tr("by")}))
    , m_listing([this](const Result<std::vector<db::OpenPgpKey>>& found) { showKeys(found); })
    , m_byKey([this](const Result<Signature>& made) { finishSigning(made); })
{
    build();
}

void SigningPanel::build()
{
    setFrameShape(QFrame::StyledPanel);
    m_strip->setObjectName(QStringLiteral("stateStrip"));
    m_strip->setTextFormat(Qt::RichText);
    m_statement->setObjectName(QStringLiteral("signStatement"));
    m_statement->setWordWrap(true);
    m_trail->setObjectName(QStringLiteral("trailFaults"));
    m_trail->setTextFormat(Qt::PlainText);
    m_trail->setWordWrap(true);
    m_role->setObjectName(QStringLiteral("signRole"));
    m_role->addItems(choiceWords<SignatureRole>());
    m_name->setObjectName(QStringLiteral("signName"));
    m_name->setPlaceholderText(tr("name"));
    m_licence->setObjectName(QStringLiteral("signLicence"));
    m_licence->setPlaceholderText(tr("licence, stamp or service number"));
    m_sign->setObjectName(QStringLiteral("signButton"));
    m_cancel->setObjectName(QStringLiteral("cancelSigning"));
    m_cancel->hide();
    m_key->setObjectName(QStringLiteral("signKey"));
    m_key->addItem(tr("name only, not verified"));
    m_key->setToolTip(tr("An OpenPGP key of yours, from gpg's key ring or a card: it verifies the name"));
    m_reason->setObjectName(QStringLiteral("stateReason"));
    m_reason->setPlaceholderText(tr("reason"));
    m_change->setObjectName(QStringLiteral("changeState"));
    m_amend->setObjectName(QStringLiteral("amendButton"));
    for (QPushButton* button : {m_sign, m_change, m_amend})
        button->setAutoDefault(true);
    m_showAudit->setObjectName(QStringLiteral("showAudit"));
    m_showAudit->setText(tr("All that was &done to it"));
    m_showAudit->setCheckable(true);
    m_showAudit->setArrowType(Qt::RightArrow);
    m_showAudit->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto* row = new QHBoxLayout(m_signRow);
    row->setContentsMargins(0, 0, 0, 0);
    for (QWidget* part : {static_cast<QWidget*>(m_role), static_cast<QWidget*>(m_key), static_cast<QWidget*>(m_name),
             static_cast<QWidget*>(m_licence), static_cast<QWidget*>(m_sign), static_cast<QWidget*>(m_cancel)})
        row->addWidget(part);
    auto* state = new QHBoxLayout;
    state->addWidget(m_strip, 1);
    state->addWidget(m_reason);
    state->addWidget(m_change);
    state->addWidget(m_amend);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 4, 8, 4);
    column->addLayout(state);
    column->addWidget(m_statement);
    column->addWidget(m_signatures);
    column->addWidget(m_trail);
    column->addWidget(m_signRow);
    column->addWidget(m_differences);
    column->addWidget(m_showAudit);
    column->addWidget(m_audit);
    m_audit->hide();
    connect(m_name, &QLineEdit::returnPressed, m_licence, qOverload<>(&QWidget::setFocus));
    connect(m_licence, &QLineEdit::returnPressed, this, &SigningPanel::sign);
    connect(m_reason, &QLineEdit::returnPressed, this, [this] { // one of both is seen
        (m_amend->isVisibleTo(this) ? m_amend : m_change)->click();
    });
    connect(m_sign, &QPushButton::clicked, this, &SigningPanel::sign);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_byKey.cancel(); });
    connect(m_change, &QPushButton::clicked, this, &SigningPanel::changeState);
    connect(m_amend, &QPushButton::clicked, this, &SigningPanel::amend);
    connect(&m_keys, &KeyChecks::checked, this, [this] {
        if (isVisibleTo(parentWidget()))
            fillSignatures();
    });
    connect(m_showAudit, &QToolButton::toggled, this, &SigningPanel::showAudit);
}

const SwingRecord& SigningPanel::record() const { return m_editor.record(); }

void SigningPanel::show(const QString& meaning)
{
    const auto& swing = record().swing;
    const auto used = usedReadings(swing).size();
    QString statement = tr("%1 · %2 · %3: %n readings that count. ", nullptr, static_cast<int>(used))
                            .arg(toText(record().aircraft.registration), toText(record().compass.name), toText(swing.date))
        + meaning;
    m_statement->setText(statement);
    showState();
    showSignatures();
    showDifferences();
    if (m_showAudit->isChecked())
        showAudit();
}

void SigningPanel::showState()
{
    const SwingState state = record().swing.state;
    QStringList steps;
    for (const SwingState step : {SwingState::Draft, SwingState::Complete, SwingState::Signed})
        steps += step == state ? QStringLiteral("<b>● %1</b>").arg(wordFor(step)) : QStringLiteral("○ %1").arg(wordFor(step));
    QString revision;
    if (record().swing.revision > 1)
        revision = tr(" · revision %1, because: %2").arg(record().swing.revision).arg(toText(record().swing.amendment).toHtmlEscaped());
    m_strip->setText(steps.join(QStringLiteral(" → ")) + revision);
    const bool writable = !m_context.stores.readOnly();
    m_change->setText(state == SwingState::Draft ? tr("&Complete") : tr("Open a&gain"));
    m_change->setVisible(writable && state != SwingState::Signed);
    for (QPushButton* button : {m_change, m_sign}) { // nobody puts a name to results that are not there yet
        button->setEnabled(!m_editor.computing() && !m_byKey.running());
        button->setToolTip(m_editor.computing() ? tr("The results are being computed") : QString());
    }
    const bool doubted = state == SwingState::Draft && !doubtOfClock(record().swing.date, m_context.stores.clock().today()).empty();
    m_reason->setVisible(writable && (state != SwingState::Draft || doubted));
    m_reason->setPlaceholderText(doubted ? tr("how the day is known") : tr("reason"));
    m_amend->setVisible(writable && state == SwingState::Signed);
    m_signRow->setVisible(writable && state != SwingState::Draft);
    listKeys();
    m_role->setCurrentIndex(record().swing.signatures.empty() ? 0 : state == SwingState::Signed ? 2 : 1);
}

void SigningPanel::showSignatures()
{
    m_keys.check(record());
    fillSignatures();
    showTrail();
}

void SigningPanel::fillSignatures()
{
    const auto& verdicts = m_keys.verdicts();
    m_signatures->setRowCount(0);
    const auto states = m_context.stores.signing.states(record().swing.id);
    const auto& signatures = record().swing.signatures;
    for (std::size_t i = 0; i < signatures.size(); ++i) {
        const auto& one = signatures[i];
        SignatureState state = states && i < states->size() ? (*states)[i] : SignatureState{};
        if (i < verdicts.size())
            state.key = verdicts[i];
        addRow(*m_signatures, {wordFor(one.role), toText(one.name), toText(one.licence), toText(one.timeUtc), standsFor(one, state)});
    }
    fit(*m_signatures);
}

/// What speaks against the record as it stands: its own entries of the audit trail, and a clock that would sign in the past.
void SigningPanel::showTrail()
{
    QStringList lines;
    const auto faults = m_context.stores.signing.trailFaults(record().swing.record);
    for (const Message& fault : faults ? *faults : std::vector<Message>{faults.error().message})
        lines += tr("✗ Audit trail: %1").arg(toText(fault));
    const auto last = m_context.stores.signing.clockStandsBefore();
    if (last && !last->empty())
        lines += tr("The clock of this machine stands before the last entry of the audit trail (%1): what is signed now would seem older.")
                     .arg(toText(*last));
    m_trail->setText(lines.join(QLatin1Char('\n')));
    m_trail->setVisible(!lines.isEmpty());
}

/// Against the revision that this one amends.
void SigningPanel::showDifferences()
{
    m_differences->setRowCount(0);
    if (!record().swing.supersedes.empty()) {
        const auto rows = m_context.stores.swings.swingsOf(record().compass.id);
        for (const auto& row : rows ? *rows : std::vector<SwingRow>()) {
            const auto other = m_context.stores.swings.record(row.id);
            if (!other || other->swing.record != record().swing.supersedes)
                continue;
            for (const auto& one : differencesBetween(other->swing, record().swing))
                addRow(*m_differences, {toText(one.what), toText(one.before), toText(one.after)});
        }
    }
    fit(*m_differences);
}

void SigningPanel::showAudit()
{
    const bool shown = m_showAudit->isChecked();
    m_showAudit->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
    m_audit->setRowCount(0);
    if (shown) {
        const auto rows = m_context.stores.signing.auditOf(record().swing.record);
        for (const auto& row : rows ? *rows : std::vector<AuditRow>())
            for (const AuditLine& line : auditLines(row))
                addRow(*m_audit, {line.when, line.what, line.before, line.after, line.who});
    }
    fit(*m_audit);
}

bool SigningPanel::done(const Result<void>& result)
{
    if (!result)
        emit failed(messageOf(result.error()));
    else
        m_reason->clear();
    return result.ok();
}

/// Nobody answers for what he has not seen: where another window or program has stored something a moment ago, it is shown, and nothing done.
Result<void> SigningPanel::asSeen(const std::function<Result<void>()>& act)
{
    const auto look = [&]() -> Result<void> {
        auto transaction = m_context.stores.begin();
        if (!transaction)
            return transaction.error();
        const auto stored = m_context.stores.swings.record(record().swing.id);
        if (!stored)
            return stored.error();
        if (!(*stored == record()))
            return Error{ErrorCode::Conflict,
                said(tr(
                    "this swing has been changed in another window or by another program since it was shown here; nothing was done, look at it again"))};
        if (auto acted = act(); !acted)
            return acted;
        return transaction->commit();
    };
    auto looked = look();
    if (!looked && (looked.error().code == ErrorCode::Conflict || looked.error().code == ErrorCode::NotFound))
        m_context.stores.changes().announceFleet();
    return looked;
}

void SigningPanel::changeState()
{
    const SwingId id = record().swing.id;
    done(asSeen([&]() -> Result<void> {
        if (record().swing.state == SwingState::Draft)
            return m_context.stores.signing.complete(id, m_reason->text().trimmed().toStdString());
        return m_context.stores.signing.reopen(id, m_reason->text().trimmed().toStdString());
    }));
}

void SigningPanel::sign()
{
    if (m_editor.computing())
        return;
    Signature signature;
    signature.role = static_cast<SignatureRole>(m_role->currentIndex());
    signature.name = m_name->text().trimmed().toStdString();
    signature.licence = m_licence->text().trimmed().toStdString();
    signature.key = m_key->currentData().toString().toStdString();
    if (!signature.key.empty()) {
        signWithKey(std::move(signature));
        return;
    }
    if (done(asSeen([&] { return m_context.stores.signing.sign(record().swing.id, signature); }))) {
        m_name->clear();
        m_licence->clear();
        m_name->setFocus();
    }
}

void SigningPanel::amend()
{
    SwingId made;
    const auto amended = asSeen([&]() -> Result<void> {
        const auto id = m_context.stores.signing.amend(record().swing.id, m_reason->text().trimmed().toStdString());
        if (id)
            made = *id;
        return id ? Result<void>() : id.error();
    });
    if (!amended) {
        emit failed(messageOf(amended.error()));
        m_reason->setFocus();
        return;
    }
    m_reason->clear();
    emit openSwing(made);
}

void SigningPanel::askReason() { m_reason->setFocus(Qt::OtherFocusReason); }

void SigningPanel::focusField()
{
    if (record().swing.state == SwingState::Draft)
        m_change->setFocus(Qt::OtherFocusReason);
    else
        m_name->setFocus(Qt::OtherFocusReason);
}

} // namespace lubberline::ui
