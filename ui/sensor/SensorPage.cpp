#include "ui/sensor/SensorPage.h"

#include <QGroupBox>
#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/plots/base/Plot.h"
#include "ui/sensor/MapControls.h"
#include "ui/sensor/SensorActions.h"
#include "ui/sensor/SensorChooser.h"
#include "ui/sensor/SensorEditor.h"
#include "ui/sensor/SensorFieldForm.h"
#include "ui/sensor/SensorForm.h"
#include "ui/sensor/SensorMaps.h"
#include "ui/sensor/SmithTermsPanel.h"

namespace lubberline::ui {

namespace {

constexpr int kFrame_ms = 16;

} // namespace

SensorPage::SensorPage(EditContext& context, QUndoStack& stack, FileQuestions files, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_files(files)
    , m_editor(new SensorEditor(context, stack, this))
    , m_field(new SensorFieldForm(context.stores.clock()))
    , m_form(new SensorForm)
    , m_controls(new MapControls(*m_editor))
    , m_maps(new SensorMaps)
    , m_smith(new SmithTermsPanel)
{
    setTitle(tr("Sensor model"));
    auto* splitter = new SideBySide;
    splitter->setObjectName(QStringLiteral("sensorSplitter"));
    splitter->addWidget(buildFigures(std::move(files)));
    splitter->addWidget(buildViews());
    splitter->setStretchFactor(1, 1);
    body().addWidget(splitter, 1);
    m_soon.setSingleShot(true);
    m_soon.setInterval(kFrame_ms);
    connectParts();
}

QWidget* SensorPage::buildFigures(FileQuestions files)
{
    m_actions = new SensorActions({m_context.stores, *m_editor, *m_field}, std::move(files));
    auto* field = new QGroupBox(tr("Earth's field"));
    auto* fieldLayout = new QVBoxLayout(field);
    fieldLayout->setContentsMargins(6, 4, 6, 4);
    fieldLayout->addWidget(m_field);
    auto* figures = new QWidget;
    auto* layout = new QVBoxLayout(figures);
    layout->setContentsMargins(0, 0, 4, 0);
    layout->setSpacing(4);
    layout->addWidget(new SensorChooser(*m_editor));
    layout->addWidget(m_actions);
    layout->addWidget(field);
    layout->addWidget(m_form);
    layout->addStretch(1);
    auto* panel = new SidePanel(figures);
    panel->setObjectName(QStringLiteral("sensorFigures"));
    return panel;
}

QWidget* SensorPage::buildViews()
{
    auto* above = new QWidget;
    auto* layout = new QVBoxLayout(above);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_controls);
    layout->addWidget(m_maps, 1);
    auto* views = new QSplitter(Qt::Vertical);
    views->setObjectName(QStringLiteral("sensorViews"));
    views->addWidget(above);
    views->addWidget(m_smith);
    views->setStretchFactor(0, 1);
    views->setSizes({460, 170});
    views->setChildrenCollapsible(false);
    return views;
}

void SensorPage::connectParts()
{
    connect(m_editor, &SensorEditor::changed, this, [this] {
        m_form->show(m_editor->model(), m_editor->editable());
        rest();
    });
    connect(m_editor, &SensorEditor::played, this, &SensorPage::play);
    connect(m_editor, &SensorEditor::failed, this, &SensorPage::failed);
    connect(m_form, &SensorForm::played, m_editor, &SensorEditor::play);
    connect(m_form, &SensorForm::settled, this, [this](const QString& what) {
        m_editor->settle(what);
        if (m_soon.isActive() || (m_view && m_view->coarse))
            rest(); // nothing was stored, but something was played
    });
    connect(m_field, &SensorFieldForm::played, this, &SensorPage::play);
    connect(m_field, &SensorFieldForm::changed, this, &SensorPage::rest);
    connect(m_controls, &MapControls::played, this, &SensorPage::play);
    connect(m_controls, &MapControls::changed, this, &SensorPage::rest);
    connect(m_controls, &MapControls::exportWanted, this, &SensorPage::exportFront);
    connect(m_actions, &SensorActions::failed, this, &SensorPage::failed);
    connect(m_actions, &SensorActions::benchWanted, this, [this] { emit benchWanted(compass()); });
    connect(m_maps, &SensorMaps::readOut, this, &SensorPage::readOut);
    connect(m_maps, &SensorMaps::failed, this, &SensorPage::failed);
    connect(&m_soon, &QTimer::timeout, this, [this] { showViews(true); });
    connect(&m_context.stores.changes(), &db::Changes::fleetChanged, this, &SensorPage::followSites);
}

CompassId SensorPage::compass() const { return m_editor->compass(); }

Result<void> SensorPage::showCompass(CompassId id)
{
    const bool another = id != compass();
    if (auto shown = showParticulars(id); !shown)
        return shown;
    if (another)
        showField(id);
    return m_editor->open(id);
}

Result<void> SensorPage::showParticulars(CompassId id)
{
    const auto record = m_context.stores.fleet.compass(id);
    if (!record)
        return record.error();
    const auto aircraft = m_context.stores.fleet.aircraft(record->aircraft);
    if (!aircraft)
        return aircraft.error();
    setTitle(tr("Sensor model · %1 · %2").arg(toText(aircraft->registration), toText(record->name))
        + (aircraft->demonstration ? tr(" · DEMONSTRATION") : QString()));
    m_limits.reset();
    if (const auto profiles = m_context.stores.sites.limitsProfiles())
        for (const LimitsProfile& profile : *profiles)
            if (profile.id == record->limits)
                m_limits = profile;
    if (const auto sites = m_context.stores.sites.sites())
        m_field->setSites(*sites);
    return {};
}

void SensorPage::showField(CompassId id)
{
    const auto swings = m_context.stores.swings.swingsOf(id);
    if (!swings || swings->empty())
        return;
    const auto newest = m_context.stores.swings.record(swings->front().id);
    if (!newest || !newest->swing.field)
        return;
    if (newest->site && newest->site->latitude_deg && newest->site->longitude_deg)
        m_field->showSite(newest->site->id, newest->swing.date);
    else
        m_field->showTyped(newest->swing.field->field.meridian());
}

void SensorPage::followSites()
{
    if (!compass().valid())
        return;
    if (const auto shown = showParticulars(compass()); shown)
        rest();
}

void SensorPage::play()
{
    if (!m_soon.isActive())
        m_soon.start();
}

void SensorPage::rest()
{
    m_soon.stop();
    showViews(false);
}

void SensorPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_stale)
        rest();
}

