#include "ui/earth/PredictionPage.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

#include <span>

#include "core/sensor/SensorSetup.h"
#include "core/swing/SwingPlaces.h"
#include "ui/earth/AssumedIronForm.h"
#include "ui/kit/PlaceText.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/plots/swing/PredictionPlot.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kMostSwings = 40; ///< of one compass that are read at once: more would be felt

QLabel* words(const char* name, QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QLabel* wrapped(const QString& text)
{
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    return label;
}

QString verdictWords(const Prediction& prediction, const std::optional<LimitsProfile>& limits)
{
    const QString largest = PredictionPage::tr("Up to %1° expected").arg(toDegrees(prediction.maxAbs_rad), 0, 'f', 1)
        + (prediction.maxAbsPossible_rad > prediction.maxAbs_rad
                ? PredictionPage::tr(", up to %1° possible (95 %)").arg(toDegrees(prediction.maxAbsPossible_rad), 0, 'f', 1)
                : QString());
    switch (judge(prediction, limits)) {
    case PredictedVerdict::InLimits: return PredictionPage::tr("● In limits. %1; allowed %2°.").arg(largest).arg(*limits->maxDeviation_deg);
    case PredictedVerdict::MayLeaveLimits:
        return PredictionPage::tr("▲ May leave its limits. %1; allowed %2°.").arg(largest).arg(*limits->maxDeviation_deg);
    case PredictedVerdict::OutOfLimits:
        return PredictionPage::tr("▲ OUT OF LIMITS. %1; allowed %2°.").arg(largest).arg(*limits->maxDeviation_deg);
    case PredictedVerdict::NoLimit: break;
    }
    return PredictionPage::tr("○ %1; no limits are set for this compass.").arg(largest);
}

} // namespace

PredictionPage::PredictionPage(db::Stores& stores, QWidget* parent) : Page(parent), m_stores(stores)
{
    build();
    showNothing(tr("Choose a swing, then the base that the aircraft moves to."));
}

PredictionPage::~PredictionPage()
{
    m_assumed->disconnect(this);
    for (auto* line : findChildren<QLineEdit*>())
        line->disconnect(this);
}

void PredictionPage::build()
{
    setTitle(tr("What it will read elsewhere"));
    auto* splitter = new SideBySide;
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(buildForm());
    column->addWidget(buildWords(), 1);
    m_plot = new PredictionPlot;
    m_plot->setObjectName(QStringLiteral("prediction"));
    follow(*m_plot);
    splitter->addWidget(new SidePanel(left));
    splitter->addWidget(m_plot);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({400, 620});
    body().addWidget(splitter, 1);
}

QWidget* PredictionPage::buildForm()
{
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    const auto line = [&](const QString& title, const char* name) {
        auto* edit = new QLineEdit;
        edit->setObjectName(QString::fromLatin1(name));
        connect(edit, &QLineEdit::editingFinished, this, &PredictionPage::recompute);
        form->addRow(title, edit);
        return edit;
    };
    m_basis = new QComboBox;
    m_basis->setObjectName(QStringLiteral("predictionBasis"));
    m_basis->addItems({tr("this swing alone"), tr("all its swings at different places")});
    connect(m_basis, &QComboBox::activated, this, &PredictionPage::useSwings);
    form->addRow(tr("&From:"), m_basis);
    m_site = new QComboBox;
    m_site->setObjectName(QStringLiteral("predictionSite"));
    connect(m_site, &QComboBox::activated, this, &PredictionPage::takeSite);
    form->addRow(tr("&Base:"), m_site);
    m_latitude = line(tr("&Latitude:"), "predictionLatitude");
    m_longitude = line(tr("L&ongitude:"), "predictionLongitude");
    m_date = line(tr("&Date:"), "predictionDate");
    m_date->setText(toText(m_stores.clock().today()));
    m_field = words("predictionField", this);
    form->addRow(tr("Field there:"), m_field);
    form->addRow(wrapped(tr("Where the swing cannot tell, assumed to be about:")));
    m_assumed = new AssumedIronForm(*form, this);
    connect(m_assumed, &AssumedIronForm::changed, this, &PredictionPage::recompute);
    return box;
}

QWidget* PredictionPage::buildWords()
{
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    m_verdict = words("predictionVerdict", this);
    m_again = words("predictionAgain", this);
    m_warnings = words("predictionWarnings", this);
    m_knowledge = new QListWidget;
    m_knowledge->setObjectName(QStringLiteral("predictionKnowledge"));
    m_knowledge->setWordWrap(true);
    for (QWidget* each : {static_cast<QWidget*>(m_verdict), static_cast<QWidget*>(m_again), static_cast<QWidget*>(m_warnings)})
        layout->addWidget(each);
    layout->addWidget(wrapped(tr("What the swings tell (✓) and what they cannot (–):")));
    layout->addWidget(m_knowledge, 1);
    return box;
}

void PredictionPage::loadSites()
{
    const QString chosen = m_site->currentText();
    m_site->clear();
    m_sites.clear();
    m_site->addItem(tr("(typed below)"));
    const auto sites = m_stores.sites.sites();
    if (!sites) {
        emit failed(messageOf(sites.error()));
        return;
    }
    for (const Site& site : *sites) {
        if (!site.latitude_deg || !site.longitude_deg)
            continue;
        m_sites.push_back(site);
        m_site->addItem(toText(site.name));
    }
    m_site->setCurrentIndex(std::max(0, m_site->findText(chosen)));
}

