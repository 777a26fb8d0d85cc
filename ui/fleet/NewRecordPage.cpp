#include "ui/fleet/NewRecordPage.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/fleet/FleetEdits.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kNewRecordWidth = 480;

QString titleFor(NewRecordPage::Kind kind)
{
    switch (kind) {
    case NewRecordPage::Kind::Type: return NewRecordPage::tr("New type of aircraft");
    case NewRecordPage::Kind::Aircraft: return NewRecordPage::tr("New aircraft");
    case NewRecordPage::Kind::Compass: return NewRecordPage::tr("New compass");
    }
    return {};
}

} // namespace

NewRecordPage::NewRecordPage(PageContext& context, Kind kind, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_kind(kind)
    , m_owner(new QComboBox)
    , m_limits(new QComboBox)
    , m_name(new QLineEdit)
    , m_maker(new QLineEdit)
{
    setTitle(titleFor(kind));
    m_owner->setObjectName(QStringLiteral("newRecordOwner"));
    m_limits->setObjectName(QStringLiteral("newRecordLimits"));
    m_name->setObjectName(QStringLiteral("newRecordName"));
    m_maker->setObjectName(QStringLiteral("newRecordMaker"));
    auto* inner = new QWidget;
    inner->setMaximumWidth(kNewRecordWidth);
    auto* column = new QVBoxLayout(inner);
    auto* form = new QFormLayout;
    build(*form);
    column->addLayout(form);
    column->addWidget(&messageLine());
    auto* create = new QPushButton(tr("&Make it"));
    create->setObjectName(QStringLiteral("makeRecord"));
    create->setAutoDefault(true);
    auto* cancel = new QPushButton(tr("Cancel"));
    cancel->setAutoDefault(true);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(create);
    buttons->addWidget(cancel);
    buttons->addStretch();
    column->addLayout(buttons);
    body().addStretch(1);
    body().addWidget(inner, 0, Qt::AlignHCenter);
    body().addStretch(2);
    setFocusProxy(m_name);
    connect(create, &QPushButton::clicked, this, &NewRecordPage::make);
    connect(m_name, &QLineEdit::returnPressed, this, &NewRecordPage::make);
    connect(cancel, &QPushButton::clicked, this, [this] { m_context.go({}); });
}

void NewRecordPage::build(QFormLayout& form)
{
    if (m_kind == Kind::Type) {
        form.addRow(tr("&Name:"), m_name);
        form.addRow(tr("Ma&ker:"), m_maker);
        m_name->setPlaceholderText(tr("as Su-22"));
        delete std::exchange(m_owner, nullptr);
        delete std::exchange(m_limits, nullptr);
        return;
    }
    if (m_kind == Kind::Aircraft) {
        form.addRow(tr("&Type:"), m_owner);
        form.addRow(tr("&Registration:"), m_name);
        m_name->setPlaceholderText(tr("registration or tail number"));
        delete std::exchange(m_limits, nullptr);
    } else {
        form.addRow(tr("&Aircraft:"), m_owner);
        form.addRow(tr("&Name:"), m_name);
        form.addRow(tr("&Limits:"), m_limits);
        m_name->setPlaceholderText(tr("as standby compass"));
    }
    delete std::exchange(m_maker, nullptr);
}

/// The one that is shown in the window is chosen already.
void NewRecordPage::fill(const FleetItem& shown)
{
    if (!m_owner)
        return;
    m_owner->clear();
    m_owners.clear();
    const auto types = m_context.stores.fleet.types();
    if (!types)
        return;
    const auto add = [this](std::int64_t id, const QString& text, bool chosen) {
        m_owners.push_back(id);
        m_owner->addItem(text);
        if (chosen)
            m_owner->setCurrentIndex(m_owner->count() - 1);
    };
    for (const TypeRow& type : *types) {
        if (m_kind == Kind::Aircraft) {
            add(type.id.value, toText(type.name), shown == FleetItem(type.id));
            continue;
        }
        if (const auto aircraft = m_context.stores.fleet.aircraftOf(type.id); aircraft)
            for (const AircraftRow& one : *aircraft)
                add(one.id.value, toText(one.registration) + QStringLiteral(" · ") + toText(type.name), shown == FleetItem(one.id));
    }
    if (m_limits) {
        auto profiles = m_context.stores.sites.limitsProfiles();
        m_profiles = profiles ? std::move(profiles.value()) : std::vector<LimitsProfile>();
        m_limits->clear();
        m_limits->addItem(tr("none set"));
        for (const LimitsProfile& profile : m_profiles)
            m_limits->addItem(toText(profile.name));
    }
}

Result<void> NewRecordPage::open(const FleetItem& record)
{
    fill(record);
    return {};
}

template <class RecordKey, class Record>
void NewRecordPage::store(Record record, const QString& text)
{
    auto* edit = new MakeFleetRecord<Record, RecordKey>(m_context.edits, std::move(record), text);
    const int before = m_context.undo.index();
    m_context.undo.push(edit); // deletes a refused edit
    if (m_context.undo.index() > before)
        m_context.go({{}, edit->made()});
}

void NewRecordPage::make()
{
    const std::string name = m_name->text().trimmed().toStdString();
    if (name.empty()) {
        m_name->setFocus();
        refuse(m_kind == Kind::Aircraft ? tr("Name the aircraft by its registration or tail number.") : tr("A name is expected."));
        return;
    }
    if (m_owner && m_owner->currentIndex() < 0) {
        refuse(m_kind == Kind::Aircraft ? tr("There is no type of aircraft yet: make one first (menu Fleet, New type)")
                                        : tr("There is no aircraft yet: make one first (menu Fleet, New aircraft)"));
        return;
    }
    const std::int64_t owner = m_owner ? m_owners[static_cast<std::size_t>(m_owner->currentIndex())] : 0;
    if (m_kind == Kind::Type) {
        AircraftType type;
        type.name = name;
        type.maker = m_maker->text().trimmed().toStdString();
        store<AircraftTypeId>(type, tr("new type %1").arg(toText(name)));
    } else if (m_kind == Kind::Aircraft) {
        Aircraft aircraft;
        aircraft.type = {owner};
        aircraft.registration = name;
        store<AircraftId>(aircraft, tr("new aircraft %1").arg(toText(name)));
    } else {
        CompassSystem compass;
        compass.aircraft = {owner};
        compass.name = name;
        if (m_limits->currentIndex() > 0)
            compass.limits = m_profiles[static_cast<std::size_t>(m_limits->currentIndex()) - 1].id;
        store<CompassId>(compass, tr("new compass %1").arg(toText(name)));
    }
}

PageDescription NewRecordPage::description(PageContext& context, Kind kind)
{
    const std::pair<const char*, QString> names[]
        = {{"newType", tr("New &type…")}, {"newAircraft", tr("New &aircraft…")}, {"newCompass", tr("New &compass…")}};
    const auto& [id, text] = names[static_cast<int>(kind)];
    PageDescription page{QLatin1String(id), [&context, kind] { return new NewRecordPage(context, kind); }};
    page.commands = {{MenuId::Fleet, 10 + static_cast<int>(kind), text, {}, QLatin1String(id),
        [&context, name = QString(QLatin1String(id)), kind](Page& front) {
            const Shown shown = front.shown();
            context.go({name, kind == Kind::Aircraft ? FleetItem(shown.type) : FleetItem(shown.aircraft), true});
        },
        needsWriting}};
    page.help = tr(
        "Asks for what a new type, aircraft or compass must have; all else is filled in on its own page afterwards. It can be undone with Ctrl+Z.");
    if (kind == Kind::Type)
        for (const Command& removal : removalCommands(context))
            page.commands.push_back(removal);
    return page;
}

namespace {

/// Undone it is back with all that was its.
template <class RecordKey>
void removeWhole(PageContext& context, RecordKey id, const QString& name, const FleetItem& next)
{
    context.leaveField();
    const int before = context.undo.index();
    context.undo.push(new RemoveFleetRecord<RecordKey>(context.edits, id, next, NewRecordPage::tr("removal of %1").arg(name)));
    if (context.undo.index() == before)
        return;
    context.go({{}, next});
    context.say(NewRecordPage::tr("%1 was removed, with all that belongs to it. Ctrl+Z puts it back.").arg(name));
}

} // namespace

std::vector<Command> removalCommands(PageContext& context)
{
    return {{MenuId::Fleet, 20, NewRecordPage::tr("Remove this t&ype"), {}, "removeType",
                [&context](Page& front) {
                    const AircraftTypeId id = front.shown().type;
                    if (const auto type = context.stores.fleet.type(id); type)
                        removeWhole(context, id, toText(type->name), {});
                },
                needsType},
        {MenuId::Fleet, 21, NewRecordPage::tr("Remove this a&ircraft"), {}, "removeAircraft",
            [&context](Page& front) {
                const AircraftId id = front.shown().aircraft;
                if (const auto aircraft = context.stores.fleet.aircraft(id); aircraft)
                    removeWhole(context, id, toText(aircraft->registration), aircraft->type);
            },
            needsAircraftToChange},
        {MenuId::Fleet, 22, NewRecordPage::tr("Remove this compa&ss"), {}, "removeCompass",
            [&context](Page& front) {
                const CompassId id = front.shown().compass;
                if (const auto compass = context.stores.fleet.compass(id); compass)
                    removeWhole(context, id, toText(compass->name), compass->aircraft);
            },
            needsCompassToChange}};
}

} // namespace lubberline::ui
