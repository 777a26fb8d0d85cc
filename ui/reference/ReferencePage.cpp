#include "ui/reference/ReferencePage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/reference/LevelIron.h"
#include "ui/kit/PlaySlider.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/reference/ManoeuvreLine.h"
#include "ui/reference/Painted.h"

namespace lubberline::ui {

namespace {

constexpr int kFormWidth = 290;
constexpr int kSliderSteps = 1000, kCoarseSteps = 50;
constexpr int kFrame_ms = 40;

/// What a visitor finds: turns, an acceleration, a climb; a light aircraft with a slaved gyro.
Scenario firstScenario()
{
    Scenario scenario;
    scenario.latitude_deg = 52;
    scenario.dip_deg = 67;
    scenario.speed_m_s = 62;
    scenario.heading_deg = 350;
    scenario.step_s = 0.1;
    scenario.duration_s = 600;
    scenario.manoeuvres = {{30, 60, 0, 1, 0}, {90, 180, 0, 0, 5}, {220, 280, 3, 0, 0}, {340, 460, -3, 0, 0}};
    scenario.vertical = VerticalGyro{};
    scenario.gyro = HeadingGyro{};
    scenario.gyro->drift_deg_h = 3;
    scenario.gyro->apparentDrift = true;
    scenario.gyro->slavingTau_s = 60;
    return scenario;
}

QString manoeuvreFigure(double value) { return value == 0 ? QString() : plainNumber(value, value == std::round(value) ? 0 : 2); }

} // namespace

ReferencePage::ReferencePage(FileQuestions files, FindIron find, QWidget* parent)
    : Page(parent)
    , m_files(std::move(files))
    , m_find(std::move(find))
    , m_scenario(firstScenario())
    , m_loop(new QComboBox)
    , m_compass(new QComboBox)
    , m_iron(new QCheckBox)
    , m_table(new QTableWidget)
    , m_time(new DrawnPlot(tr("Heading error"), {260, 180}))
    , m_gain(new DrawnPlot(tr("Gain"), {150, 220}))
    , m_line(new ManoeuvreLine)
    , m_dials(new Painted({180, 150}))
    , m_film(new QPushButton(tr("&Film")))
    , m_worker([this](Result<ReferenceRun> run) { take(std::move(run)); })
{
    setObjectName(QStringLiteral("referencePage"));
    build();
    showControls();
    run();
}

int ReferencePage::positionOf(const Knob& knob, const Scenario& scenario)
{
    const double value = std::clamp(knob.show(scenario), knob.least, knob.most);
    const double part = knob.logarithmic ? std::log(value / knob.least) / std::log(knob.most / knob.least)
                                         : (value - knob.least) / (knob.most - knob.least);
    return static_cast<int>(std::lround(part * kSliderSteps));
}

void ReferencePage::addKnob(QFormLayout& form, const QString& title, const char* name, Knob knob)
{
    knob.slider = new PlaySlider(Qt::Horizontal);
    knob.slider->setObjectName(QString::fromLatin1(name));
    knob.slider->setRange(0, kSliderSteps);
    knob.value = new QLabel;
    knob.value->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0000 deg")));
    auto* row = new QHBoxLayout;
    row->addWidget(knob.slider, 1);
    row->addWidget(knob.value);
    auto* label = new QLabel(title);
    label->setBuddy(knob.slider);
    form.addRow(label, row);
    PlaySlider* slider = knob.slider;
    slider->setToolTip(tr("Arrow keys, or Shift while dragging: fine steps; page keys: coarse ones; double click: back to where it began"));
    connect(slider, &QSlider::valueChanged, this, &ReferencePage::turned);
    connect(slider, &PlaySlider::stepped, slider,
        [slider](int steps, bool coarse) { slider->setValue(slider->value() + steps * (coarse ? kCoarseSteps : 1)); });
    connect(slider, &PlaySlider::resetWanted, slider, [slider, at = positionOf(knob, firstScenario())] { slider->setValue(at); });
    m_knobs.push_back(std::move(knob));
}

QWidget* ReferencePage::buildControls()
{
    auto* panel = new QWidget;
    auto* form = new QFormLayout(panel);
    m_loop->setObjectName(QStringLiteral("referenceLoop"));
    m_loop->addItems(
        {tr("no vertical gyro"), tr("first order"), tr("second order, damped"), tr("second order, integral"), tr("third order")});
    form->addRow(tr("&Levelling:"), m_loop);
    const auto vertical = [](double VerticalGyro::*member) {
        return Knob{nullptr, nullptr, 1, 3000, true, QStringLiteral("s"),
            [member](const Scenario& s) { return (s.vertical.value_or(VerticalGyro{})).*member; },
            [member](Scenario& s, double value) {
                if (s.vertical)
                    (*s.vertical).*member = value;
            }};
    };
    addKnob(*form, tr("τ&1:"), "referenceTau1", vertical(&VerticalGyro::tau1_s));
    addKnob(*form, tr("τ&2:"), "referenceTau2", vertical(&VerticalGyro::tau2_s));
    addKnob(*form, tr("τ&3:"), "referenceTau3", vertical(&VerticalGyro::tau3_s));
    addKnob(*form, tr("&Slaving τ:"), "referenceSlaving",
        {nullptr, nullptr, 1, 3000, true, QStringLiteral("s"),
            [](const Scenario& s) { return s.gyro ? s.gyro->slavingTau_s.value_or(3000) : 60; },
            [](Scenario& s, double value) {
                if (s.gyro)
                    s.gyro->slavingTau_s = value;
            }});
    addKnob(*form, tr("L&atitude:"), "referenceLatitude",
        {nullptr, nullptr, -90, 90, false, QStringLiteral("°"), [](const Scenario& s) { return s.latitude_deg; },
            [](Scenario& s, double value) { s.latitude_deg = value; }});
    addKnob(*form, tr("&Dip:"), "referenceDip",
        {nullptr, nullptr, -89, 89, false, QStringLiteral("°"), [](const Scenario& s) { return s.dip_deg; },
            [](Scenario& s, double value) { s.dip_deg = value; }});
    addKnob(*form, tr("S&peed:"), "referenceSpeed",
        {nullptr, nullptr, 0, 300, false, QStringLiteral("m/s"), [](const Scenario& s) { return s.speed_m_s; },
            [](Scenario& s, double value) { s.speed_m_s = value; }});
    // The bank of all turns: their rates are scaled to it, each keeping its side.
    addKnob(*form, tr("&Bank:"), "referenceBank",
        {nullptr, nullptr, 0, 60, false, QStringLiteral("°"),
            [](const Scenario& s) {
                double most = 0;
                for (const Manoeuvre& one : s.manoeuvres)
                    most = std::max(most, std::abs(one.turnRate_deg_s));
                return toDegrees(std::atan(s.speed_m_s * toRadians(most) / kGravity_m_s2));
            },
            [](Scenario& s, double value) {
                const double rate = s.speed_m_s > 0 ? toDegrees(std::tan(toRadians(value)) * kGravity_m_s2 / s.speed_m_s) : 0;
                for (Manoeuvre& one : s.manoeuvres)
                    if (one.turnRate_deg_s != 0)
                        one.turnRate_deg_s = std::copysign(std::clamp(rate, 0.01, 30.0), one.turnRate_deg_s);
            }});
    addKnob(*form, tr("G&usts:"), "referenceGusts",
        {nullptr, nullptr, 0, 3, false, QStringLiteral("m/s²"), [](const Scenario& s) { return s.gusts ? s.gusts->rms_m_s2 : 0.0; },
            [](Scenario& s, double value) {
                if (!s.gusts)
                    s.gusts = Gusts{};
                s.gusts->rms_m_s2 = value;
                if (value == 0)
                    s.gusts.reset();
            }});
    addKnob(*form, tr("Du&ration:"), "referenceDuration",
        {nullptr, nullptr, 60, 7200, true, QStringLiteral("s"), [](const Scenario& s) { return s.duration_s; },
            [](Scenario& s, double value) { s.duration_s = std::round(value); }});
    m_compass->setObjectName(QStringLiteral("referenceCompass"));
    m_compass->addItems({tr("needle"), tr("flux valve"), tr("flux valve, slaved gyro")});
    form->addRow(tr("&Compass:"), m_compass);
    m_iron->setObjectName(QStringLiteral("referenceIron"));
    m_iron->setToolTip(tr("As its newest swing has it, level: what a swing on the ground cannot tell (R, c, f, g, h, k) counts as none."));
    m_iron->hide();
    form->addRow(m_iron);
    connect(m_iron, &QCheckBox::toggled, this, &ReferencePage::takeIron);
    m_table->setObjectName(QStringLiteral("referenceTable"));
    m_table->setColumnCount(5);
    m_table->setHorizontalHeaderLabels({tr("from s"), tr("to s"), tr("turn °/s"), tr("m/s²"), tr("climb m/s")});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->setMinimumHeight(140);
    m_table->setToolTip(tr("A manoeuvre a row; one more may be typed in the last row. An empty row is taken out."));
    form->addRow(m_table);
    connect(m_loop, &QComboBox::activated, this, &ReferencePage::turned);
    connect(m_compass, &QComboBox::activated, this, &ReferencePage::turned);
    connect(m_table, &QTableWidget::cellChanged, this, &ReferencePage::takeTable);
    return panel;
}

void ReferencePage::build()
{
    setTitle(tr("Heading references in flight"));
    auto* load = new QPushButton(tr("&Open scenario…"));
    load->setObjectName(QStringLiteral("referenceLoad"));
    m_film->setObjectName(QStringLiteral("referenceFilm"));
    m_film->setCheckable(true);
    head().addStretch(1);
    head().addWidget(load);
    head().addWidget(m_film);
    connect(load, &QPushButton::clicked, this, &ReferencePage::load);
    connect(m_film, &QPushButton::toggled, this, [this](bool on) {
        if (on && m_picture->at_s >= (m_picture->time_s.empty() ? 0 : m_picture->time_s.back()))
            m_picture->at_s = 0;
        on ? m_clock.start(kFrame_ms) : m_clock.stop();
    });
    connect(&m_clock, &QTimer::timeout, this, &ReferencePage::showFrame);
    auto* below = new QHBoxLayout;
    below->addWidget(m_gain, 1);
    below->addWidget(m_dials, 1);
    auto* plots = new QWidget;
    auto* right = new QVBoxLayout(plots);
    right->setContentsMargins(0, 0, 0, 0);
    right->addWidget(m_time, 3);
    right->addWidget(m_line);
    right->addLayout(below, 2);
    m_time->setObjectName(QStringLiteral("referenceTime"));
    m_gain->setObjectName(QStringLiteral("referenceGain"));
    follow(*m_time);
    follow(*m_gain);
    connect(m_line, &ManoeuvreLine::drawn, this, &ReferencePage::takeManoeuvres);
    connect(m_line, &ManoeuvreLine::readOut, this, &Page::readOut);
    auto* across = new SideBySide;
    across->addWidget(new SidePanel(buildControls()));
    across->addWidget(plots);
    across->setStretchFactor(1, 1);
    across->setSizes({kFormWidth, 3 * kFormWidth});
    body().addWidget(across, 1);
    setFocusProxy(m_loop);
}

Plot* ReferencePage::plot() const { return m_gain->hasFocus() ? m_gain : m_time; }

void ReferencePage::showScenario(const Scenario& scenario)
{
    m_scenario = scenario;
    showControls();
    run();
}

Result<void> ReferencePage::open(const FleetItem& record)
{
    if (auto own = m_find ? m_find(record) : std::nullopt)
        m_own = std::move(own); // asked for from a page of no compass it stays that of the last
    m_iron->setVisible(m_own.has_value());
    if (m_own)
        m_iron->setText(tr("&Own deviation of %1").arg(m_own->of));
    showControls();
    return {};
}

SensorModel ReferencePage::ownModel() const { return levelIron(m_own->smith, m_scenario.compass.horizontal_nT); }

void ReferencePage::takeIron()
{
    if (m_showing || !m_own)
        return;
    constexpr double kUsual_nT = 18'000; // any: level, the deviation is that of the swing
    if (m_scenario.compass.horizontal_nT <= 0)
        m_scenario.compass.horizontal_nT = kUsual_nT;
    m_scenario.compass.model = m_iron->isChecked() ? std::optional(ownModel()) : std::nullopt;
    run();
}

void ReferencePage::showControls()
{
    m_showing = true;
    m_iron->setChecked(m_own && m_scenario.compass.model == std::optional(ownModel()));
    m_loop->setCurrentIndex(m_scenario.vertical ? static_cast<int>(m_scenario.vertical->loop) + 1 : 0);
    m_compass->setCurrentIndex(m_scenario.gyro ? 2 : m_scenario.compass.type == CompassType::FluxValve ? 1 : 0);
    for (const Knob& knob : m_knobs) {
        const double value = std::clamp(knob.show(m_scenario), knob.least, knob.most);
        knob.slider->setValue(positionOf(knob, m_scenario));
        knob.value->setText(QStringLiteral("%1 %2").arg(plainNumber(value, value < 10 ? 1 : 0), knob.unit));
    }
    m_line->show(m_scenario.manoeuvres, m_scenario.duration_s);
    m_table->setRowCount(static_cast<int>(m_scenario.manoeuvres.size()) + 1);
    for (int row = 0; row < m_table->rowCount(); ++row)
        for (int column = 0; column < 5; ++column)
            m_table->setItem(row, column, new QTableWidgetItem);
    int row = 0;
    for (const Manoeuvre& one : m_scenario.manoeuvres) {
        const QStringList figures{plainNumber(one.from_s, 0), plainNumber(one.to_s, 0), manoeuvreFigure(one.turnRate_deg_s),
            manoeuvreFigure(one.acceleration_m_s2), manoeuvreFigure(one.climb_m_s)};
        for (int column = 0; column < 5; ++column)
            m_table->item(row, column)->setText(figures[column]);
        ++row;
    }
    m_showing = false;
}

void ReferencePage::turned()
{
    if (m_showing)
        return;
    if (m_loop->currentIndex() == 0) {
        m_scenario.vertical.reset();
    } else {
        if (!m_scenario.vertical)
            m_scenario.vertical = VerticalGyro{};
        m_scenario.vertical->loop = static_cast<LoopKind>(m_loop->currentIndex() - 1);
    }
    m_scenario.compass.type = m_compass->currentIndex() == 0 ? CompassType::Needle : CompassType::FluxValve;
    if (m_compass->currentIndex() < 2)
        m_scenario.gyro.reset();
    else if (!m_scenario.gyro) {
        m_scenario.gyro = HeadingGyro{};
        m_scenario.gyro->slavingTau_s = 60;
    }
    for (const Knob& knob : m_knobs)
        if (knob.slider == sender()) {
            const double part = knob.slider->value() / double(kSliderSteps);
            knob.take(m_scenario,
                knob.logarithmic ? knob.least * std::pow(knob.most / knob.least, part) : knob.least + part * (knob.most - knob.least));
        }
    showControls();
    run();
}

void ReferencePage::takeTable()
{
    if (m_showing)
        return;
    std::vector<Manoeuvre> manoeuvres;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        std::array<double, 5> figures{};
        bool any = false;
        for (int column = 0; column < 5; ++column) {
            const QString text = m_table->item(row, column) ? m_table->item(row, column)->text().trimmed() : QString();
            if (text.isEmpty())
                continue;
            const auto number = typedNumber(text);
            if (!number) {
                refuse(tr("“%1” is no number").arg(text));
                return;
            }
            figures[static_cast<std::size_t>(column)] = *number;
            any = true;
        }
        if (any)
            manoeuvres.push_back({figures[0], figures[1], figures[2], figures[3], figures[4]});
    }
    takeManoeuvres(std::move(manoeuvres));
}

void ReferencePage::takeManoeuvres(std::vector<Manoeuvre> manoeuvres)
{
    Scenario changed = m_scenario;
    changed.manoeuvres = std::move(manoeuvres);
    if (const auto fine = checkScenario(changed); !fine) {
        refuse(messageOf(fine.error())); // half a row may be being typed
        return;
    }
    m_scenario = std::move(changed);
    showControls();
    run();
}

} // namespace lubberline::ui
