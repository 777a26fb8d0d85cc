#include "ui/calibration/CalibrationPage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/calibration/CalibrationPictures.h"
#include "ui/kit/CompassTitle.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/plots/calibration/ErrorMapDrawing.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/plots/series/SeriesPlot.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kMostFormWidth = 380;
const QString kColumnsKey = QStringLiteral("calibration/columns");

Result<std::optional<double>> typed(const QLineEdit& line, const QString& what, double least, double most)
{
    if (line.text().trimmed().isEmpty())
        return std::optional<double>();
    const auto value = typedNumber(line.text());
    if (!value || *value < least || *value > most)
        return Error{ErrorCode::InvalidInput,
            said(CalibrationPage::tr("'%1' is not allowed for %2; expected %3 to %4").arg(line.text(), what).arg(least).arg(most))};
    return value;
}

QLineEdit* lineNamed(const char* name, const QString& hint)
{
    auto* line = new QLineEdit;
    line->setObjectName(QString::fromLatin1(name));
    line->setPlaceholderText(hint);
    return line;
}

} // namespace

CalibrationPage::CalibrationPage(db::Stores& stores, QSettings& settings, FileQuestions questions, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_settings(settings)
    , m_questions(std::move(questions))
    , m_file(new QLabel)
    , m_words(new QLabel)
    , m_unit(new QComboBox)
    , m_method(new QComboBox)
    , m_field(lineNamed("calibrationField", tr("empty: not known")))
    , m_dip(lineNamed("calibrationDip", tr("empty: not known; down +")))
    , m_attitudeError(lineNamed("calibrationAttitudeError", tr("standard deviation; empty: exact")))
    , m_onlySeen(new QCheckBox(tr("Only the part of the log that is zoomed in")))
    , m_open(new QPushButton(tr("&Open a log…")))
    , m_calibrate(new QPushButton(tr("&Calibrate")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_save(new QPushButton(tr("&Save the model…")))
    , m_store(new QPushButton(tr("Store with the c&ompass")))
    , m_tabs(new QTabWidget)
    , m_logPlot(new SeriesPlot(tr("Log")))
    , m_beforeAfter(new SeriesPlot(tr("Before and after")))
    , m_map(new DrawnPlot(tr("Deviation map"), {240, 200}))
    , m_sphere(new CoverageSphere)
    , m_worker([this](Result<CalibrationRun> run) { take(std::move(run)); })
{
    build();
}

QWidget* CalibrationPage::buildForm()
{
    auto* form = new QFormLayout;
    const std::array<std::pair<const char*, QString>, 7> columns{
        {{"bx", tr("Column x (forward):")}, {"by", tr("Column y (right):")}, {"bz", tr("Column z (down):")}, {"time", tr("Time:")},
            {"heading", tr("Magnetic heading:")}, {"pitch", tr("Pitch (nose up +):")}, {"roll", tr("Roll (right wing down +):")}}};
    for (const auto& [key, title] : columns) {
        auto* box = new QComboBox;
        box->setObjectName(QStringLiteral("calibrationColumn_") + QString::fromLatin1(key));
        m_columns.emplace_back(key, box);
        form->addRow(title, box);
        connect(box, &QComboBox::activated, this, [this] { start(true); });
    }
    m_unit->setObjectName(QStringLiteral("calibrationUnit"));
    m_unit->addItems(
        {tr("as recognised"), QStringLiteral("nT"), QStringLiteral("µT"), QStringLiteral("mG"), QStringLiteral("G"), tr("counts")});
    m_method->setObjectName(QStringLiteral("calibrationMethod"));
    m_method->addItems({tr("ellipsoid (the field's size, 10 parameters)"), tr("axes (7 parameters)"), tr("sphere (4 parameters)"),
        tr("against heading, pitch and roll")});
    m_onlySeen->setObjectName(QStringLiteral("calibrationOnlySeen"));
    form->addRow(tr("&Unit:"), m_unit);
    form->addRow(tr("&Method:"), m_method);
    form->addRow(tr("Earth's &field (nT):"), m_field);
    form->addRow(tr("Its &dip (°):"), m_dip);
    form->addRow(tr("&Attitude sure to (°):"), m_attitudeError);
    form->addRow(m_onlySeen);
    connect(m_unit, &QComboBox::activated, this, [this] { start(true); });
    connect(m_method, &QComboBox::activated, this, [this] { start(false); });
    for (QLineEdit* line : {m_field, m_dip, m_attitudeError})
        connect(line, &QLineEdit::returnPressed, this, [this] { start(false); });
    auto* box = new QWidget;
    box->setLayout(form);
    form->setContentsMargins(0, 0, 0, 0);
    return box;
}

void CalibrationPage::build()
{
    m_file->setWordWrap(true);
    m_file->setText(
        tr("A log of a magnetometer (CSV). Turn it slowly through all attitudes: each side up once, with a full turn in each."));
    m_words->setObjectName(QStringLiteral("calibrationWords"));
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::RichText);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_open->setObjectName(QStringLiteral("calibrationOpen"));
    m_calibrate->setObjectName(QStringLiteral("calibrationStart"));
    m_cancel->setObjectName(QStringLiteral("calibrationCancel"));
    m_save->setObjectName(QStringLiteral("calibrationSave"));
    m_calibrate->setEnabled(false);
    m_save->setEnabled(false);
    m_store->setObjectName(QStringLiteral("calibrationStore"));
    m_store->setToolTip(
        tr("Among the sensor models of the compass from whose page this one was opened: maps and predictions take it from there"));
    m_store->setEnabled(false);
    m_cancel->hide();
    auto* buttons = new QGridLayout; // two rows: the plots keep their room on a small screen
    buttons->addWidget(m_open, 0, 0);
    buttons->addWidget(m_calibrate, 0, 1);
    buttons->addWidget(m_cancel, 0, 2);
    buttons->addWidget(m_save, 1, 0);
    buttons->addWidget(m_store, 1, 1);
    buttons->setColumnStretch(2, 1);
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->addLayout(buttons);
    column->addWidget(m_file);
    column->addWidget(m_words); // the verdict above the choices: on a small screen it would stand out of sight beneath them
    column->addWidget(buildForm());
    column->addStretch();
    m_tabs->addTab(m_logPlot, m_logPlot->name());
    m_tabs->addTab(m_sphere, tr("Directions"));
    m_tabs->addTab(m_beforeAfter, m_beforeAfter->name());
    m_tabs->addTab(m_map, m_map->name());
    auto* splitter = new SideBySide;
    splitter->addWidget(new SidePanel(left)); // there can be much to say
    splitter->addWidget(m_tabs);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({kMostFormWidth, 2 * kMostFormWidth});
    body().addWidget(splitter, 1);
    setFocusProxy(m_open);
    m_logPlot->setPicture({tr("time (s)"), {}, {}, {}, {}, tr("Open a log: it is drawn here. Drag to zoom.")});
    m_beforeAfter->setPicture({{}, {}, {}, {}, {}, tr("Nothing is calibrated yet.")});
    connect(m_open, &QPushButton::clicked, this, &CalibrationPage::choose);
    connect(m_calibrate, &QPushButton::clicked, this, [this] { start(false); });
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
    connect(m_save, &QPushButton::clicked, this, &CalibrationPage::save);
    connect(m_store, &QPushButton::clicked, this, &CalibrationPage::store);
    m_map->setPicture(errorMapDrawing({}));
    for (Plot* plot : std::initializer_list<Plot*>{m_logPlot, m_beforeAfter, m_map})
        follow(*plot);
}

Result<void> CalibrationPage::open(const FleetItem& record)
{
    const CompassId compass = compassIn(record);
    const auto title = titleWith(m_stores, compass, tr("Calibration of a magnetometer from its log"));
    if (!title)
        return title.error();
    m_compass = compass;
    setTitle(*title);
    m_store->setEnabled(m_run && m_run->model && m_compass.valid() && m_run->part->unit != FieldUnit::Counts);
    return {};
}

bool CalibrationPage::isOf(const FleetItem& record) const { return !m_compass.valid() || m_compass == compassIn(record); }

Plot* CalibrationPage::plot() const { return dynamic_cast<Plot*>(m_tabs->currentWidget()); }

void CalibrationPage::choose()
{
    const QString path = m_questions.open(tr("Open a sensor log"), tr("Sensor logs (*.csv *.txt *.tsv *.dat);;All files (*)"));
    if (!path.isEmpty())
        openLog(path);
}

void CalibrationPage::openLog(const QString& path)
{
    const auto header = readSensorLogHeaderFile(path.toStdString());
    if (!header) {
        emit failed(messageOf(header.error()));
        return;
    }
    m_path = path;
    m_log.reset();
    m_run.reset();
    m_save->setEnabled(false);
    m_onlySeen->setChecked(false);
    m_unit->setCurrentIndex(0);
    m_file->setText(QFileInfo(path).fileName());
    offerColumns(*header);
    m_calibrate->setEnabled(true);
    start(true);
}

/// What is recognised, else what was chosen for a column of that name before.
void CalibrationPage::offerColumns(const SensorLogHeader& header)
{
    const QVariantMap remembered = m_settings.value(kColumnsKey).toMap();
    for (const auto& [key, box] : m_columns) {
        box->clear();
        box->addItem(tr("(none)"));
        for (const auto& name : header.columns)
            box->addItem(toText(name));
        const auto found = header.recognised.find(key);
        const QString before = remembered.value(toText(key)).toString();
        int index = found == header.recognised.end() ? 0 : box->findText(toText(found->second));
        if (index <= 0 && !before.isEmpty())
            index = std::max(0, box->findText(before));
        box->setCurrentIndex(std::max(0, index));
    }
}

void CalibrationPage::rememberColumns()
{
    QVariantMap remembered = m_settings.value(kColumnsKey).toMap();
    for (const auto& [key, box] : m_columns)
        if (box->currentIndex() > 0)
            remembered.insert(toText(key), box->currentText());
    m_settings.setValue(kColumnsKey, remembered);
}

Result<CalibrationWish> CalibrationPage::wish() const
{
    CalibrationWish wish;
    wish.path = m_path.toStdString();
    for (const auto& [key, box] : m_columns)
        if (box->currentIndex() > 0)
            wish.reading.columns.emplace(key, box->currentText().toStdString());
    if (m_unit->currentIndex() > 0)
        wish.reading.unit = static_cast<FieldUnit>(m_unit->currentIndex() - 1);
    wish.method = static_cast<CalibrationMethod>(m_method->currentIndex());
    const auto field = typed(*m_field, tr("the Earth's field"), 1000, 200000);
    const auto dip = typed(*m_dip, tr("the dip"), -90, 90);
    const auto error = typed(*m_attitudeError, tr("how sure the attitude is"), 0, 15);
    if (!field || !dip || !error)
        return !field ? field.error() : !dip ? dip.error() : error.error();
    wish.field_nT = *field;
    wish.dip_deg = *dip;
    wish.attitudeError_deg = error->value_or(0.0);
    if (m_onlySeen->isChecked())
        if (const auto seen = m_logPlot->seen(); seen.part)
            wish.part = {seen.from, seen.to};
    return wish;
}

void CalibrationPage::start(bool readAgain)
{
    if (m_path.isEmpty() || m_worker.running())
        return;
    auto chosen = wish();
    if (!chosen) {
        emit failed(messageOf(chosen.error()));
        return;
    }
    if (!readAgain)
        chosen->read = m_log;
    m_cancel->show();
    m_open->setEnabled(false);
    m_calibrate->setEnabled(false);
    m_save->setEnabled(false);
    m_words->setText(tr("Working…"));
    m_worker.start([chosen = std::move(chosen.value())](const Progress& progress) { return runCalibration(chosen, progress); });
}

void CalibrationPage::take(Result<CalibrationRun> run)
{
    m_cancel->hide();
    m_open->setEnabled(true);
    m_calibrate->setEnabled(true);
    if (!run) {
        m_run.reset();
        m_words->setText(messageOf(run.error()).toHtmlEscaped());
        if (run.error().code != ErrorCode::Cancelled)
            emit failed(messageOf(run.error()));
        return;
    }
    rememberColumns();
    m_run = std::make_shared<const CalibrationRun>(std::move(run.value()));
    showRun();
}

void CalibrationPage::showRun()
{
    m_words->setText(inAngleStyle(wordsOf(*m_run)));
    m_save->setEnabled(m_run->model.has_value());
    m_store->setEnabled(m_run->model && m_compass.valid() && m_run->part->unit != FieldUnit::Counts);
    if (m_log != m_run->log) {
        m_log = m_run->log;
        m_logPlot->setPicture(logPicture(m_log));
    }
    const Coverage none;
    const Coverage& coverage = m_run->ellipsoid && m_run->ellipsoid->fit ? m_run->ellipsoid->fit->coverage
        : m_run->attitude                                                ? m_run->attitude->coverage
                                                                         : none;
    m_sphere->setDots(sphereDots(*m_run), coverage.gap, coverage.largestGap_deg > 15 ? coverage.largestGap_deg : 0.0);
    m_beforeAfter->setPicture(beforeAfterPicture(*m_run));
    m_map->setPicture(errorMapDrawing(m_run->compensated ? m_run->compensated->map : std::vector<ErrorCell>()));
}

} // namespace lubberline::ui
