#include "ui/guided/GuidedReview.h"

#include <QComboBox>
#include <QHeaderView>
#include <QShortcut>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "core/swing/Card.h"
#include "ui/guided/BigWidgets.h"
#include "ui/guided/GuidedWords.h"
#include "ui/kit/Words.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

enum ReviewColumn { For, Datum, Compass, DeviationRead, Residual, Steer, Where };

QTableWidgetItem* cell(const QString& text)
{
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
    item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return item;
}

/// Why the readings make no card: STEER does not rise with FOR. Empty: it does.
QString foldWords(const GuidedJob& job)
{
    for (int configuration = 0; configuration <= static_cast<int>(job.job().plan.configurations.size()); ++configuration) {
        std::vector<CardRow> rows;
        for (const auto& row : residualsOf(job.state(), configuration)) {
            CardRow made;
            made.magnetic = MagneticHeading::fromDegrees(row.nominal_deg);
            made.steer = CompassHeading::fromDegrees(row.steer_deg);
            rows.push_back(made);
        }
        std::sort(rows.begin(), rows.end(), [](const CardRow& a, const CardRow& b) { return a.magnetic.degrees() < b.magnetic.degrees(); });
        if (const auto rising = checkRising(rows, CardBy::Magnetic); rows.size() > 2 && !rising)
            return toText(rising.error().message);
    }
    return {};
}

} // namespace

GuidedReview::GuidedReview(GuidedJob& job, QWidget* parent)
    : QWidget(parent)
    , m_job(job)
    , m_table(new QTableWidget(0, 7))
    , m_verdict(bigLabel("reviewVerdict", kSentence_px, true))
    , m_notes(bigLabel("reviewNotes", kTitle_px))
    , m_by(new QLineEdit)
    , m_accept(bigButton(tr("Accept and make the record"), "acceptSwing"))
    , m_again(new QPushButton(tr("Read this one again (F2)")))
    , m_control(new QComboBox)
    , m_after(new QLineEdit)
    , m_turn(new QPushButton(tr("A control was turned again")))
{
    build();
}

void GuidedReview::build()
{
    m_table->setObjectName(QStringLiteral("residuals"));
    m_table->setHorizontalHeaderLabels(
        {tr("for"), tr("magnetic"), tr("compass"), tr("deviation"), tr("residual"), tr("steer"), tr("with")});
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setFont(bigFont(font(), 17));
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_by->setObjectName(QStringLiteral("acceptedBy"));
    m_by->setPlaceholderText(tr("who accepts the swing"));
    m_by->setFont(bigFont(m_by->font(), kTitle_px));
    m_again->setObjectName(QStringLiteral("reviewAgain"));
    m_turn->setObjectName(QStringLiteral("turnedAgain"));
    for (QPushButton* button : {m_again, m_turn}) {
        button->setAutoDefault(true);
        button->setMinimumHeight(36);
    }
    m_control->setObjectName(QStringLiteral("turnedControl"));
    for (const Control control : {Control::NorthSouth, Control::EastWest, Control::Index})
        m_control->addItem(wordFor(control));
    m_after->setObjectName(QStringLiteral("turnedAfter"));
    m_after->setPlaceholderText(tr("the compass now reads"));
    m_after->setMaximumWidth(180);
    auto* actions = new QHBoxLayout;
    actions->addWidget(m_by, 1);
    actions->addWidget(m_accept);
    auto* mending = new QHBoxLayout;
    mending->addWidget(m_control);
    mending->addWidget(m_after);
    mending->addWidget(m_turn);
    mending->addStretch();
    m_turn->setToolTip(
        tr("On the heading of the row that is chosen, where the aircraft stands now. Every reading of the check swing is void then."));
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_verdict);
    column->addWidget(m_notes);
    column->addWidget(m_table, 1);
    column->addWidget(m_again, 0, Qt::AlignLeft);
    column->addLayout(actions);
    column->addLayout(mending);
    connect(m_accept, &QPushButton::clicked, this, &GuidedReview::accept);
    connect(m_by, &QLineEdit::returnPressed, this, &GuidedReview::accept);
    connect(m_again, &QPushButton::clicked, this, &GuidedReview::readAgain);
    auto* again = new QShortcut(QKeySequence(Qt::Key_F2), this);
    again->setContext(Qt::WidgetWithChildrenShortcut);
    connect(again, &QShortcut::activated, this, &GuidedReview::readAgain);
    connect(m_turn, &QPushButton::clicked, this, &GuidedReview::turnAgain);
}

