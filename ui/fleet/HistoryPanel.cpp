#include "ui/fleet/HistoryPanel.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

#include "ui/fleet/PaintedPlot.h"
#include "ui/kit/Words.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kFilmStep_ms = 700;
constexpr int kMostChoices = 500;

} // namespace

HistoryPanel::HistoryPanel(QWidget* parent)
    : QWidget(parent)
    , m_choice(new QComboBox)
    , m_film(new QSlider(Qt::Horizontal))
    , m_play(new QPushButton(tr("&Play")))
    , m_timer(new QTimer(this))
    , m_coefficients(new PaintedPlot(QStringLiteral("historyCoefficients"),
          [this](QPainter& p, const QRectF& r, const FleetLook& l) { paintCoefficientHistory(p, r, m_history, l); }))
    , m_curves(new PaintedPlot(QStringLiteral("historyCurves"),
          [this](QPainter& p, const QRectF& r, const FleetLook& l) { paintCurveHistory(p, r, m_history, l); }))
    , m_dates(new PaintedPlot(
          QStringLiteral("historyDates"), [this](QPainter& p, const QRectF& r, const FleetLook& l) { paintDates(p, r, l); }))
    , m_words(new QLabel)
{
    build();
}

void HistoryPanel::build()
{
    m_choice->setObjectName(QStringLiteral("populationHistory"));
    m_film->setObjectName(QStringLiteral("historyFilm"));
    m_film->setToolTip(tr("The swings one after the other"));
    m_play->setObjectName(QStringLiteral("historyPlay"));
    m_words->setWordWrap(true);
    m_words->setObjectName(QStringLiteral("historyWords"));
    m_timer->setInterval(kFilmStep_ms);
    auto* row = new QHBoxLayout;
    row->addWidget(m_choice);
    row->addWidget(m_film, 1);
    row->addWidget(m_play);
    auto* right = new QSplitter(Qt::Vertical);
    right->addWidget(m_curves);
    right->addWidget(m_dates);
    right->setStretchFactor(0, 2);
    right->setStretchFactor(1, 1);
    auto* plots = new QSplitter(Qt::Horizontal);
    plots->addWidget(m_coefficients);
    plots->addWidget(right);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(plots, 1);
    column->addWidget(m_words);
    connect(m_choice, &QComboBox::activated, this, [this] { showCompass(m_choice->currentData().toInt()); });
    connect(m_film, &QSlider::valueChanged, this, [this](int shown) {
        m_history.shown = static_cast<std::size_t>(shown);
        m_coefficients->update();
        m_curves->update();
    });
    connect(m_play, &QPushButton::clicked, this, [this] {
        if (m_timer->isActive())
            return m_timer->stop();
        m_film->setValue(m_film->minimum());
        m_timer->start();
    });
    connect(m_timer, &QTimer::timeout, this, &HistoryPanel::step);
}

void HistoryPanel::step()
{
    if (m_film->value() >= m_film->maximum())
        m_timer->stop();
    else
        m_film->setValue(m_film->value() + 1);
}

void HistoryPanel::show(std::shared_ptr<const PopulationNews> news, CompassId first)
{
    m_news = std::move(news);
    const auto& [fleet, report, selection, firstLook] = *m_news;
    m_choice->clear();
    const auto add = [this, &compasses = fleet.compasses](std::int32_t compass) {
        const auto& one = compasses[static_cast<std::size_t>(compass)];
        m_choice->addItem(QStringLiteral("%1 · %2").arg(toText(one.aircraft), toText(one.compass)), compass);
    };
    std::int32_t shown = report.ranking.compasses.empty() ? report.histories.front().compass : report.ranking.compasses.front().compass;
    // In the order of the ranking, so that the first to look at is the first to swing; then those that could not be ranked.
    std::vector<bool> listed(fleet.compasses.size(), false);
    for (const auto& ranked : report.ranking.compasses)
        if (m_choice->count() < kMostChoices) {
            add(ranked.compass);
            listed[static_cast<std::size_t>(ranked.compass)] = true;
        }
    for (const auto& history : report.histories) {
        const auto place = static_cast<std::size_t>(history.compass);
        const bool wanted = first.valid() && fleet.compasses[place].id == first;
        if (wanted)
            shown = history.compass;
        if (!listed[place] && (wanted || m_choice->count() < kMostChoices))
            add(history.compass);
    }
    showCompass(shown);
}

const RankedCompass* HistoryPanel::ranked() const
{
    if (!m_news)
        return nullptr;
    const auto& all = m_news->report.ranking.compasses;
    const auto found = std::ranges::find(all, m_shown, &RankedCompass::compass);
    return found == all.end() ? nullptr : &*found;
}

void HistoryPanel::paintDates(QPainter& painter, const QRectF& rect, const FleetLook& look) const
{
    if (const auto* one = ranked(); one && !one->reachedShare.empty())
        return paintLimitDates(painter, rect, *one, look);
    paintNothing(painter, rect,
        !m_news        ? tr("Computing.")
            : ranked() ? tr("It is not expected to reach its limit: no date to tell.")
                       : tr("No limit is known of this compass, so no date by which it is reached."),
        look);
}

void HistoryPanel::showCompass(std::int32_t compass)
{
    if (!m_news)
        return;
    const auto& report = m_news->report;
    const auto found = std::ranges::find(report.histories, compass, &CompassHistory::compass);
    if (found == report.histories.end())
        return;
    m_shown = compass;
    m_choice->setCurrentIndex(m_choice->findData(compass));
    m_history = historyDrawing(m_news->fleet, report.curves, *found, report.changes);
    m_film->setRange(std::min(1, static_cast<int>(m_history.points.size())), static_cast<int>(m_history.points.size()));
    m_film->setValue(m_film->maximum());
    m_history.shown = m_history.points.size();
    QStringList lines;
    for (const auto& jump : report.changes.jumps)
        if (jump.compass == compass)
            lines += toText(inWords(jump, m_news->fleet)) + QStringLiteral(" — ")
                + toText(inWords(
                    likelyPart(jumpedTogether(report.changes, jump), m_news->fleet.compasses[static_cast<std::size_t>(compass)].kind)));
    for (const auto& each : report.changes.drifts)
        if (each.compass == compass)
            lines += tr("%1 drifts by %2° a year (95 %: %3 to %4).")
                         .arg(QLatin1Char(letterOf(kCoefficients[each.coefficient])))
                         .arg(signedNumber(each.drift.perYear, 2), signedNumber(each.drift.interval95.low, 2),
                             signedNumber(each.drift.interval95.high, 2));
    if (const auto* one = ranked(); one && one->reached50_day)
        lines += tr("Its limit is reached by %1 in half of the futures, by %2 in one of twenty.")
                     .arg(toText(dateOfDay(*one->reached50_day)), toText(dateOfDay(*one->reached5_day)));
    if (lines.isEmpty())
        lines += tr("No jump and no drift of it is told.");
    lines += tr("Filled: as found; open or dashed: as left. Bars: 95 % by the readings.");
    m_words->setText(inAngleStyle(lines.join('\n')));
    for (auto* plot : {m_coefficients, m_curves, m_dates})
        plot->update();
}

} // namespace lubberline::ui
