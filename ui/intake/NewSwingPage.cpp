#include "ui/intake/NewSwingPage.h"

#include <QApplication>
#include <QComboBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>

#include "ui/earth/FieldText.h"
#include "ui/fleet/RecordEdits.h"
#include "ui/kit/Words.h"
#include "ui/kit/keys/EnterGoesOn.h"

namespace lubberline::ui {

namespace {

constexpr int kWidth = 520;

QComboBox* typedChoice(const QString& name, const QString& placeholder)
{
    auto* box = new QComboBox;
    box->setObjectName(name);
    box->setEditable(true);
    box->setInsertPolicy(QComboBox::NoInsert);
    box->lineEdit()->setPlaceholderText(placeholder);
    return box;
}

QString typed(const QComboBox& box) { return box.currentText().trimmed(); }

template <class Row>
const Row* named(const std::vector<Row>& rows, const QString& name, std::string Row::*member)
{
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return toText(row.*member) == name; });
    return found == rows.end() ? nullptr : &*found;
}

template <class Row>
void fill(QComboBox& box, const std::vector<Row>& rows, std::string Row::*member)
{
    box.clear();
    for (const Row& row : rows)
        box.addItem(toText(row.*member));
    box.setCurrentIndex(-1);
    box.clearEditText();
}

Error missing(const QString& message) { return {ErrorCode::InvalidInput, said(message)}; }

} // namespace

NewSwingPage::NewSwingPage(EditContext& context, QUndoStack& stack, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_stack(stack)
    , m_type(typedChoice(QStringLiteral("newType"), tr("pick or type, as Su-22")))
    , m_aircraft(typedChoice(QStringLiteral("newAircraft"), tr("registration or tail number")))
    , m_compass(typedChoice(QStringLiteral("newCompass"), tr("as standby compass")))
    , m_limits(new QComboBox)
    , m_site(typedChoice(QStringLiteral("newSite"), tr("compass base; may stay empty")))
    , m_kind(new QComboBox)
    , m_stage(new QComboBox)
    , m_date(new QLineEdit)
    , m_create(new QPushButton(tr("&Start entering readings")))
{
    build();
}

void NewSwingPage::build()
{
    m_kind->setObjectName(QStringLiteral("newKind"));
    m_kind->addItems(choiceWords<SwingKind>());
    m_stage->setObjectName(QStringLiteral("newStage"));
    m_stage->addItems(choiceWords<SwingStage>());
    m_limits->setObjectName(QStringLiteral("newLimits"));
    m_limits->setToolTip(tr("What a new compass is held against. A known compass keeps its own: see the aircraft's page"));
    m_date->setObjectName(QStringLiteral("newDate"));
    messageLine().setObjectName(QStringLiteral("newComplaint"));
    setTitle(tr("New swing"));
    m_create->setObjectName(QStringLiteral("createSwing"));
    m_create->setAutoDefault(true);
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setAutoDefault(true);

    auto* form = new QFormLayout;
    form->addRow(tr("&Type:"), m_type);
    form->addRow(tr("&Aircraft:"), m_aircraft);
    form->addRow(tr("&Compass:"), m_compass);
    form->addRow(tr("&Limits:"), m_limits);
    form->addRow(tr("S&ite:"), m_site);
    form->addRow(tr("&Date (UTC):"), m_date);
    form->addRow(tr("&Kind:"), m_kind);
    form->addRow(tr("Sta&ge:"), m_stage);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_create);
    buttons->addWidget(cancel);
    buttons->addStretch();
    auto* inner = new QWidget;
    inner->setFixedWidth(kWidth);
    auto* column = new QVBoxLayout(inner);
    column->addLayout(form);
    column->addWidget(&messageLine()); // beside the button that it answers
    column->addLayout(buttons);
    body().addStretch(1);
    body().addWidget(inner, 0, Qt::AlignHCenter);
    body().addStretch(2);
    setFocusProxy(m_type);

    connect(m_type, &QComboBox::currentTextChanged, this, &NewSwingPage::loadAircraft);
    connect(m_aircraft, &QComboBox::currentTextChanged, this, &NewSwingPage::loadCompasses);
    connect(m_compass, &QComboBox::currentTextChanged, this, &NewSwingPage::updateLimits);
    for (QLineEdit* line : {m_type->lineEdit(), m_aircraft->lineEdit(), m_compass->lineEdit(), m_site->lineEdit(), m_date})
        connect(line, &QLineEdit::returnPressed, this, [this] { focusNextChild(); }); // Enter goes on, as in the table
    for (QComboBox* box : {m_limits, m_kind, m_stage})                                // on these, too
        new EnterGoesOn(*box);
    m_create->installEventFilter(this);
    connect(m_create, &QPushButton::clicked, this, &NewSwingPage::create);
    connect(cancel, &QPushButton::clicked, this, &NewSwingPage::cancelled);
}