void GuidedReview::refresh()
{
    fillTable();
    m_verdict->setText(inAngleStyle(verdict()));
    const auto& state = m_job.state();
    QStringList notes;
    if (state.indexRemoved_deg)
        notes
            += tr("A = %1° was taken out by turning the compass; residual = deviation − A.").arg(signedNumber(*state.indexRemoved_deg, 1));
    if (!state.indexLeft.empty() && state.index_deg)
        notes += tr("A = %1° was left in: %2.").arg(signedNumber(*state.index_deg, 1), toText(state.indexLeft));
    if (const QString skipped = skipWords(state); !skipped.isEmpty())
        notes += skipped;
    for (const auto& note : state.notes)
        notes += toText(note);
    if (const Message doubt = m_job.clockDoubt(); !doubt.empty())
        notes += toText(doubt);
    m_notes->setText(inAngleStyle(notes.join('\n')));
    m_notes->setVisible(!notes.isEmpty());
    const bool accepted = state.phase == JobPhase::Card;
    m_accept->setText(accepted ? tr("Make the record") : tr("Accept and make the record"));
    m_by->setVisible(!accepted);
}

/// Row by row in the order of the stations of the check swing and of the further configurations.
void GuidedReview::fillTable()
{
    const auto& state = m_job.state();
    m_table->clearSpans();
    m_table->setRowCount(0);
    m_stations.clear();
    const int configurations = static_cast<int>(m_job.job().plan.configurations.size());
    for (int configuration = 0; configuration <= configurations; ++configuration) {
        addSkipped(configuration);
        const auto rows = residualsOf(state, configuration);
        for (const auto& row : rows) {
            const auto station = std::find_if(state.stations.begin(), state.stations.end(), [&](const StationState& one) {
                return one.reading && one.station.configuration == configuration && one.station.nominal_deg == row.nominal_deg
                    && (one.station.phase == StationPhase::Check || one.station.phase == StationPhase::Configuration);
            });
            const int at = m_table->rowCount();
            m_table->insertRow(at);
            m_stations.push_back(static_cast<int>(station - state.stations.begin()));
            m_table->setItem(at, For, cell(stationHeading(row.nominal_deg)));
            m_table->setItem(at, Datum, cell(figureText(station->reading->magnetic.degrees())));
            m_table->setItem(at, Compass, cell(figureText(station->reading->compass.degrees())));
            m_table->setItem(at, DeviationRead, cell(signedNumber(row.deviation_deg, 1)));
            m_table->setItem(at, Residual, cell(signedNumber(row.residual_deg, 1)));
            m_table->setItem(at, Steer, cell(figureText(std::fmod(std::round(row.steer_deg), 360.0))));
            m_table->setItem(at, Where,
                cell(
                    configuration == 0 ? QString() : toText(m_job.job().plan.configurations[static_cast<std::size_t>(configuration - 1)])));
        }
    }
    if (m_table->rowCount() > 0)
        m_table->selectRow(0);
}

