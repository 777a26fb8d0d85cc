#include "ui/bench/IronBenchPage.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

#include "core/base/OutputFile.h"
#include "core/format/exchange/BenchJson.h"
#include "core/record/DefaultNames.h"
#include "ui/bench/BenchDrawing.h"
#include "ui/bench/BenchResults.h"
#include "ui/bench/BenchRows.h"
#include "ui/bench/BenchTables.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/FlowLayout.h"
#include "ui/kit/fit/SideBySide.h"

namespace lubberline::ui {

namespace {

const QString kBenchFilter = QStringLiteral("Bench JSON (*.json)");
constexpr int kPatience_ms = 300;

} // namespace

IronBenchPage::IronBenchPage(EditContext& context, QUndoStack& stack, FileQuestions files, QWidget* parent)
    : Page(parent)
    , m_files(std::move(files))
    , m_stores(context.stores)
    , m_editor(new SensorEditor(context, stack, this))
    , m_worker([this](const Result<BenchModel>& model) { take(model); }, [this](int percent) { m_progress->setValue(percent); })
{
    build();
    connectParts();
}

IronBenchPage::~IronBenchPage() { m_tables->disconnect(this); }

void IronBenchPage::build()
{
    messageLine().setObjectName(QStringLiteral("benchMessage"));
    auto* work = new QHBoxLayout;
    m_progress = new QProgressBar;
    m_cancel = new QPushButton(tr("Cancel"));
    m_cancel->setObjectName(QStringLiteral("benchCancel"));
    work->addWidget(m_progress, 1);
    work->addWidget(m_cancel);
    m_progress->hide();
    m_cancel->hide();
    body().addLayout(work);
    body().addWidget(buildTools());
    m_tables = new BenchTables;
    m_drawing = new BenchDrawing;
    m_drawing->setObjectName(QStringLiteral("benchDrawing"));
    m_results = new BenchResults(m_stores.clock());
    auto* across = new SideBySide;
    across->addWidget(m_drawing);
    across->addWidget(m_results);
    across->setSizes({480, 540});
    auto* vertical = new QSplitter(Qt::Vertical);
    vertical->addWidget(m_tables);
    vertical->addWidget(across);
    vertical->setSizes({260, 400});
    body().addWidget(vertical, 1);
}

QWidget* IronBenchPage::buildTools()
{
    auto* box = new QWidget;
    auto* tools = new FlowLayout(box);
    m_stateBoxes = new QWidget;
    m_stateBoxes->setLayout(new FlowLayout);
    tools->addWidget(m_stateBoxes);
    m_load = new QPushButton(tr("Load…"));
    m_load->setObjectName(QStringLiteral("benchLoad"));
    connect(m_load, &QPushButton::clicked, this, &IronBenchPage::load);
    auto* save = new QPushButton(tr("Save…"));
    save->setObjectName(QStringLiteral("benchSave"));
    connect(save, &QPushButton::clicked, this, &IronBenchPage::save);
    tools->addWidget(m_load);
    tools->addWidget(save);
    return box;
}

void IronBenchPage::connectParts()
{
    connect(m_editor, &SensorEditor::changed, this, &IronBenchPage::showStored);
    connect(m_editor, &SensorEditor::failed, this, &IronBenchPage::failed);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience_ms);
    connect(&m_patience, &QTimer::timeout, this, [this] { showWork(m_worker.running()); });
    connect(m_tables, &BenchTables::changed, this, &IronBenchPage::takeTables);
    connect(m_tables, &BenchTables::partChosen, m_drawing, &BenchDrawing::setSelected);
    connect(m_drawing, &BenchDrawing::partChosen, m_tables, &BenchTables::selectPart);
    connect(m_drawing, &BenchDrawing::partMoved, this, &IronBenchPage::takeMove);
    connect(m_drawing, &BenchDrawing::readOut, this, &IronBenchPage::readOut);
}

Result<void> IronBenchPage::showCompass(CompassId id)
{
    const auto compass = m_stores.fleet.compass(id);
    if (!compass)
        return compass.error();
    const auto aircraft = m_stores.fleet.aircraft(compass->aircraft);
    if (!aircraft)
        return aircraft.error();
    if (const auto opened = m_editor->open(id); !opened)
        return opened.error();
    m_results->showFieldOf(m_stores, id);
    setTitle(tr("Iron bench · %1 · %2").arg(toText(aircraft->registration), toText(compass->name)));
    return {};
}

/// The record that is open if it is a bench, else the newest bench.
void IronBenchPage::showStored()
{
    const auto& records = m_editor->records();
    if (!m_editor->record() || !m_editor->record()->bench)
        for (std::size_t i = 0; i < records.size(); ++i)
            if (records[i].bench && static_cast<int>(i) != m_editor->current())
                return m_editor->choose(static_cast<int>(i)); // comes back here
    const SensorRecord* record = m_editor->record();
    IronBench bench = record && record->bench ? *record->bench : IronBench();
    BenchStates states = record && record->bench ? record->benchStates : BenchStates();
    m_load->setEnabled(m_editor->editable());
    if (m_result && bench == m_bench && states == m_states)
        return; // what was just stored: the cell that is being typed in stays
    m_bench = std::move(bench);
    m_states = std::move(states);
    showBench();
    m_settle = false;
    recompute();
}