/// Whoever types on the button means another aircraft than the one that stands in the form: it goes into that field, and makes no swing of
/// this one.
bool NewSwingPage::eventFilter(QObject* object, QEvent* event)
{
    if (object == m_create && event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        const QString text = key->text();
        if (!text.isEmpty() && text[0].isPrint() && !text[0].isSpace() && !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
            m_aircraft->setFocus();
            m_aircraft->lineEdit()->selectAll();
            QApplication::sendEvent(m_aircraft->lineEdit(), event);
            return true;
        }
    }
    return Page::eventFilter(object, event);
}

/// Where the compass is known already, Enter starts: the rest stands in the form and is changed only where it is otherwise.
void NewSwingPage::begin(AircraftId aircraft, CompassId compass)
{
    say({});
    m_date->setText(toText(m_context.stores.clock().today()));
    loadTypes();
    auto sites = m_context.stores.sites.sites();
    m_sites = sites ? std::move(sites.value()) : std::vector<Site>();
    fill(*m_site, m_sites, &Site::name);
    for (const Site& site : m_sites)
        if (m_usualSite && site.record == m_usualSite())
            m_site->setCurrentText(toText(site.name));
    loadLimits();
    preselect(aircraft, compass);
    setFocusProxy(typed(*m_compass).isEmpty() ? static_cast<QWidget*>(m_type) : m_create);
}

void NewSwingPage::loadLimits()
{
    auto profiles = m_context.stores.sites.limitsProfiles();
    m_profiles = profiles ? std::move(profiles.value()) : std::vector<LimitsProfile>();
    m_limits->clear();
    m_limits->addItem(tr("none set"));
    for (const LimitsProfile& profile : m_profiles)
        m_limits->addItem(toText(profile.name));
    updateLimits();
}

/// A known compass keeps its own, and shows them.
void NewSwingPage::updateLimits()
{
    const CompassRow* known = named(m_compasses, typed(*m_compass), &CompassRow::name);
    const bool ofAnother = known || !m_limits->isEnabled();
    m_limits->setEnabled(!known);
    const auto compass = known ? m_context.stores.fleet.compass(known->id) : Result<CompassSystem>(CompassSystem());
    int shown = 0;
    for (std::size_t i = 0; compass && i < m_profiles.size(); ++i)
        if (compass->limits.valid() && m_profiles[i].id == compass->limits)
            shown = static_cast<int>(i) + 1;
    if (ofAnother)
        m_limits->setCurrentIndex(shown);
}

void NewSwingPage::preselect(AircraftId aircraft, CompassId compass)
{
    const auto record = aircraft.valid() ? m_context.stores.fleet.aircraft(aircraft) : Result<Aircraft>(Error{});
    if (!record)
        return;
    for (const TypeRow& type : m_types)
        if (type.id == record->type)
            m_type->setCurrentText(toText(type.name));
    m_aircraft->setCurrentText(toText(record->registration));
    for (const CompassRow& row : m_compasses)
        if (row.id == compass || (!compass.valid() && m_compasses.size() == 1))
            m_compass->setCurrentText(toText(row.name));
}

void NewSwingPage::loadTypes()
{
    auto types = m_context.stores.fleet.types();
    m_types = types ? std::move(types.value()) : std::vector<TypeRow>();
    fill(*m_type, m_types, &TypeRow::name);
    loadAircraft();
}