Result<void> PredictionPage::showSwing(SwingId id)
{
    auto record = m_stores.swings.record(id);
    if (!record)
        return record.error();
    m_record = std::move(record.value());
    m_separation.reset();
    m_basis->setCurrentIndex(0);
    setTitle(tr("What it will read elsewhere: %1").arg(titleOf(m_record)));
    auto swing = m_stores.results.placeOf(m_record);
    m_swing = swing ? std::optional(*swing) : std::nullopt;
    m_whyNoSwing = swing ? QString() : messageOf(swing.error());
    loadSites();
    recompute();
    return {};
}

void PredictionPage::takeSite(int index)
{
    if (index > 0) {
        const Site& site = m_sites[static_cast<std::size_t>(index - 1)];
        m_latitude->setText(latitudeToType(*site.latitude_deg));
        m_longitude->setText(longitudeToType(*site.longitude_deg));
    }
    recompute();
}

Result<std::vector<SwingAtPlace>> PredictionPage::swingsOfCompass() const
{
    const auto rows = m_stores.swings.swingsOf(m_record.compass.id);
    if (!rows)
        return rows.error();
    std::vector<SwingAtPlace> swings;
    for (std::size_t i = 0; i < rows->size() && i < kMostSwings; ++i)
        if (const auto record = m_stores.swings.record((*rows)[i].id))
            if (auto swing = m_stores.results.placeOf(*record)) // what tells nothing of iron is passed over
                swings.push_back(std::move(swing.value()));
    return swings;
}

void PredictionPage::useSwings()
{
    m_separation.reset();
    if (m_basis->currentIndex() == 1) {
        auto swings = swingsOfCompass();
        auto separation = swings ? separateIron(*swings) : Result<IronSeparation>(swings.error());
        if (!separation) {
            m_basis->setCurrentIndex(0);
            emit failed(messageOf(separation.error()));
        } else {
            m_others = std::move(swings.value());
            m_separation = std::move(separation.value());
        }
    }
    recompute();
}

Result<MeridianField> PredictionPage::fieldThere() const
{
    const auto latitude = parseLatitude_deg(m_latitude->text()), longitude = parseLongitude_deg(m_longitude->text());
    if (!latitude)
        return latitude.error();
    if (!longitude)
        return longitude.error();
    const auto place = makePlace(*latitude, *longitude);
    if (!place)
        return place.error();
    return fieldOf({PlaceAndDate{*place, m_date->text().trimmed().toStdString()}, {}, {}});
}

Result<Prediction> PredictionPage::predictAt(const MeridianField& field, const AssumedIron& assumed) const
{
    const std::span swings = m_separation ? std::span<const SwingAtPlace>(m_others) : std::span<const SwingAtPlace>(&*m_swing, 1);
    return predict(swings, {m_swing->field, field}, assumed);
}

void PredictionPage::recompute()
{
    m_there.reset();
    showKnowledge();
    if (!m_swing) {
        showNothing(m_whyNoSwing.isEmpty() ? tr("Choose a swing first.") : m_whyNoSwing);
        return;
    }
    if (m_latitude->text().trimmed().isEmpty() || m_longitude->text().trimmed().isEmpty()) {
        showNothing(tr("Choose the base, or type its latitude and longitude."));
        return;
    }
    const auto field = fieldThere();
    if (!field) {
        showNothing(messageOf(field.error()));
        return;
    }
    m_field->setText(inAngleStyle(
        tr("H %1 nT, dip %2° (down +)").arg(field->horizontal_nT, 0, 'f', 0).arg(toDegrees(field->inclination_rad()), 0, 'f', 1)));
    const auto assumed = m_assumed->assumed();
    const auto there = assumed ? predictAt(*field, *assumed) : Result<Prediction>(assumed.error());
    if (!there) {
        showNothing(messageOf(there.error()));
        return;
    }
    const auto here = predictAt(m_swing->field, *assumed);
    showPrediction(*there, here ? std::optional(*here) : std::nullopt);
}

void PredictionPage::showNothing(const QString& why)
{
    m_verdict->setText(why);
    m_field->clear();
    m_again->clear();
    m_warnings->clear();
    m_plot->setPicture({{}, {}, {}, why});
}

void PredictionPage::showPrediction(const Prediction& there, const std::optional<Prediction>& here)
{
    m_there = there;
    m_verdict->setText(inAngleStyle(verdictWords(there, m_record.limits)));
    m_again->clear();
    if (const auto again = swingAgainAfterMove(there, m_record.limits))
        m_again->setText(inAngleStyle(again->needed ? tr("Swing again after the move: %1.").arg(toText(again->reason))
                                                    : tr("No new swing is needed for the move: %1.").arg(toText(again->reason))));
    QStringList lines{tr("From %1.").arg(toText(there.basis))};
    lines += tr("The band holds the whole curve with a probability of %1 %, assuming %2.")
                 .arg(100 * kBoundProbability, 0, 'f', 0)
                 .arg(toText(sayAssumed(*there.assumed)));
    for (const auto& warning : there.warnings)
        lines += tr("Mind: %1.").arg(toText(warning));
    m_warnings->setText(inAngleStyle(lines.join('\n')));
    m_plot->setPicture({there, here, m_record.limits ? m_record.limits->maxDeviation_deg : std::nullopt, {}});
}

void PredictionPage::showKnowledge()
{
    m_knowledge->clear();
    if (!m_swing)
        return;
    for (const auto& each : whatSwingsTell(*m_swing, m_separation))
        m_knowledge->addItem((each.known ? QStringLiteral("✓ ") : QStringLiteral("– ")) + toText(each.what));
}

} // namespace lubberline::ui
