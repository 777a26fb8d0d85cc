#include "ui/reference/ComparePage.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "core/angle/PrintedHeading.h"
#include "core/check/History.h"
#include "core/earth/FieldModel.h"
#include "core/format/reference/PairCsv.h"
#include "db/stores/Stores.h"
#include "ui/kit/TableEntry.h"
#include "ui/kit/Words.h"
#include "ui/reference/ShareWords.h"
#include "ui/report/forms/ReferenceSheet.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kLeastPairRows = 8;

QTableWidget* pairTable()
{
    auto* table = new QTableWidget(kLeastPairRows, 3);
    table->setObjectName(QStringLiteral("compareTable"));
    table->setHorizontalHeaderLabels({ComparePage::tr("first reads (°)"), ComparePage::tr("second reads (°)"),
        ComparePage::tr("datum, magnetic (°), where there is one")});
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    return table;
}

} // namespace

ComparePage::ComparePage(db::Stores& stores, FileQuestions files, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_files(std::move(files))
    , m_firstBelief(beliefOf({}, 0, {}))
    , m_secondBelief(beliefOf({}, 0, {}))
    , m_second(new QComboBox)
    , m_table(pairTable())
    , m_answer(new QLabel)
    , m_figures(new QLabel)
    , m_due(new QPushButton(tr("Make a swing &due")))
{
    setObjectName(QStringLiteral("comparePage"));
    build();
}

void ComparePage::build()
{
    setTitle(tr("Two compasses compared"));
    m_second->setObjectName(QStringLiteral("compareSecond"));
    m_answer->setObjectName(QStringLiteral("compareAnswer"));
    m_figures->setObjectName(QStringLiteral("compareFigures"));
    for (QLabel* label : {m_answer, m_figures}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    m_answer->setFont(large);
    auto* load = new QPushButton(tr("&Read a file…"));
    load->setObjectName(QStringLiteral("compareLoad"));
    auto* title = new QLabel(tr("&Second compass:"));
    title->setBuddy(m_second);
    auto* row = new QHBoxLayout;
    row->addWidget(title);
    row->addWidget(m_second, 1);
    row->addWidget(load);
    body().addLayout(row);
    body().addWidget(m_table, 1);
    body().addWidget(m_answer);
    body().addWidget(m_figures);
    m_due->setObjectName(QStringLiteral("compareDue"));
    m_due->setToolTip(tr("Notes the finding among the events of the aircraft: the due list names it as a reason until a swing is signed"));
    m_due->setEnabled(false);
    auto* below = new QHBoxLayout;
    below->addStretch(1);
    below->addWidget(m_due);
    body().addLayout(below);
    connect(m_due, &QPushButton::clicked, this, &ComparePage::makeDue);
    connect(m_second, &QComboBox::activated, this, &ComparePage::chooseSecond);
    connect(load, &QPushButton::clicked, this, &ComparePage::load);
    new EnterAdvances(*m_table, EnterAdvances::Order::AlongRows);
    connect(m_table, &QTableWidget::cellChanged, this, &ComparePage::judge);
    setFocusProxy(m_table);
}

Result<CompassBelief> ComparePage::beliefOfCompass(const CompassSystem& compass)
{
    const auto rows = m_stores.swings.swingsOf(compass.id);
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
    return beliefOf(historyOf(records), yearOf(m_stores.clock().today()), plausibleFor(compass.kind));
}

Result<void> ComparePage::open(const FleetItem& record)
{
    const auto* id = std::get_if<CompassId>(&record);
    auto first = m_stores.fleet.compass(id ? *id : CompassId());
    if (!first)
        return first.error();
    auto aircraft = m_stores.fleet.aircraft(first->aircraft);
    if (!aircraft)
        return aircraft.error();
    const auto rows = m_stores.fleet.compassesOf(first->aircraft);
    if (!rows)
        return rows.error();
    auto belief = beliefOfCompass(*first);
    if (!belief)
        return belief.error();
    std::vector<CompassSystem> others;
    for (const CompassRow& row : *rows)
        if (row.id != first->id) {
            auto other = m_stores.fleet.compass(row.id);
            if (!other)
                return other.error();
            others.push_back(std::move(*other));
        }
    m_first = std::move(*first);
    m_aircraft = std::move(*aircraft);
    m_firstBelief = std::move(*belief);
    m_others = std::move(others);
    m_second->clear();
    for (const CompassSystem& other : m_others)
        m_second->addItem(toText(other.name));
    m_second->addItem(tr("one that is not on record"));
    setTitle(tr("Two compasses: %1 · first is %2").arg(toText(m_aircraft.registration), toText(m_first.name)));
    chooseSecond();
    return {};
}

bool ComparePage::isOf(const FleetItem& record) const { return record == FleetItem(m_first.id); }

Shown ComparePage::shown() const { return {m_first.aircraft, m_first.id}; }

void ComparePage::chooseSecond()
{
    const auto chosen = static_cast<std::size_t>(m_second->currentIndex());
    auto belief = chosen < m_others.size() ? beliefOfCompass(m_others[chosen]) : Result<CompassBelief>(beliefOf({}, 0, {}));
    if (!belief) {
        emit failed(messageOf(belief.error()));
        return;
    }
    m_secondBelief = std::move(*belief);
    judge();
}

void ComparePage::showPairs(const std::vector<PairReading>& pairs)
{
    m_showing = true;
    m_table->clearContents();
    m_table->setRowCount(std::max(kLeastPairRows, static_cast<int>(pairs.size()) + 1));
    for (int row = 0; row < static_cast<int>(pairs.size()); ++row) {
        const PairReading& pair = pairs[static_cast<std::size_t>(row)];
        m_table->setItem(row, 0, new QTableWidgetItem(plainNumber(printedHeading_deg(pair.first.degrees(), 1), 1)));
        m_table->setItem(row, 1, new QTableWidgetItem(plainNumber(printedHeading_deg(pair.second.degrees(), 1), 1)));
        m_table->setItem(
            row, 2, new QTableWidgetItem(pair.datum ? plainNumber(printedHeading_deg(pair.datum->degrees(), 1), 1) : QString()));
    }
    m_showing = false;
    judge();
}

void ComparePage::load()
{
    const QString path = m_files.open(tr("Two compasses read together"), tr("Tables (*.csv *.txt);;All files (*)"));
    if (path.isEmpty())
        return;
    const auto read = readPairCsvFile(path.toStdString());
    read ? showPairs(*read) : emit failed(messageOf(read.error()));
}

Result<std::vector<PairReading>> ComparePage::pairs() const
{
    std::vector<PairReading> pairs;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        std::array<std::optional<double>, 3> heading_deg;
        for (int column = 0; column < 3; ++column) {
            const QString text = m_table->item(row, column) ? m_table->item(row, column)->text().trimmed() : QString();
            if (text.isEmpty())
                continue;
            const auto heading = parseHeading_deg(text.toStdString(), column == 2 ? North::Magnetic : North::Compass);
            if (!heading)
                return heading.error();
            heading_deg[static_cast<std::size_t>(column)] = *heading;
        }
        if (!heading_deg[0] || !heading_deg[1])
            continue;
        PairReading pair{CompassHeading::fromDegrees(*heading_deg[0]), CompassHeading::fromDegrees(*heading_deg[1]), {}};
        if (heading_deg[2])
            pair.datum = MagneticHeading::fromDegrees(*heading_deg[2]);
        pairs.push_back(pair);
    }
    return pairs;
}

void ComparePage::judge()
{
    if (m_showing)
        return;
    m_verdict.reset();
    m_due->setEnabled(false);
    m_figures->clear();
    const auto typed = pairs();
    if (!typed) {
        refuse(messageOf(typed.error()));
        return;
    }
    say({});
    if (typed->empty()) {
        m_answer->setText(tr("Type what both compasses read on each heading, as on taxiing out; a runway's direction is a datum."));
        return;
    }
    auto verdict = compareCompasses(m_firstBelief, m_secondBelief, *typed, {});
    if (!verdict)
        return;
    m_verdict = std::move(*verdict);
    const QString words = toText(inWords(*m_verdict));
    m_answer->setText(inAngleStyle(words.left(1).toUpper() + words.mid(1) + QLatin1Char('.')));
    m_due->setEnabled(m_aircraft.id.valid() && !m_stores.readOnly()
        && !whySwing(*m_verdict, m_first.name, m_second->currentText().toStdString()).empty());
    QStringList coefficients, warnings;
    for (std::size_t c = 0; c < kCoefficientCount; ++c)
        coefficients.append(QStringLiteral("%1 %2° ± %3°")
                                .arg(QChar(letterOf(kCoefficients[c])))
                                .arg(signedNumber(m_verdict->difference_deg[c], 1), plainNumber(m_verdict->differenceError_deg[c], 1)));
    m_figures->setText(inAngleStyle(tr(
        "Headings corrected by their cards, first − second: %1 (standard errors; a deviation of the first that rose makes it fall). That a card does not hold: first %2 %, second %3 %.")
                                        .arg(coefficients.join(QStringLiteral(", ")), shareWords(m_verdict->firstFault),
                                            shareWords(m_verdict->secondFault))));
    for (const Message& warning : m_verdict->warnings)
        warnings.append(toText(warning));
    say(warnings.join(QLatin1Char('\n')));
}

void ComparePage::makeDue()
{
    Event event;
    event.aircraft = m_aircraft.id;
    event.date = m_stores.clock().today();
    event.cause = DueCause::AccuracySuspected;
    event.kind = whySwing(*m_verdict, m_first.name, m_second->currentText().toStdString()).english(); // stored: the same in every language
    m_due->setEnabled(false);                                                                         // once
    if (const auto stored = m_stores.fleet.add(event); !stored)
        emit failed(messageOf(stored.error()));
    else
        emit readOut(tr("Noted among the events of %1; the due list names it.").arg(toText(m_aircraft.registration)));
}

void ComparePage::writeReport()
{
    if (!m_verdict) {
        emit failed(tr("No heading was read by both compasses yet: there is nothing to report."));
        return;
    }
    const QString path = m_files.save(tr("Report"), tr("%1 two compasses.pdf").arg(toText(m_aircraft.registration)), tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    ReferenceSheet sheet;
    sheet.title = tr("Two compasses compared");
    sheet.subject
        = QStringLiteral("%1 · %2 · %3 · %4")
              .arg(toText(m_aircraft.registration), toText(m_first.name), m_second->currentText(), toText(m_stores.clock().today()));
    sheet.text << m_answer->text() << m_figures->text() << message().split(QLatin1Char('\n'));
    sheet.table = {tr("Readings"),
        {{tr("First"), {}, QStringLiteral("°")}, {tr("Second"), {}, QStringLiteral("°")},
            {tr("Datum"), tr("magnetic"), QStringLiteral("°")}},
        {}};
    if (const auto typed = pairs())
        for (const PairReading& pair : *typed)
            sheet.table.rows.push_back(
                {{plainNumber(printedHeading_deg(pair.first.degrees(), 1), 1), plainNumber(printedHeading_deg(pair.second.degrees(), 1), 1),
                    pair.datum ? plainNumber(printedHeading_deg(pair.datum->degrees(), 1), 1) : QString()}});
    sheet.madeAtUtc = toText(m_stores.clock().nowUtc());
    m_files.write({path, [sheet, path](const Progress& progress) { return writeReferenceSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