void SensorPage::showViews(bool coarse)
{
    m_stale = !isVisible();
    if (m_stale)
        return;
    const auto& field = m_field->field();
    m_view.reset();
    if (!field) {
        m_maps->show(m_view, tr("No field: %1").arg(messageOf(field.error())));
        m_smith->show(field.error());
        return m_smith->showKnowledge(field.error(), {});
    }
    m_view.emplace();
    m_view->model = {m_editor->model(), m_editor->name(), m_editor->uncertainty()};
    m_view->field = *field;
    m_controls->fill(*m_view);
    if (m_limits) {
        m_view->limit_deg = m_limits->maxDeviation_deg;
        m_view->limitDocument = toText(m_limits->document);
    }
    m_view->coarse = coarse;
    m_maps->show(m_view, {});
    const auto smith = smithOf(m_view->model.model, *field);
    m_smith->show(smith);
    if (!coarse)
        m_smith->showKnowledge(smith, *field);
}

void SensorPage::exportFront()
{
    const Plot& plot = m_maps->front();
    const QString suggestion = QStringLiteral("%1-%2.png").arg(m_editor->name(), plot.name());
    const QString path
        = m_files.save(tr("Export the plot"), suggestion, tr("PNG picture (*.png);;SVG drawing (*.svg);;PDF document (*.pdf)"));
    if (path.isEmpty())
        return;
    if (const auto exported = plot.exportTo(path); !exported)
        emit failed(messageOf(exported.error()));
}

} // namespace lubberline::ui
