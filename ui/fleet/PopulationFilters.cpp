#include "ui/fleet/PopulationFilters.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/kit/Words.h"
#include "ui/kit/fit/FlowLayout.h"

namespace lubberline::ui {

namespace {

QComboBox* filterBox(const char* name, const QString& tip, const QStringList& words = {})
{
    auto* box = new QComboBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setToolTip(tip);
    box->addItems(words);
    return box;
}

QLineEdit* dayField(const char* name, const QString& tip, const QString& empty)
{
    auto* line = new QLineEdit;
    line->setObjectName(QString::fromLatin1(name));
    line->setToolTip(tip);
    line->setPlaceholderText(empty);
    line->setClearButtonEnabled(true);
    line->setFixedWidth(line->fontMetrics().horizontalAdvance(QStringLiteral("2026-11-23")) + 40);
    return line;
}

/// The chosen item's data: a name, empty for "all".
std::string chosen(const QComboBox& box) { return box.currentData().toString().toStdString(); }

/// Errors: InvalidInput.
Result<std::optional<int>> dayIn(const QLineEdit& line, const QString& what)
{
    const std::string text = line.text().trimmed().toStdString();
    if (text.empty())
        return std::optional<int>();
    if (const auto day = dayOfDate(text))
        return day;
    return Error{ErrorCode::InvalidInput,
        said(PopulationFilters::tr("%1: '%2' is no day of the calendar; expected YYYY-MM-DD").arg(what, toText(text)))};
}

// Lists of their own: lupdate takes a brace among the members' initialisers for the end of the class, and what follows for nobody's words.
QStringList stageChoices()
{
    return {PopulationFilters::tr("found and left"), PopulationFilters::tr("as found"), PopulationFilters::tr("as left")};
}

QStringList radioChoices()
{
    return {PopulationFilters::tr("any radio state"), PopulationFilters::tr("radio on"), PopulationFilters::tr("radio off")};
}

QStringList voteChoices() { return {PopulationFilters::tr("one aircraft, one vote"), PopulationFilters::tr("one swing, one vote")}; }

} // namespace

PopulationFilters::PopulationFilters(db::Stores& stores, QWidget* parent)
    : QWidget(parent)
    , m_stores(stores)
    , m_type(filterBox("populationType", tr("Aircraft type")))
    , m_compass(filterBox("populationCompass", tr("Compass system; those of the swings that were computed last are offered")))
    , m_site(filterBox("populationSite", tr("Where they were swung")))
    , m_base(filterBox("populationBase", tr("Where the aircraft are based now")))
    , m_stage(filterBox("populationStage", tr("Of pattern, coefficients and bases; pairs and histories need both"), stageChoices()))
    , m_radio(filterBox("populationRadio", tr("State of the radio"), radioChoices()))
    , m_vote(filterBox("populationVote", tr("Who has a say in the mean"), voteChoices()))
    , m_grid(new QSpinBox)
    , m_from(dayField("populationFrom", tr("From this day on, YYYY-MM-DD"), tr("from")))
    , m_to(dayField("populationTo", tr("Up to this day, YYYY-MM-DD"), tr("to")))
    , m_training(dayField("populationTraining",
          tr("A day to compare |A| before and after, as that of a training, YYYY-MM-DD; empty: the data are asked for one"),
          tr("training")))
{
    m_grid->setObjectName(QStringLiteral("populationGrid"));
    m_grid->setRange(3, 360);
    m_grid->setValue(8);
    m_grid->setSuffix(tr(" headings"));
    auto* line = new FlowLayout(this);
    for (QWidget* part : std::initializer_list<QWidget*>{m_type, m_compass, m_site, m_base, m_stage, m_radio, m_vote, m_grid,
             labelled(tr("Period:"), m_from), m_to, labelled(tr("Training:"), m_training)})
        line->addWidget(part);
}

void PopulationFilters::load(const FleetSwings* fleet)
{
    const auto reload = [](QComboBox& box, const QString& all, const QStringList& names) {
        const QString kept = box.currentData().toString();
        box.clear();
        box.addItem(all, QString());
        for (const auto& name : names)
            box.addItem(name, name);
        box.setCurrentIndex(std::max(0, box.findData(kept)));
    };
    QStringList types, sites;
    if (const auto found = m_stores.fleet.types())
        for (const auto& type : *found)
            types += toText(type.name);
    if (const auto found = m_stores.sites.sites())
        for (const auto& site : *found)
            sites += toText(site.name);
    reload(*m_type, tr("all types"), types);
    reload(*m_site, tr("swung anywhere"), sites);
    reload(*m_base, tr("based anywhere"), sites);
    constexpr qsizetype mostNames = 50;
    QStringList names;
    if (fleet)
        for (const auto& compass : fleet->compasses)
            if (const QString name = toText(compass.compass); names.size() < mostNames && !names.contains(name))
                names += name;
    if (const QString kept = m_compass->currentData().toString(); !kept.isEmpty() && !names.contains(kept))
        names += kept;
    reload(*m_compass, tr("all compass systems"), names);
}

void PopulationFilters::chooseType(const QString& name) { m_type->setCurrentIndex(std::max(0, m_type->findData(name))); }

Result<PopulationFilters::Wish> PopulationFilters::wish() const
{
    Wish wish;
    wish.selection.type = chosen(*m_type);
    wish.selection.compass = chosen(*m_compass);
    wish.selection.site = chosen(*m_site);
    wish.selection.base = chosen(*m_base);
    wish.selection.from = m_from->text().trimmed().toStdString();
    wish.selection.to = m_to->text().trimmed().toStdString();
    if (m_radio->currentIndex() > 0)
        wish.selection.radio = m_radio->currentIndex() == 1 ? RadioState::On : RadioState::Off;
    const auto from = dayIn(*m_from, tr("from")), to = dayIn(*m_to, tr("to")), training = dayIn(*m_training, tr("training"));
    for (const auto* day : {&from, &to, &training})
        if (!*day)
            return day->error();
    wish.options.training_day = *training;
    wish.options.grid = m_grid->value();
    wish.options.vote = m_vote->currentIndex() == 1 ? FleetVote::Swing : FleetVote::Aircraft;
    if (m_stage->currentIndex() > 0)
        wish.options.stage = m_stage->currentIndex() == 1 ? SwingStage::AsFound : SwingStage::AsLeft;
    wish.options.today_day = dayOfDate(m_stores.clock().today().text()).value_or(0);
    return wish;
}

} // namespace lubberline::ui