void IronBenchPage::showBench()
{
    m_tables->show(rowsOf(m_bench), m_editor->editable());
    showStates();
    m_drawing->setBench(m_bench, m_states);
    m_drawing->setMovable(m_editor->editable());
}

void IronBenchPage::showStates()
{
    qDeleteAll(m_stateBoxes->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    for (const auto& [group, states] : groupsOf(m_bench)) {
        auto* box = new QComboBox;
        box->setObjectName(QStringLiteral("benchState_") + toText(group));
        for (const auto& state : states)
            box->addItem(toText(state));
        if (const auto chosen = m_states.find(group); chosen != m_states.end())
            box->setCurrentText(toText(chosen->second));
        connect(box, &QComboBox::activated, this, [this, box, name = group] {
            m_states[name] = box->currentText().toStdString();
            m_drawing->setBench(m_bench, m_states);
            m_settle = m_editor->editable();
            recompute();
        });
        m_stateBoxes->layout()->addWidget(labelled(toText(group) + ':', box));
    }
}

void IronBenchPage::takeTables()
{
    auto bench = benchOf(m_tables->rows());
    if (!bench)
        return refuseBench(messageOf(bench.error()));
    takeBench(std::move(bench.value()));
}

/// A part that was dragged: in the state that it is shown in.
void IronBenchPage::takeMove(int part, int placement, const Eigen::Vector3d& centre_m)
{
    IronBench bench = m_bench;
    bench.parts.at(static_cast<std::size_t>(part)).placements.at(static_cast<std::size_t>(placement)).centre_m = centre_m;
    m_tables->show(rowsOf(bench), m_editor->editable());
    m_tables->selectPart(part);
    takeBench(std::move(bench));
}

void IronBenchPage::takeBench(IronBench bench)
{
    if (bench == m_bench)
        return say({}); // what was wrong is as it was before
    m_bench = std::move(bench);
    std::erase_if(m_states, [groups = groupsOf(m_bench)](const auto& chosen) { // a state that is no more
        return std::none_of(groups.begin(), groups.end(), [&](const auto& group) {
            return group.first == chosen.first && std::find(group.second.begin(), group.second.end(), chosen.second) != group.second.end();
        });
    });
    showStates();
    m_drawing->setBench(m_bench, m_states);
    m_settle = true;
    recompute();
}

void IronBenchPage::recompute()
{
    say({});
    m_progress->setValue(0);
    m_patience.start();
    m_worker.start([bench = m_bench, states = m_states](const Progress& progress) { return benchModel(bench, states, progress); });
}

void IronBenchPage::take(const Result<BenchModel>& model)
{
    if (model) {
        showResult(*model);
        if (m_settle)
            settle();
    } else if (model.error().code == ErrorCode::Cancelled) {
        refuseBench(tr("The computation was cancelled; nothing was stored."));
    } else {
        refuseBench(messageOf(model.error()));
    }
}

void IronBenchPage::showWork(bool shown)
{
    m_progress->setVisible(shown);
    m_cancel->setVisible(shown);
}

void IronBenchPage::showResult(const BenchModel& model)
{
    m_result = model;
    QStringList warnings;
    for (const auto& warning : model.warnings)
        warnings << toText(warning);
    constexpr int kMostWarnings = 3;
    if (warnings.size() > kMostWarnings)
        warnings = warnings.mid(0, kMostWarnings) << tr("… and %n more", nullptr, static_cast<int>(warnings.size()) - kMostWarnings);
    m_patience.stop();
    showWork(false);
    say(warnings.join('\n'));
    m_results->show(model);
}

/// What was typed and computed goes to storage as one edit.
void IronBenchPage::settle()
{
    m_settle = false;
    SensorRecord after;
    const SensorRecord* record = m_editor->record();
    if (record && record->bench)
        after = *record;
    after.compass = m_editor->compass();
    after.origin = ModelOrigin::IronBench;
    after.model = m_result->model;
    after.bench = m_bench;
    after.benchStates = m_states;
    if (record && record->bench) {
        if (!(after == *record))
            m_editor->change(after, tr("iron bench"));
        return;
    }
    after.name = kBenchModel;
    m_editor->make(after, tr("Make an iron bench"));
}

void IronBenchPage::load()
{
    const QString path = m_files.open(tr("Load a bench"), kBenchFilter);
    if (path.isEmpty())
        return;
    auto bench = readBenchJsonFile(path.toStdString());
    if (!bench) {
        emit failed(messageOf(bench.error()));
        return;
    }
    m_bench = std::move(bench.value());
    m_states.clear();
    showBench();
    m_settle = true;
    recompute();
}

void IronBenchPage::save()
{
    const QString path = m_files.save(tr("Save the bench"), QStringLiteral("bench.json"), kBenchFilter);
    if (path.isEmpty())
        return;
    if (const auto written = writeWholeFile(path.toStdString(), writeBenchJson(m_bench)); !written)
        emit failed(messageOf(written.error()));
}

void IronBenchPage::refuseBench(const QString& why)
{
    refuse(tr("Not stored: %1").arg(why));
    m_patience.stop();
    showWork(false);
}

} // namespace lubberline::ui
