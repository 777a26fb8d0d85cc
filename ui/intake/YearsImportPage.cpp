#include "ui/intake/YearsImportPage.h"

#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>

#include <map>

#include "core/record/RecordWords.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/FlowLayout.h"
#include "ui/kit/fit/SideBySide.h"

namespace lubberline::ui {

namespace {

enum MappingColumn { NameColumn, ExamplesColumn, MeaningColumn };
constexpr int kFirstSwings = 20;

void plainTable(QTableWidget& table, const char* name, const QStringList& heads)
{
    table.setObjectName(QString::fromLatin1(name));
    table.setColumnCount(static_cast<int>(heads.size()));
    table.setHorizontalHeaderLabels(heads);
    table.verticalHeader()->hide();
    table.horizontalHeader()->setStretchLastSection(true);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setTabKeyNavigation(false);
}

QComboBox* yearsChoice(const char* name, const QStringList& words)
{
    auto* box = new QComboBox;
    box->setObjectName(QString::fromLatin1(name));
    box->addItems(words);
    return box;
}

/// "Type", "Date" … of a key of the reader.
QString keyWord(const QString& key)
{
    static const std::map<QString, Pattern> words{{"aircraft", MARKED("ui", "registration of the aircraft")},
        {"type", MARKED("ui", "aircraft type")}, {"compass", MARKED("ui", "compass")}, {"date", MARKED("ui", "date")},
        {"site", MARKED("ui", "compass base")}, {"stage", MARKED("ui", "as found or as left")}, {"kind", MARKED("ui", "kind of swing")},
        {"radio", MARKED("ui", "radio on or off")}, {"datum_reader", MARKED("ui", "who read the datum (crew)")},
        {"cockpit_reader", MARKED("ui", "who read the compass")}, {"inspector", MARKED("ui", "inspector")},
        {"adjuster", MARKED("ui", "adjuster")}, {"note", MARKED("ui", "note")}, {"work_order", MARKED("ui", "work order")},
        {"swing", MARKED("ui", "number that tells swings of one day apart")},
        {"magnetic_heading_deg", MARKED("ui", "magnetic heading of a reading")},
        {"compass_heading_deg", MARKED("ui", "compass heading of a reading")},
        {"deviation_deg", MARKED("ui", "deviation of a reading (magnetic \u2212 compass)")},
        {"indication_error_deg", MARKED("ui", "indication error of a reading (compass \u2212 magnetic)")}};
    const auto found = words.find(key);
    return found == words.end() ? key : QStringLiteral("%1 (%2)").arg(toText(Message(found->second)), key);
}

} // namespace

YearsImportPage::YearsImportPage(db::Stores& stores, FileQuestions questions, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_questions(std::move(questions))
    , m_open(new QPushButton(tr("&Open a table…")))
    , m_store(new QPushButton(tr("&Store these swings")))
    , m_undo(new QPushButton(tr("&Undo this import")))
    , m_cancel(new QPushButton(tr("Ca&ncel")))
    , m_file(new QLabel)
    , m_state(new QLabel)
    , m_progress(new QProgressBar)
    , m_columns(new QTableWidget)
    , m_swings(new QTableWidget)
    , m_cells(yearsChoice("yearsCells",
          {tr("— what stands in their cells? —"), tr("compass heading read"), tr("magnetic heading read"),
              tr("deviation (magnetic − compass)"), tr("indication error (compass − magnetic)")})) // behind the first as YearsCells
    , m_by(yearsChoice("yearsBy", {tr("magnetic headings"), tr("compass headings")}))
    , m_dates(yearsChoice("yearsDates", {tr("year-month-day"), tr("day.month.year"), tr("month/day/year")})) // as DateOrder
    , m_stage(yearsChoice("yearsStage", {tr("not stated"), tr("as found"), tr("as left")}))
    , m_kind(yearsChoice("yearsKind", {tr("not stated")}))
    , m_type(new QLineEdit)
    , m_compass(new QLineEdit)
    , m_findings(new QListWidget)
    , m_worker(
          [this](Result<db::YearsOutcome> outcome) { take(std::move(outcome)); }, [this](int percent) { m_progress->setValue(percent); })
{
    build();
}

YearsImportPage::~YearsImportPage() { m_worker.cancel(); }

void YearsImportPage::build()
{
    setTitle(tr("Records of years on paper"));
    say(tr(
        "A table (CSV) of many swings: a row a swing with a column for each heading, or a row a reading. Say what its columns are; nothing is "
        "stored before you have seen how the first swings look."));
    m_open->setObjectName(QStringLiteral("yearsOpen"));
    m_store->setObjectName(QStringLiteral("yearsStore"));
    m_undo->setObjectName(QStringLiteral("yearsUndo"));
    m_cancel->setObjectName(QStringLiteral("yearsCancel"));
    m_state->setObjectName(QStringLiteral("yearsState"));
    m_state->setWordWrap(true);
    m_progress->setMaximumWidth(140);
    m_type->setObjectName(QStringLiteral("yearsType"));
    m_compass->setObjectName(QStringLiteral("yearsCompass"));
    m_findings->setObjectName(QStringLiteral("yearsFindings"));
    m_findings->setWordWrap(true);
    for (const SwingKind kind : {SwingKind::Check, SwingKind::Correction, SwingKind::Calibration, SwingKind::Air})
        m_kind->addItem(toText(Message(shownWord(kind))), toText(std::string(fileWord(kind))));
    plainTable(*m_columns, "yearsColumns", {tr("Column"), tr("In the first rows"), tr("What it is")});
    plainTable(*m_swings, "yearsSwings",
        {tr("Line"), tr("Type"), tr("Aircraft"), tr("Compass"), tr("Date"), tr("Stage"), tr("Readings"), tr("A (°)"), tr("B (°)"),
            tr("C (°)"), tr("D (°)"), tr("E (°)"), tr("Largest (°)")});
    auto* top = new FlowLayout;
    for (QWidget* part : std::initializer_list<QWidget*>{m_open, m_file, m_progress, m_cancel, m_undo, m_store})
        top->addWidget(part);
    auto* upper = new SideBySide;
    upper->addWidget(m_columns);
    upper->addWidget(new SidePanel(buildWhole()));
    upper->setStretchFactor(0, 3);
    upper->setStretchFactor(1, 2);
    auto* lower = new SideBySide;
    lower->addWidget(m_swings);
    lower->addWidget(m_findings);
    lower->setStretchFactor(0, 3);
    lower->setStretchFactor(1, 2);
    auto* all = new QSplitter(Qt::Vertical);
    all->addWidget(upper);
    all->addWidget(lower);
    body().addLayout(top);
    body().addWidget(m_state);
    body().addWidget(all, 1);
    for (auto* box : {m_cells, m_by, m_dates, m_stage, m_kind})
        connect(box, &QComboBox::activated, this, &YearsImportPage::mappingChanged);
    for (auto* line : {m_type, m_compass})
        connect(line, &QLineEdit::editingFinished, this, &YearsImportPage::mappingChanged);
    connect(m_open, &QPushButton::clicked, this, &YearsImportPage::choose);
    connect(m_store, &QPushButton::clicked, this, &YearsImportPage::store);
    connect(m_undo, &QPushButton::clicked, this, &YearsImportPage::undo);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
    setFocusProxy(m_open);
    enable();
}

/// What is said of the whole table.
QWidget* YearsImportPage::buildWhole()
{
    auto* panel = new QWidget;
    auto* form = new QFormLayout(panel);
    form->addRow(tr("Under the headings stands"), m_cells);
    form->addRow(tr("The columns are"), m_by);
    form->addRow(tr("Dates are written"), m_dates);
    form->addRow(tr("Where no column says it, the type is"), m_type);
    form->addRow(tr("the compass is"), m_compass);
    form->addRow(tr("the stage is"), m_stage);
    form->addRow(tr("the kind of swing is"), m_kind);
    return panel;
}

Result<void> YearsImportPage::open(const FleetItem& record)
{
    if (const auto* type = std::get_if<AircraftTypeId>(&record); type && type->valid())
        if (const auto found = m_stores.fleet.type(*type))
            m_type->setText(toText(found->name));
    return {};
}

void YearsImportPage::choose()
{
    if (const QString path = m_questions.open(tr("A table of swings"), tr("Table (*.csv *.tsv *.txt)")); !path.isEmpty())
        readTable(path);
}

void YearsImportPage::readTable(const QString& path)
{
    m_worker.cancel();
    const auto shown = columnsShown(path);
    if (!shown) {
        emit failed(messageOf(shown.error()));
        return;
    }
    m_path = path;
    m_header = shown->header;
    m_file->setText(QFileInfo(path).fileName());
    m_file->setToolTip(path);
    fillColumns(*shown);
    mappingChanged();
}

void YearsImportPage::fillColumns(const YearsColumnsShown& shown)
{
    const auto keys = yearsKeys();
    m_columns->setRowCount(static_cast<int>(shown.header.columns.size()));
    for (int row = 0; row < m_columns->rowCount(); ++row) {
        const auto place = static_cast<std::size_t>(row);
        const std::string& name = shown.header.columns[place];
        m_columns->setItem(row, NameColumn, new QTableWidgetItem(toText(name)));
        m_columns->setItem(row, ExamplesColumn, new QTableWidgetItem(shown.examples[place].join(QStringLiteral(" · "))));
        auto* meaning = new QComboBox;
        meaning->setObjectName(QStringLiteral("yearsMeaning%1").arg(row));
        meaning->setAccessibleName(tr("What the column %1 is").arg(toText(name)));
        const auto heading = headingOfColumn(name);
        meaning->addItem(heading ? tr("heading %1°").arg(numberText(*heading)) : tr("nothing known: kept as a note"), QString());
        for (const auto& key : keys)
            meaning->addItem(keyWord(toText(key)), toText(key));
        meaning->setCurrentIndex(std::max(0, meaning->findData(toText(name))));
        connect(meaning, &QComboBox::activated, this, &YearsImportPage::mappingChanged);
        m_columns->setCellWidget(row, MeaningColumn, meaning);
    }
    m_columns->resizeColumnToContents(NameColumn);
}

YearsTable YearsImportPage::mapping() const
{
    YearsTable table;
    for (int row = 0; row < m_columns->rowCount(); ++row) {
        const auto* meaning = qobject_cast<QComboBox*>(m_columns->cellWidget(row, MeaningColumn));
        if (const std::string key = meaning->currentData().toString().toStdString(); !key.empty())
            table.columns[key] = m_header.columns[static_cast<std::size_t>(row)];
    }
    const auto common = [&table](const char* key, const QString& value) {
        if (!value.trimmed().isEmpty())
            table.common[key] = value.trimmed().toStdString();
    };
    common("type", m_type->text());
    common("compass", m_compass->text());
    if (m_stage->currentIndex() > 0)
        common("stage", toText(std::string(fileWord(static_cast<SwingStage>(m_stage->currentIndex() - 1)))));
    common("kind", m_kind->currentData().toString());
    if (m_cells->isEnabled() && m_cells->currentIndex() > 0)
        table.cells = static_cast<YearsCells>(m_cells->currentIndex() - 1);
    table.byCompass = m_by->currentIndex() == 1;
    table.dates = static_cast<DateOrder>(m_dates->currentIndex());
    return table;
}

void YearsImportPage::mappingChanged()
{
    if (m_path.isEmpty())
        return;
    m_worker.cancel();
    m_looked = false;
    m_findings->clear();
    bool headings = false;
    for (int row = 0; row < m_columns->rowCount(); ++row)
        headings |= qobject_cast<QComboBox*>(m_columns->cellWidget(row, MeaningColumn))->currentIndex() == 0
            && headingOfColumn(m_header.columns[static_cast<std::size_t>(row)]).has_value();
    m_cells->setEnabled(headings);
    m_by->setEnabled(headings);
    glance();
}

void YearsImportPage::glance()
{
    const auto swings = firstSwings(m_path, mapping(), kFirstSwings);
    m_swings->setRowCount(swings ? static_cast<int>(swings->size()) : 0);
    if (!swings) {
        m_state->setText(messageOf(swings.error()));
        enable();
        return;
    }
    for (int row = 0; row < m_swings->rowCount(); ++row) {
        const auto& one = (*swings)[static_cast<std::size_t>(row)];
        QStringList cells{
            QString::number(one.line), one.type, one.aircraft, one.compass, one.date, one.stage, QString::number(one.readings)};
        for (const auto& coefficient : one.coefficient_deg)
            cells += coefficient ? signedNumber(*coefficient, 2) : QStringLiteral("–");
        cells += QString::number(one.maxAbs_deg, 'f', 1);
        for (int column = 0; column < cells.size(); ++column)
            m_swings->setItem(row, column, new QTableWidgetItem(cells[column]));
    }
    m_swings->resizeColumnsToContents();
    look();
}

void YearsImportPage::look()
{
    start(Doing::Looking, tr("The whole table is read; nothing is stored yet…"),
        [&stores = m_stores, path = m_path, table = mapping()](
            const Progress& progress) { return yearsWork(stores, path, table, db::YearsStep::Look, progress); });
}

void YearsImportPage::store()
{
    start(Doing::Storing, tr("The swings are stored…"), [&stores = m_stores, path = m_path, table = mapping()](const Progress& progress) {
        return yearsWork(stores, path, table, db::YearsStep::Store, progress);
    });
}

void YearsImportPage::undo()
{
    if (!m_made)
        return;
    start(Doing::Undoing, tr("The import is undone…"), [&stores = m_stores, made = *m_made](const Progress&) -> Result<db::YearsOutcome> {
        auto own = stores.openForWorker();
        if (!own)
            return own.error();
        const auto taken = db::undoYears((*own)->database(), made);
        if (!taken)
            return taken.error();
        db::YearsOutcome outcome;
        outcome.swings = *taken;
        return outcome;
    });
}

void YearsImportPage::start(Doing doing, const QString& what, Worker<db::YearsOutcome>::Work work)
{
    m_doing = doing;
    m_state->setText(what);
    m_progress->setValue(0);
    m_worker.start(std::move(work));
    enable();
}

void YearsImportPage::take(Result<db::YearsOutcome> outcome)
{
    const Doing was = std::exchange(m_doing, Doing::Nothing);
    m_progress->reset();
    if (!outcome) {
        m_state->setText(outcome.error().code == ErrorCode::Cancelled ? tr("Cancelled: nothing was changed.") : messageOf(outcome.error()));
    } else if (was == Doing::Undoing) {
        m_made.reset();
        m_state->setText(tr("Undone: %1 swings were taken out.").arg(outcome->swings));
    } else {
        m_looked = was == Doing::Looking;
        tell(*outcome);
        if (was == Doing::Storing)
            m_made = outcome->made;
    }
    enable();
    if (outcome && was != Doing::Looking) {
        m_stores.changes().announceFleet();
        emit done(m_state->text());
    }
}

void YearsImportPage::tell(const db::YearsOutcome& outcome)
{
    m_findings->clear();
    for (const auto& suspicion : outcome.suspicions)
        m_findings->addItem(toText(suspicion));
    for (const auto& warning : outcome.warnings)
        m_findings->addItem(toText(warning));
    if (m_findings->count() == 0)
        m_findings->addItem(tr("No sign is suspect, and nothing else is to be told."));
    m_state->setText((m_looked
            ? tr("%1 swings with %2 readings; %3 aircraft and %4 compasses are new; %5 swings are there already. Nothing is stored yet.")
            : tr("Stored: %1 swings with %2 readings; %3 aircraft and %4 compasses are new; %5 swings were there already."))
                         .arg(outcome.swings)
                         .arg(outcome.readings)
                         .arg(outcome.aircraft)
                         .arg(outcome.compasses)
                         .arg(outcome.alreadyThere));
}

void YearsImportPage::enable()
{
    const bool idle = m_doing == Doing::Nothing;
    m_store->setEnabled(idle && m_looked && !m_stores.readOnly());
    m_undo->setEnabled(idle && m_made.has_value());
    m_cancel->setEnabled(!idle);
    m_cancel->setVisible(!idle);
    m_progress->setVisible(!idle);
    for (QWidget* part : std::initializer_list<QWidget*>{m_open, m_columns})
        part->setEnabled(m_doing != Doing::Storing && m_doing != Doing::Undoing);
}

} // namespace lubberline::ui