void NewSwingPage::loadAircraft()
{
    m_aircraftRows.clear();
    if (const TypeRow* type = named(m_types, typed(*m_type), &TypeRow::name))
        if (auto rows = m_context.stores.fleet.aircraftOf(type->id); rows)
            m_aircraftRows = std::move(rows.value());
    fill(*m_aircraft, m_aircraftRows, &AircraftRow::registration);
    loadCompasses();
}

void NewSwingPage::loadCompasses()
{
    m_compasses.clear();
    if (const AircraftRow* aircraft = named(m_aircraftRows, typed(*m_aircraft), &AircraftRow::registration))
        if (auto rows = m_context.stores.fleet.compassesOf(aircraft->id); rows)
            m_compasses = std::move(rows.value());
    const QString kept = typed(*m_compass);
    fill(*m_compass, m_compasses, &CompassRow::name);
    if (m_compasses.empty())
        m_compass->setEditText(kept);
}

Result<AircraftTypeId> NewSwingPage::typeChosen()
{
    if (const TypeRow* row = named(m_types, typed(*m_type), &TypeRow::name))
        return row->id;
    AircraftType type;
    type.name = typed(*m_type).toStdString();
    return m_context.stores.fleet.add(type);
}

Result<AircraftId> NewSwingPage::aircraftChosen()
{
    if (const AircraftRow* row = named(m_aircraftRows, typed(*m_aircraft), &AircraftRow::registration))
        return row->id;
    const auto type = typeChosen();
    if (!type)
        return type.error();
    Aircraft aircraft;
    aircraft.type = *type;
    aircraft.registration = typed(*m_aircraft).toStdString();
    return m_context.stores.fleet.add(aircraft);
}

Result<CompassId> NewSwingPage::compassChosen(AircraftId aircraft)
{
    if (const CompassRow* row = named(m_compasses, typed(*m_compass), &CompassRow::name))
        return row->id;
    CompassSystem compass;
    compass.aircraft = aircraft;
    compass.name = typed(*m_compass).toStdString();
    if (m_limits->currentIndex() > 0)
        compass.limits = m_profiles[static_cast<std::size_t>(m_limits->currentIndex()) - 1].id;
    return m_context.stores.fleet.add(compass);
}

Result<SiteId> NewSwingPage::siteChosen()
{
    if (typed(*m_site).isEmpty())
        return SiteId();
    if (const Site* site = named(m_sites, typed(*m_site), &Site::name))
        return site->id;
    Site site;
    site.name = typed(*m_site).toStdString();
    return m_context.stores.sites.add(site);
}

Result<SwingId> NewSwingPage::store()
{
    Swing swing;
    const std::pair<QComboBox*, QString> needed[] = {{m_type, tr("Name the type of the aircraft.")},
        {m_aircraft, tr("Name the aircraft by its registration or tail number.")}, {m_compass, tr("Name the compass that is swung.")}};
    for (const auto& [box, message] : needed)
        if (typed(*box).isEmpty()) {
            box->setFocus();
            return missing(message);
        }
    auto date = parseDate(m_date->text(), false);
    if (!date) {
        m_date->setFocus();
        return date.error();
    }
    swing.date = std::move(date.value());
    const auto aircraft = aircraftChosen();
    if (!aircraft)
        return aircraft.error();
    const auto compass = compassChosen(*aircraft);
    if (!compass)
        return compass.error();
    const auto site = siteChosen();
    if (!site)
        return site.error();
    swing.compass = *compass;
    swing.site = *site;
    swing.kind = static_cast<SwingKind>(m_kind->currentIndex());
    swing.stage = static_cast<SwingStage>(m_stage->currentIndex());
    auto* edit = new MakeSwing(m_context, swing, MakeSwing::Direction::Make, tr("new swing"));
    const int before = m_stack.index();
    m_stack.push(edit); // deletes a refused edit
    if (m_stack.index() == before)
        return missing(tr("The swing was not stored."));
    return edit->swing();
}

void NewSwingPage::create()
{
    const auto stored = store();
    refuse(stored ? QString() : messageOf(stored.error()));
    if (stored)
        emit created(*stored);
}

} // namespace lubberline::ui
