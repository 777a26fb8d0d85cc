#include "ui/fleet/AircraftPage.h"

#include <QComboBox>
#include <QFormLayout>

#include <algorithm>

#include "ui/earth/FieldText.h"
#include "ui/kit/Words.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

Result<void> takeBuiltYear(Aircraft& aircraft, const QString& text)
{
    const auto year = parseYear(text);
    if (!year)
        return year.error();
    aircraft.builtYear = *year;
    return {};
}

Result<void> takeResolution(CompassSystem& compass, const QString& text)
{
    const auto resolution_deg = parsePositive_deg(text);
    if (!resolution_deg)
        return resolution_deg.error();
    compass.resolution_deg = *resolution_deg;
    compass.resolutionStated = true;
    return {};
}

/// A name by which a record is found cannot be empty.
template <class Record>
typename FormFields<Record>::Take takeName(std::string Record::*member, const QString& message)
{
    return [member, message](Record& record, const QString& text) -> Result<void> {
        if (text.trimmed().isEmpty())
            return Error{ErrorCode::InvalidInput, said(message)};
        record.*member = text.trimmed().toStdString();
        return {};
    };
}

template <class Record>
void addText(FormFields<Record>& fields, QFormLayout& form, const QString& title, const QString& name, std::string Record::*member)
{
    fields.addLine(
        form, title, name, [member](const Record& record) { return toText(record.*member); }, takeText(member));
}

} // namespace

QWidget* AircraftPage::buildAircraftForm()
{
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    m_aircraft.addLine(
        *form, tr("Registration:"), QStringLiteral("aircraftRegistration"),
        [](const Aircraft& record) { return toText(record.registration); },
        takeName(&Aircraft::registration, tr("an aircraft must have a registration or tail number")));
    addText(m_aircraft, *form, tr("Serial number:"), QStringLiteral("aircraftSerial"), &Aircraft::serialNumber);
    addText(m_aircraft, *form, tr("Operator:"), QStringLiteral("aircraftOperator"), &Aircraft::operatorName);
    m_aircraft.addLine(
        *form, tr("Built:"), QStringLiteral("aircraftBuilt"),
        [](const Aircraft& record) { return record.builtYear ? QString::number(*record.builtYear) : QString(); }, takeBuiltYear);
    m_aircraft
        .addLine(
            *form, tr("Based at:"), QStringLiteral("aircraftBase"), [this](const Aircraft& record) { return siteName(record.base); },
            [this](Aircraft& record, const QString& text) -> Result<void> {
                const auto site = siteNamed(text.trimmed());
                if (!site)
                    return site.error();
                record.base = *site;
                return {};
            })
        ->setToolTip(tr(
            "A compass base of this database: where another is, the swing is due when the compass is predicted to leave its limits there"));
    addText(m_aircraft, *form, tr("Note:"), QStringLiteral("aircraftNote"), &Aircraft::note);
    return page;
}

QWidget* AircraftPage::buildCompassForm()
{
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    m_compassChoice = new QComboBox;
    m_compassChoice->setObjectName(QStringLiteral("compassChoice"));
    form->addRow(tr("Show:"), m_compassChoice);
    connect(m_compassChoice, &QComboBox::activated, this, [this](int choice) { chooseCompass(choice); });
    m_compass.addLine(
        *form, tr("Name:"), QStringLiteral("compassName"), [](const CompassSystem& record) { return toText(record.name); },
        takeName(&CompassSystem::name, tr("a compass must have a name, as “standby compass”")));
    m_compass.addChoice(
        *form, tr("Kind:"), QStringLiteral("compassKind"), choiceWords<CompassKind>(),
        [](const CompassSystem& record) { return static_cast<int>(record.kind); },
        [](CompassSystem& record, int choice) { record.kind = static_cast<CompassKind>(choice); });
    m_compass.addChoice(
        *form, tr("Compensator:"), QStringLiteral("compassCompensator"), choiceWords<Compensator>(),
        [](const CompassSystem& record) { return static_cast<int>(record.compensator); },
        [](CompassSystem& record, int choice) { record.compensator = static_cast<Compensator>(choice); });
    const auto shownLimits = [this](const CompassSystem& record) {
        const auto found = std::find_if(
            m_profiles.begin(), m_profiles.end(), [&record](const LimitsProfile& profile) { return profile.id == record.limits; });
        return found == m_profiles.end() ? 0 : static_cast<int>(found - m_profiles.begin()) + 1;
    };
    m_limits = m_compass.addChoice(
        *form, tr("Limits:"), QStringLiteral("compassLimits"), {tr("none set")}, shownLimits, [this](CompassSystem& record, int choice) {
            record.limits = choice > 0 ? m_profiles[static_cast<std::size_t>(choice) - 1].id : LimitsProfileId();
        });
    m_compass.addLine(
        *form, tr("Resolution (°):"), QStringLiteral("compassResolution"),
        [](const CompassSystem& record) { return numberText(record.resolution_deg); }, takeResolution);
    addText(m_compass, *form, tr("Maker:"), QStringLiteral("compassMaker"), &CompassSystem::maker);
    addText(m_compass, *form, tr("Part number:"), QStringLiteral("compassPart"), &CompassSystem::partNumber);
    addText(m_compass, *form, tr("Serial number:"), QStringLiteral("compassSerial"), &CompassSystem::serialNumber);
    m_compass.addLine(
        *form, tr("Installed on:"), QStringLiteral("compassInstalled"),
        [](const CompassSystem& record) { return toText(record.installed); },
        [](CompassSystem& record, const QString& text) -> Result<void> {
            const auto date = parseDate(text, true);
            if (!date)
                return date.error();
            record.installed = *date;
            return {};
        });
    addText(m_compass, *form, tr("Location:"), QStringLiteral("compassLocation"), &CompassSystem::location);
    return page;
}

QString AircraftPage::siteName(SiteId id) const
{
    const auto sites = m_context.stores.sites.sites();
    for (const Site& site : sites ? *sites : std::vector<Site>())
        if (site.id == id)
            return toText(site.name);
    return {};
}

/// Not valid for no name at all.
Result<SiteId> AircraftPage::siteNamed(const QString& name) const
{
    if (name.isEmpty())
        return SiteId();
    const auto sites = m_context.stores.sites.sites();
    if (!sites)
        return sites.error();
    QStringList known;
    for (const Site& site : *sites) {
        if (toText(site.name) == name)
            return site.id;
        known += toText(site.name);
    }
    return Error{
        ErrorCode::InvalidInput, said(tr("there is no compass base %1; expected one of: %2").arg(name, known.join(QStringLiteral(", "))))};
}

} // namespace lubberline::ui
