#include "ui/calibration/CoilPanel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>

#include "ui/calibration/TestWidgets.h"
#include "ui/kit/StoredEdit.h"
#include "ui/kit/Words.h"
#include "ui/report/forms/SensorTestSheets.h"

namespace lubberline::ui {

namespace {

QLabel* coilWords(const char* name)
{
    auto* label = new QLabel;
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QLineEdit* coilLine(const char* name, const QString& hint)
{
    auto* line = new QLineEdit;
    line->setObjectName(QString::fromLatin1(name));
    line->setPlaceholderText(hint);
    line->setAccessibleName(hint);
    return line;
}

} // namespace

CoilPanel::CoilPanel(EditContext& context, QUndoStack& undo, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_undo(undo)
    , m_words(coilWords("testsCoilWords"))
    , m_drift(coilWords("coilDrift"))
    , m_result(testTable("testsCoil", tr("Coil bench")))
    , m_kept(testTable("coilKept", tr("Kept benches")))
    , m_date(coilLine("coilDate", tr("date of the bench: today")))
    , m_serial(coilLine("coilSerial", tr("serial number of the sensor")))
    , m_note(coilLine("coilNote", tr("note: bench, coil, by whom")))
    , m_keep(new QPushButton(tr("&Keep with the compass")))
    , m_remove(new QPushButton(tr("Remove the bench")))
{
    build();
    setCompass({});
}

void CoilPanel::build()
{
    m_keep->setObjectName(QStringLiteral("coilKeep"));
    m_remove->setObjectName(QStringLiteral("coilRemove"));
    m_words->setText(
        tr("A coil bench needs the applied field beside the measured one: ax_nT, ay_nT, az_nT; temperature_c where it was read."));
    m_kept->setSelectionBehavior(QAbstractItemView::SelectRows);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_words);
    column->addWidget(m_result, 3);
    auto* row = new QHBoxLayout;
    for (QWidget* one : std::initializer_list<QWidget*>{m_date, m_serial, m_note, m_keep})
        row->addWidget(one);
    column->addLayout(row);
    column->addWidget(m_kept, 2);
    auto* below = new QHBoxLayout;
    below->addWidget(m_drift, 1);
    below->addWidget(m_remove);
    column->addLayout(below);
    connect(m_keep, &QPushButton::clicked, this, &CoilPanel::keep);
    connect(m_remove, &QPushButton::clicked, this, &CoilPanel::remove);
    connect(m_kept, &QTableWidget::itemSelectionChanged, this, &CoilPanel::showDrift);
    connect(&m_context.stores.changes(), &db::Changes::sensorsChanged, this, [this](CompassId compass) {
        if (compass == m_compass)
            reload();
    });
}

void CoilPanel::setCompass(CompassId compass)
{
    m_compass = compass;
    m_compassSerial.clear();
    if (compass.valid())
        if (const auto system = m_context.stores.fleet.compass(compass))
            m_compassSerial = system->serialNumber;
    m_serial->setText(toText(m_compassSerial));
    for (QWidget* one : std::initializer_list<QWidget*>{m_date, m_serial, m_note, m_keep, m_kept, m_remove, m_drift})
        one->setVisible(compass.valid());
    reload();
}

void CoilPanel::show(const std::shared_ptr<const SensorLog>& log, const Result<CoilResult>& result, const QString& name)
{
    m_log = log;
    m_name = name;
    m_measured = result.ok();
    m_keep->setEnabled(m_measured && !m_context.stores.readOnly());
    if (!result) {
        m_words->setText(messageOf(result.error()));
        m_result->setRowCount(0);
        showDrift();
        return;
    }
    QStringList lines{coilAngles(*result)};
    for (const Message& warning : result->warnings)
        lines += toText(warning);
    m_words->setText(lines.join(u'\n'));
    fillFrom(*m_result, coilTable(*result));
    showDrift();
}

void CoilPanel::reload()
{
    m_benches.clear();
    if (m_compass.valid()) {
        if (auto benches = m_context.stores.coilBenches.of(m_compass))
            m_benches = std::move(*benches);
        else
            emit failed(messageOf(benches.error()));
    }
    fillFrom(*m_kept, benchesTable(m_benches));
    m_keep->setEnabled(m_measured && !m_context.stores.readOnly());
    showDrift();
}

Result<CoilBench> CoilPanel::typed() const
{
    auto bench = coilRecordOf(*m_log);
    if (!bench)
        return bench;
    const QString date = m_date->text().trimmed();
    const auto day = date.isEmpty() ? std::optional(m_context.stores.clock().today()) : Date::read(date.toStdString());
    if (!day)
        return Error{ErrorCode::InvalidInput, said(tr("“%1” is no day; expected YYYY-MM-DD").arg(date))};
    bench->date = *day;
    bench->serialNumber = m_serial->text().trimmed().toStdString();
    bench->note = m_note->text().trimmed().toStdString();
    bench->log = m_name.toStdString();
    return bench;
}

/// Two that are chosen with each other; one with the one before it; else the log with the newest.
void CoilPanel::showDrift()
{
    QList<int> chosen;
    for (const auto& index : m_kept->selectionModel()->selectedRows())
        chosen += index.row();
    std::sort(chosen.begin(), chosen.end());
    m_remove->setEnabled(chosen.size() == 1 && !m_context.stores.readOnly());
    const auto at = [this](int row) -> const CoilBench& { return m_benches[static_cast<std::size_t>(row)]; };
    const auto count = static_cast<int>(m_benches.size());
    QStringList lines;
    if (chosen.size() == 2)
        lines = driftWords(at(chosen[1]), at(chosen[0]));
    else if (chosen.size() == 1 && chosen[0] + 1 < count)
        lines = driftWords(at(chosen[0] + 1), at(chosen[0]));
    else if (chosen.isEmpty())
        lines = history();
    m_drift->setText(lines.join(u'\n'));
}

QStringList CoilPanel::history() const
{
    if (!m_measured || m_benches.empty())
        return {};
    const auto now = typed();
    if (!now)
        return {messageOf(now.error())};
    const auto before = std::find_if(m_benches.begin(), m_benches.end(), [&now](const CoilBench& one) { return one.date < now->date; });
    return before != m_benches.end() ? driftWords(*before, *now) : QStringList();
}

void CoilPanel::keep()
{
    auto bench = typed();
    if (!bench) {
        emit failed(messageOf(bench.error()));
        return;
    }
    bench->record = newRecordId();
    store(nullptr, &*bench, tr("coil bench of %1").arg(toText(bench->date)));
    m_keep->setEnabled(false); // once
}

void CoilPanel::remove()
{
    const auto rows = m_kept->selectionModel()->selectedRows();
    if (rows.size() != 1)
        return;
    const CoilBench bench = m_benches[static_cast<std::size_t>(rows.front().row())];
    store(&bench, nullptr, tr("coil bench of %1 removed").arg(toText(bench.date)));
}

void CoilPanel::store(const CoilBench* before, const CoilBench* after, const QString& text)
{
    const StoredBy<CoilBench> by{
        [id = m_compass](db::Stores& stores, const CoilBench& one) { return noValue(stores.coilBenches.add(id, one)); }, {},
        [id = m_compass](db::Stores& stores, const CoilBench& one) { return stores.coilBenches.remove(id, one.record); }};
    const auto copy = [](const CoilBench* one) { return one ? std::optional(*one) : std::nullopt; };
    m_undo.push(new StoredEdit(m_context, by, copy(before), copy(after), text, Destination{QStringLiteral("sensorTests"), m_compass}));
}

} // namespace lubberline::ui