/// What was skipped stands first, where it can still be read.
void GuidedReview::addSkipped(int configuration)
{
    const auto& stations = m_job.state().stations;
    for (std::size_t i = 0; i < stations.size(); ++i) {
        const StationState& one = stations[i];
        const bool wanted = one.station.phase == StationPhase::Check || one.station.phase == StationPhase::Configuration;
        if (!wanted || one.skipped.empty() || one.station.configuration != configuration)
            continue;
        const int at = m_table->rowCount();
        m_table->insertRow(at);
        m_stations.push_back(static_cast<int>(i));
        m_table->setItem(at, For, cell(stationHeading(one.station.nominal_deg)));
        m_table->setItem(at, Datum, cell(tr("skipped: %1").arg(toText(one.skipped))));
        m_table->item(at, Datum)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
        m_table->setSpan(at, Datum, 1, Where - Datum);
    }
}

QString GuidedReview::verdict() const
{
    double largest = 0, at = 0;
    for (int configuration = 0; configuration <= static_cast<int>(m_job.job().plan.configurations.size()); ++configuration)
        for (const auto& row : residualsOf(m_job.state(), configuration))
            if (std::abs(row.residual_deg) > std::abs(largest))
                largest = row.residual_deg, at = row.nominal_deg;
    const QString worst = tr("Largest residual %1° on %2").arg(signedNumber(largest, 1), stationHeading(at));
    if (const QString folds = foldWords(m_job); !folds.isEmpty())
        return QStringLiteral("%1. %2").arg(worst, folds);
    const auto& limits = m_job.record().limits;
    if (!limits || !limits->maxDeviation_deg)
        return worst + tr(". No limit is set for this compass.");
    const QString source
        = QStringLiteral("%1° (%2)")
              .arg(numberText(limits->maxDeviation_deg), toText(limits->document.empty() ? limits->name : limits->document));
    return std::abs(largest) <= *limits->maxDeviation_deg ? worst + tr(": within %1.").arg(source)
                                                          : worst + tr(": OUT OF LIMITS, %1 is allowed.").arg(source);
}

bool GuidedReview::tell(job::What what)
{
    const auto told = m_job.tell(std::move(what));
    if (!told)
        emit failed(messageOf(told.error()));
    return told.ok();
}

void GuidedReview::accept()
{
    if (m_job.state().phase == JobPhase::Card) {
        emit finish();
        return;
    }
    const std::string by = m_by->text().trimmed().toStdString();
    if (by.empty()) {
        emit failed(tr("Who accepts the swing? A name is expected."));
        m_by->setFocus();
        return;
    }
    if (tell(job::Accepted{by, {}}))
        emit finish();
}

void GuidedReview::readAgain()
{
    const int row = m_table->currentRow();
    if (row < 0)
        return;
    const int station = m_stations[static_cast<std::size_t>(row)];
    const bool skipped = !m_job.state().stations[static_cast<std::size_t>(station)].skipped.empty();
    tell(job::ReadingRejected{station, skipped ? "read after all" : "read again after the review"});
}

void GuidedReview::turnAgain()
{
    const int row = m_table->currentRow();
    const auto figures = parseFigures(m_after->text());
    if (row < 0 || !figures || figures->size() != 1) {
        emit failed(tr(
            "What does the compass read after the control was turned, on the heading of the row that is chosen? One figure is expected."));
        m_after->setFocus();
        return;
    }
    const int station = m_stations[static_cast<std::size_t>(row)];
    if (!m_job.state().stations[static_cast<std::size_t>(station)].reading) {
        emit failed(tr("A control is turned on a heading that was read; choose another row."));
        return;
    }
    const double before = m_job.state().stations[static_cast<std::size_t>(station)].reading->compass.degrees();
    if (tell(job::Adjusted{
            station, static_cast<Control>(m_control->currentIndex()), before, figures->front(), figures->front(), "after the check swing"}))
        m_after->clear();
}

void GuidedReview::focusField()
{
    if (m_job.state().phase == JobPhase::Card)
        m_accept->setFocus(Qt::OtherFocusReason);
    else
        m_by->setFocus(Qt::OtherFocusReason);
}

} // namespace lubberline::ui
