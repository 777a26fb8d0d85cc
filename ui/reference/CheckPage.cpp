#include "ui/reference/CheckPage.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

#include <array>
#include <optional>

#include "core/angle/AngleText.h"
#include "core/check/History.h"
#include "core/earth/FieldModel.h"
#include "core/record/Completeness.h"
#include "db/stores/Stores.h"
#include "ui/kit/TableEntry.h"
#include "ui/kit/Words.h"
#include "ui/reference/ShareWords.h"
#include "ui/report/forms/ReferenceSheet.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

enum CheckColumn { kTurnTo, kDatum, kCompass, kFromCard };

} // namespace

CheckPage::CheckPage(db::Stores& stores, FileQuestions files, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_files(std::move(files))
    , m_history(new QLabel)
    , m_answer(new QLabel)
    , m_count(new QSpinBox)
    , m_tolerance(new QDoubleSpinBox)
    , m_error(new QDoubleSpinBox)
    , m_table(new QTableWidget)
    , m_store(new QPushButton(tr("&Store as a check swing")))
{
    setObjectName(QStringLiteral("checkPage"));
    m_belief = beliefOf({}, 0, {});
    build();
}

void CheckPage::build()
{
    setTitle(tr("Two-minute check"));
    m_history->setObjectName(QStringLiteral("checkHistory"));
    m_answer->setObjectName(QStringLiteral("checkAnswer"));
    for (QLabel* label : {m_history, m_answer}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    m_answer->setFont(large);
    m_count->setObjectName(QStringLiteral("checkCount"));
    m_count->setRange(1, 24);
    m_count->setValue(3);
    m_tolerance->setObjectName(QStringLiteral("checkTolerance"));
    m_tolerance->setRange(0.5, 30);
    m_tolerance->setValue(CheckOptions{}.tolerance_deg);
    m_tolerance->setSuffix(QStringLiteral("°"));
    m_error->setObjectName(QStringLiteral("checkError"));
    m_error->setRange(0.1, 10);
    m_error->setValue(CheckOptions{}.readingError_deg);
    m_error->setSuffix(QStringLiteral("°"));
    m_error->setToolTip(tr("Standard deviation of one deviation as it is read on the apron: datum and compass together"));
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
    form->addRow(tr("&Headings to read:"), m_count);
    form->addRow(tr("The card &holds within:"), m_tolerance);
    form->addRow(tr("&Error of a reading:"), m_error);
    m_table->setObjectName(QStringLiteral("checkTable"));
    m_table->setColumnCount(4);
    m_table->setHorizontalHeaderLabels(
        {tr("turn to, by compass"), tr("datum, magnetic (°)"), tr("compass reads (°)"), tr("from its card (°)")});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_store->setObjectName(QStringLiteral("checkStore"));
    body().addWidget(m_history);
    body().addLayout(form);
    body().addWidget(m_table, 1);
    body().addWidget(m_answer);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(m_store);
    body().addLayout(row);
    connect(m_count, &QSpinBox::valueChanged, this, &CheckPage::choose);
    connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, &CheckPage::choose);
    connect(m_error, &QDoubleSpinBox::valueChanged, this, &CheckPage::choose);
    new EnterAdvances(*m_table, EnterAdvances::Order::AlongRows);
    connect(m_table, &QTableWidget::cellChanged, this, &CheckPage::judge);
    connect(m_store, &QPushButton::clicked, this, &CheckPage::store);
    setFocusProxy(m_table);
}

Result<void> CheckPage::open(const FleetItem& record)
{
    CompassId id;
    if (const auto* compass = std::get_if<CompassId>(&record))
        id = *compass;
    if (const auto* swing = std::get_if<SwingId>(&record)) {
        const auto of = m_stores.swings.swing(*swing);
        if (!of)
            return of.error();
        id = of->compass;
    }
    auto compass = m_stores.fleet.compass(id);
    if (!compass)
        return compass.error();
    auto aircraft = m_stores.fleet.aircraft(compass->aircraft);
    if (!aircraft)
        return aircraft.error();
    const auto rows = m_stores.swings.swingsOf(id);
    if (!rows)
        return rows.error();
    std::vector<SwingRecord> records;
    for (const SwingRow& row : *rows)
        if (!row.superseded) {
            auto swing = m_stores.swings.record(row.id);
            if (!swing)
                return swing.error();
            records.push_back(std::move(swing.value()));
        }
    m_compass = std::move(*compass);
    m_aircraft = std::move(*aircraft);
    m_limit_deg.reset();
    if (!records.empty() && records.front().limits)
        m_limit_deg = records.front().limits->maxDeviation_deg;
    const auto history = historyOf(records);
    m_swings = history.size();
    m_belief = beliefOf(history, yearOf(m_stores.clock().today()), plausibleFor(m_compass.kind));
    setTitle(tr("Two-minute check: %1 · %2").arg(toText(m_aircraft.registration), toText(m_compass.name)));
    choose();
    return {};
}

bool CheckPage::isOf(const FleetItem& record) const { return record == FleetItem(m_compass.id); }

Shown CheckPage::shown() const { return {m_compass.aircraft, m_compass.id}; }

CheckOptions CheckPage::options() const
{
    CheckOptions options;
    options.tolerance_deg = m_tolerance->value();
    options.readingError_deg = m_error->value();
    options.limit_deg = m_limit_deg;
    return options;
}

QString CheckPage::historyWords() const
{
    if (!m_belief.hasHistory)
        return tr("No swing on record: the check cannot know this compass's card.");
    QStringList walks;
    for (const Coefficient c : kCoefficients)
        walks.append(QStringLiteral("%1 %2°").arg(QChar(letterOf(c))).arg(m_belief.walk_deg_year[indexOf(c)], 0, 'f', 1));
    return tr(
        "%n swing(s) on record, the last %1 years ago. It wanders in a year by %2; since then something may have happened to it with %3 %.",
        nullptr, static_cast<int>(m_swings))
        .arg(m_belief.yearsSince, 0, 'f', 1)
        .arg(walks.join(QStringLiteral(", ")))
        .arg(shareWords(m_belief.jumpProbability));
}

/// The readings that were typed stay, row by row.
void CheckPage::choose()
{
    const ChosenHeadings chosen = headingsFor(m_belief, m_count->value(), options());
    m_history->setText(inAngleStyle(historyWords() + QLatin1Char('\n')
        + tr("These headings leave %1° of what would matter unknown; as many evenly spaced ones %2°.")
              .arg(plainNumber(chosen.left_deg, 1), plainNumber(chosen.leftEven_deg, 1))));
    m_showing = true;
    m_table->setRowCount(static_cast<int>(chosen.compass_deg.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        m_table->setItem(
            row, kTurnTo, fixedCell(QStringLiteral("%1°").arg(chosen.compass_deg[static_cast<std::size_t>(row)], 3, 'f', 0, QChar('0'))));
        for (const int column : {kDatum, kCompass})
            if (!m_table->item(row, column))
                m_table->setItem(row, column, new QTableWidgetItem);
        m_table->setItem(row, kFromCard, fixedCell({}));
    }
    if (m_table->currentColumn() < kDatum)
        m_table->setCurrentCell(0, kDatum); // what is typed first has a place
    m_showing = false;
    judge();
}

std::vector<Observation> CheckPage::readings()
{
    std::vector<Observation> read;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const QString datum = m_table->item(row, kDatum)->text().trimmed(), compass = m_table->item(row, kCompass)->text().trimmed();
        m_table->item(row, kFromCard)->setText({});
        if (datum.isEmpty() || compass.isEmpty())
            continue;
        const auto magnetic_deg = parseHeading_deg(datum.toStdString(), North::Magnetic);
        const auto compass_deg = parseHeading_deg(compass.toStdString(), North::Compass);
        for (const auto* heading : {&magnetic_deg, &compass_deg})
            if (!*heading) {
                refuse(messageOf(heading->error()));
                return {};
            }
        read.push_back({MagneticHeading::fromDegrees(*magnetic_deg), CompassHeading::fromDegrees(*compass_deg)});
        m_table->item(row, kFromCard)
            ->setText(shownFigure(wrap180(deviationOf(read.back().magnetic, read.back().compass).degrees()
                                      - deviationAt(m_belief.card, read.back().compass).degrees()),
                1));
    }
    return read;
}

void CheckPage::judge()
{
    if (m_showing)
        return;
    m_showing = true;
    say({});
    m_read = readings();
    m_showing = false;
    m_verdict.reset();
    if (m_read.empty()) {
        m_answer->setText(tr("Turn to each heading, and type what datum and compass read there."));
    } else if (auto verdict = verdictOf(m_belief, m_read, options())) {
        m_verdict = std::move(*verdict);
        const QString words = toText(inWords(*m_verdict, options()));
        m_answer->setText(inAngleStyle(words.left(1).toUpper() + words.mid(1) + QLatin1Char('.')));
        QStringList warnings;
        for (const Message& warning : m_verdict->warnings)
            warnings.append(toText(warning));
        say(warnings.join(QLatin1Char('\n')));
    }
    m_store->setEnabled(m_verdict && m_read.size() >= 2 && m_compass.id.valid());
}

/// A check swing with its verdict: completed and signed as any other.
void CheckPage::store()
{
    Swing swing;
    swing.compass = m_compass.id;
    swing.date = m_stores.clock().today();
    swing.kind = SwingKind::Check;
    swing.stage = SwingStage::AsFound;
    swing.procedure = kCheckProcedure;
    swing.note = inWords(*m_verdict, options()).english();
    for (const Observation& read : m_read) {
        Reading reading;
        reading.magnetic = read.magnetic;
        reading.compass = read.compass;
        swing.readings.push_back(std::move(reading));
    }
    emit makeSwing(swing);
}

/// A heading that nobody has read yet stays blank, to be filled in by hand.
QStringList CheckPage::printedRow(int row) const
{
    QStringList cells{m_table->item(row, kTurnTo)->text().remove(QStringLiteral("°"))};
    std::array<std::optional<double>, 2> read_deg;
    for (const int column : {kDatum, kCompass}) {
        const auto heading
            = parseHeading_deg(m_table->item(row, column)->text().toStdString(), column == kDatum ? North::Magnetic : North::Compass);
        if (heading)
            read_deg[static_cast<std::size_t>(column - kDatum)] = *heading;
        cells.append(heading ? toText(formatHeading(*heading, AngleStyle::DecimalDegrees, 1)).remove(QStringLiteral("°")) : QString());
    }
    QString off;
    if (read_deg[0] && read_deg[1])
        off = signedNumber(
            wrap180(*read_deg[0] - *read_deg[1] - deviationAt(m_belief.card, CompassHeading::fromDegrees(*read_deg[1])).degrees()), 1);
    return cells << off;
}

void CheckPage::writeReport()
{
    const QString path = m_files.save(tr("Report"), tr("%1 check.pdf").arg(toText(m_aircraft.registration)), tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    ReferenceSheet sheet;
    sheet.title = tr("Two-minute check of a compass");
    sheet.subject
        = QStringLiteral("%1 · %2 · %3").arg(toText(m_aircraft.registration), toText(m_compass.name), toText(m_stores.clock().today()));
    sheet.text = m_history->text().split(QLatin1Char('\n'));
    sheet.text << m_answer->text() << message().split(QLatin1Char('\n'));
    sheet.table = {tr("Readings"),
        {{tr("Turn to"), tr("by compass"), QStringLiteral("°")}, {tr("Datum"), tr("magnetic"), QStringLiteral("°")},
            {tr("Compass"), tr("heading"), QStringLiteral("°")}, {tr("From card"), {}, QStringLiteral("°")}},
        {}};
    for (int row = 0; row < m_table->rowCount(); ++row)
        sheet.table.rows.push_back({printedRow(row)});
    sheet.signatures = true;
    sheet.madeAtUtc = toText(m_stores.clock().nowUtc());
    m_files.write({path, [sheet, path](const Progress& progress) { return writeReferenceSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
