#include "ui/swing/SwingParticulars.h"

#include <QHBoxLayout>

#include <algorithm>

#include "core/angle/AngleText.h"
#include "ui/earth/FieldText.h"
#include "ui/kit/Words.h"
#include "ui/swing/SwingEditor.h"

namespace lubberline::ui {

namespace {

using Fields = FormFields<Swing>;

/// A text inside one of the swing's parts: configuration.engines.
template <class Part>
void addPartLine(Fields& fields, QFormLayout& form, const QString& title, const QString& name, Part Swing::*part, std::string Part::*member)
{
    fields.addLine(
        form, title, name, [part, member](const Swing& swing) { return toText(swing.*part.*member); },
        [part, member](Swing& swing, const QString& text) {
            swing.*part.*member = text.trimmed().toStdString();
            return Result<void>();
        });
}

void addTextLine(Fields& fields, QFormLayout& form, const QString& title, const QString& name, std::string Swing::*member)
{
    fields.addLine(
        form, title, name, [member](const Swing& swing) { return toText(swing.*member); }, takeText(member));
}

Result<void> takeDate(Swing& swing, const QString& text)
{
    auto date = parseDate(text, false);
    if (!date)
        return date.error();
    swing.date = std::move(date.value());
    return {};
}

Result<void> takeVariation(Swing& swing, const QString& text)
{
    const auto variation_deg = parseOptionalAngle_deg(text);
    if (!variation_deg)
        return variation_deg.error();
    swing.variation_deg = *variation_deg;
    return {};
}

Result<void> takeSharedErrors(Swing& swing, const QString& text)
{
    const auto errors = readSharedErrors(text.toStdString());
    if (!errors)
        return errors.error();
    swing.sharedErrors = *errors;
    return {};
}

Result<void> takeCalibrationDue(Swing& swing, const QString& text)
{
    auto date = parseDate(text, true);
    if (!date)
        return date.error();
    swing.datum.calibrationDue = std::move(date.value());
    return {};
}

QString variationText(const Swing& swing)
{
    return swing.variation_deg ? toText(formatSignedAngle(*swing.variation_deg, AngleStyle::DecimalDegrees, 2)) : QString();
}

} // namespace

SwingParticulars::SwingParticulars(SwingEditor& editor, QWidget* parent)
    : QWidget(parent)
    , m_editor(editor)
    , m_fields([this](const Swing& after, const QString& field) { m_editor.changeParticulars(after, field); })
{
    setObjectName(QStringLiteral("swingParticulars"));
    auto* columns = new QHBoxLayout(this);
    columns->setContentsMargins(0, 0, 0, 0);
    for (const auto build : {&SwingParticulars::buildOccasion, &SwingParticulars::buildConfiguration, &SwingParticulars::buildPeople}) {
        auto* form = new QFormLayout;
        form->setVerticalSpacing(3);
        columns->addLayout(form, 1);
        (this->*build)(*form);
    }
    connect(&editor, &SwingEditor::opened, this, &SwingParticulars::showRecord);
    connect(&editor, &SwingEditor::changed, this, &SwingParticulars::showRecord);
    connect(&editor.stores().changes(), &db::Changes::fleetChanged, this, &SwingParticulars::showRecord);
    showRecord();
}

void SwingParticulars::buildOccasion(QFormLayout& form)
{
    m_fields
        .addLine(
            form, tr("Date:"), QStringLiteral("swingDate"), [](const Swing& swing) { return toText(swing.date); }, takeDate)
        ->setPlaceholderText(tr("year-month-day, UTC"));
    m_fields.addChoice(
        form, tr("Kind:"), QStringLiteral("swingKind"), choiceWords<SwingKind>(),
        [](const Swing& swing) { return static_cast<int>(swing.kind); },
        [](Swing& swing, int choice) { swing.kind = static_cast<SwingKind>(choice); });
    m_fields.addChoice(
        form, tr("Stage:"), QStringLiteral("swingStage"), choiceWords<SwingStage>(),
        [](const Swing& swing) { return static_cast<int>(swing.stage); },
        [](Swing& swing, int choice) { swing.stage = static_cast<SwingStage>(choice); });
    const auto shownSite = [this](const Swing& swing) {
        for (std::size_t i = 0; i < m_sites.size(); ++i)
            if (m_sites[i].id == swing.site)
                return static_cast<int>(i) + 1;
        return 0;
    };
    m_site = m_fields.addChoice(form, tr("Site:"), QStringLiteral("swingSite"), {tr("not stated")}, shownSite,
        [this](Swing& swing, int choice) { swing.site = choice > 0 ? m_sites[static_cast<std::size_t>(choice) - 1].id : SiteId(); });
    m_fields.addLine(form, tr("Variation:"), QStringLiteral("swingVariation"), variationText, takeVariation)
        ->setPlaceholderText(tr("as 3.5E"));
    QLineEdit* shared = m_fields.addLine(
        form, tr("Shared error:"), QStringLiteral("swingSharedError"),
        [](const Swing& swing) { return toText(textOf(swing.sharedErrors)); }, takeSharedErrors);
    shared->setPlaceholderText(tr("as 0.5"));
    shared->setToolTip(
        tr("Standard errors that all readings share and no scatter shows, in degrees: of the datum, the variation, a log's delay and wind. "
           "One figure is A's; else letters, as in A 0.6 B 0.2. They widen what is said of the coefficients"));
}

void SwingParticulars::buildConfiguration(QFormLayout& form)
{
    m_fields.addChoice(
        form, tr("Radio:"), QStringLiteral("swingRadio"), choiceWords<RadioState>(),
        [](const Swing& swing) { return static_cast<int>(swing.configuration.radio); },
        [](Swing& swing, int choice) { swing.configuration.radio = static_cast<RadioState>(choice); });
    addPartLine(m_fields, form, tr("Engines:"), QStringLiteral("swingEngines"), &Swing::configuration, &Configuration::engines);
    addPartLine(m_fields, form, tr("Electrics:"), QStringLiteral("swingElectrics"), &Swing::configuration, &Configuration::electrics);
    addPartLine(m_fields, form, tr("Other:"), QStringLiteral("swingOther"), &Swing::configuration, &Configuration::other);
    addTextLine(m_fields, form, tr("Reason:"), QStringLiteral("swingReason"), &Swing::reason);
    addTextLine(m_fields, form, tr("Note:"), QStringLiteral("swingNote"), &Swing::note);
}

void SwingParticulars::buildPeople(QFormLayout& form)
{
    addPartLine(m_fields, form, tr("Datum:"), QStringLiteral("swingDatum"), &Swing::datum, &Datum::instrument);
    addPartLine(m_fields, form, tr("Datum s/n:"), QStringLiteral("swingDatumSerial"), &Swing::datum, &Datum::serialNumber);
    m_fields.addLine(
        form, tr("Calibration due:"), QStringLiteral("swingDatumDue"),
        [](const Swing& swing) { return toText(swing.datum.calibrationDue); }, takeCalibrationDue);
    addPartLine(m_fields, form, tr("Datum read by:"), QStringLiteral("swingDatumReader"), &Swing::people, &People::datumReader);
    addPartLine(m_fields, form, tr("Compass read by:"), QStringLiteral("swingCockpitReader"), &Swing::people, &People::cockpitReader);
    addPartLine(m_fields, form, tr("Adjuster:"), QStringLiteral("swingAdjuster"), &Swing::people, &People::adjuster);
    addPartLine(m_fields, form, tr("Inspector:"), QStringLiteral("swingInspector"), &Swing::people, &People::inspector);
}

void SwingParticulars::reloadSites()
{
    auto sites = m_editor.stores().sites.sites();
    m_sites = sites ? std::move(sites.value()) : std::vector<Site>();
    m_site->clear();
    m_site->addItem(tr("not stated"));
    for (const Site& site : m_sites)
        m_site->addItem(toText(site.name));
}

void SwingParticulars::showRecord()
{
    const SwingRecord& record = m_editor.record();
    const bool known = !record.swing.site.valid()
        || std::any_of(m_sites.begin(), m_sites.end(), [&record](const Site& site) { return site.id == record.swing.site; });
    if (m_sites.empty() || !known || sender() == &m_editor.stores().changes())
        reloadSites();
    m_fields.show(record.swing, m_editor.particularsEditable());
}

} // namespace lubberline::ui
