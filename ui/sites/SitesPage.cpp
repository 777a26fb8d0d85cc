#include "ui/sites/SitesPage.h"

#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>

#include <cmath>

#include "core/record/DefaultNames.h"
#include "core/site/SiteSurvey.h"
#include "core/swing/SwingField.h"
#include "ui/earth/FieldText.h"
#include "ui/kit/OpenCell.h"
#include "ui/kit/PlaceText.h"
#include "ui/kit/StoredEdit.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/sites/PasteTable.h"
#include "ui/sites/SurveyDrawing.h"
#include "ui/text/AngleWords.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

QString optionalFigure(std::optional<double> value) { return value ? QString::number(*value, 'g', 8) : QString(); }

namespace {

FormFields<Site>::Take takeDate(Date Site::*member)
{
    return [member](Site& site, const QString& text) -> Result<void> {
        const auto date = parseDate(text, true);
        if (!date)
            return date.error();
        site.*member = *date;
        return {};
    };
}

FormFields<Site>::Take takeAngle(std::optional<double> Site::*member, Result<double> (*parse)(const QString&))
{
    return [member, parse](Site& site, const QString& text) -> Result<void> {
        if (text.trimmed().isEmpty()) {
            (site.*member).reset();
            return {};
        }
        const auto angle = parse(text);
        if (!angle)
            return angle.error();
        site.*member = *angle;
        return {};
    };
}

FormFields<Site>::Take takeVariation(std::optional<double> Site::*member)
{
    return [member](Site& site, const QString& text) -> Result<void> {
        const auto angle = parseOptionalAngle_deg(text);
        if (!angle)
            return angle.error();
        site.*member = *angle;
        return {};
    };
}

} // namespace

SitesPage::SitesPage(EditContext& context, QUndoStack& stack, std::function<Date()> today, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_stack(stack)
    , m_today(std::move(today))
    , m_fields([this](const Site& after, const QString& field) { store(after, field); })
    , m_list(new QListWidget)
    , m_add(new QPushButton(tr("&New base")))
    , m_remove(new QPushButton(tr("&Remove this base")))
    , m_model(new QPushButton(tr("Variation from the &model, today")))
    , m_fitness(new QLabel)
    , m_lines(new QLabel)
    , m_summary(new QLabel)
    , m_table(new PasteTable)
    , m_drawing(new SurveyDrawing)
{
    build();
}

void SitesPage::build()
{
    m_list->setObjectName(QStringLiteral("siteList"));
    m_add->setObjectName(QStringLiteral("newSite"));
    m_remove->setObjectName(QStringLiteral("removeSite"));
    m_model->setObjectName(QStringLiteral("siteModel"));
    m_fitness->setObjectName(QStringLiteral("siteFitness"));
    m_lines->setObjectName(QStringLiteral("siteLines"));
    m_summary->setObjectName(QStringLiteral("surveySummary"));
    for (QLabel* label : {m_fitness, m_lines, m_summary})
        label->setWordWrap(true);
    auto* form = new QFormLayout;
    buildForm(*form);
    auto* particulars = new QWidget;
    auto* left = new QVBoxLayout(particulars);
    left->addLayout(form);
    left->addWidget(m_model, 0, Qt::AlignLeft);
    left->addWidget(m_fitness);
    left->addWidget(m_lines);
    left->addStretch();
    auto* survey = new QWidget;
    auto* right = new QVBoxLayout(survey);
    right->addWidget(m_table, 1);
    right->addWidget(m_summary);
    right->addWidget(m_drawing, 2);
    auto* chooser = new QWidget;
    auto* list = new QVBoxLayout(chooser);
    list->addWidget(m_list);
    list->addWidget(m_add);
    list->addWidget(m_remove);
    auto* splitter = new SideBySide;
    splitter->addWidget(chooser);
    splitter->addWidget(new SidePanel(particulars));
    splitter->addWidget(survey);
    splitter->setSizes({160, 380, 460});
    setTitle(tr("Compass bases"));
    body().addWidget(splitter, 1);
    setFocusProxy(m_list);
    connect(m_list, &QListWidget::currentRowChanged, this, &SitesPage::choose);
    connect(m_add, &QPushButton::clicked, this, &SitesPage::addSite);
    connect(m_remove, &QPushButton::clicked, this, &SitesPage::removeSite);
    connect(m_model, &QPushButton::clicked, this, &SitesPage::takeModelVariation);
    buildSurvey();
    connect(&m_context.stores.changes(), &db::Changes::sitesChanged, this, [this] {
        if (isVisible())
            reload();
    });
}

void SitesPage::buildForm(QFormLayout& form)
{
    const auto text = [&](const QString& title, const char* name, std::string Site::*member) {
        m_fields.addLine(
            form, title, QString::fromLatin1(name), [member](const Site& site) { return toText(site.*member); }, takeText(member));
    };
    m_fields.addLine(
        form, tr("Name:"), QStringLiteral("siteName"), [](const Site& site) { return toText(site.name); },
        [](Site& site, const QString& name) -> Result<void> {
            if (name.trimmed().isEmpty())
                return Error{ErrorCode::InvalidInput, said(tr("a base must have a name"))};
            site.name = name.trimmed().toStdString();
            return {};
        });
    text(tr("Owner:"), "siteOwner", &Site::owner);
    m_fields.addLine(
        form, tr("Latitude:"), QStringLiteral("siteLatitude"),
        [](const Site& site) { return site.latitude_deg ? latitudeToType(*site.latitude_deg) : QString(); },
        takeAngle(&Site::latitude_deg, parseLatitude_deg));
    m_fields.addLine(
        form, tr("Longitude:"), QStringLiteral("siteLongitude"),
        [](const Site& site) { return site.longitude_deg ? longitudeToType(*site.longitude_deg) : QString(); },
        takeAngle(&Site::longitude_deg, [](const QString& typed) -> Result<double> {
            const auto angle = parseLongitude_deg(typed);
            return angle ? Result<double>(wrap180(*angle)) : angle;
        }));
    m_fields.addLine(
        form, tr("Elevation (m):"), QStringLiteral("siteElevation"), [](const Site& site) { return optionalFigure(site.elevation_m); },
        takeAngle(&Site::elevation_m, parseHeight_m));
    m_fields.addLine(
        form, tr("Variation (°, E +):"), QStringLiteral("siteVariation"),
        [](const Site& site) { return optionalFigure(site.variation_deg); }, takeVariation(&Site::variation_deg));
    text(tr("Variation by:"), "siteVariationSource", &Site::variationSource);
    QStringList classes{tr("none")};
    for (const ClassRule& rule : classRules())
        classes
            += tr("class %1: within %2° (%3)").arg(static_cast<int>(rule.siteClass)).arg(rule.permissible_deg).arg(toText(rule.document));
    m_fields.addChoice(
        form, tr("Class:"), QStringLiteral("siteClass"), classes, [](const Site& site) { return static_cast<int>(site.siteClass); },
        [](Site& site, int choice) { site.siteClass = static_cast<SiteClass>(choice); });
    text(tr("Certificate:"), "siteCertificate", &Site::certificate);
    m_fields.addLine(
        form, tr("Valid to:"), QStringLiteral("siteExpiry"), [](const Site& site) { return toText(site.certificateExpiry); },
        takeDate(&Site::certificateExpiry));
    m_fields.addLine(
        form, tr("Lines painted with (°, E +):"), QStringLiteral("sitePainted"),
        [](const Site& site) { return optionalFigure(site.paintedVariation_deg); }, takeVariation(&Site::paintedVariation_deg));
    m_fields.addLine(
        form, tr("Painted on:"), QStringLiteral("sitePaintedDate"), [](const Site& site) { return toText(site.paintedDate); },
        takeDate(&Site::paintedDate));
    m_fields.addLine(
        form, tr("Surveyed on:"), QStringLiteral("siteSurveyDate"), [](const Site& site) { return toText(site.surveyDate); },
        takeDate(&Site::surveyDate));
    text(tr("Surveyed by:"), "siteSurveyor", &Site::surveyor);
    text(tr("Surveyed with:"), "siteSurveyInstrument", &Site::surveyInstrument);
    text(tr("Note:"), "siteNote", &Site::note);
}

void SitesPage::reload()
{
    say({}); // of what was done before
    auto sites = m_context.stores.sites.sites();
    if (!sites) {
        emit failed(messageOf(sites.error()));
        return;
    }
    const RecordId kept = m_fields.record().record;
    m_sites = std::move(sites.value());
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    int row = 0;
    for (std::size_t i = 0; i < m_sites.size(); ++i) {
        m_list->addItem(toText(m_sites[i].name));
        if (m_sites[i].record == kept)
            row = static_cast<int>(i);
    }
    if (m_sites.empty() || m_sites[static_cast<std::size_t>(row)].record != kept)
        closeCell(*m_table); // what is typed there is of a base that is gone
    m_list->setCurrentRow(row);
    m_add->setEnabled(!m_context.stores.readOnly());
    showSite();
}

/// What was typed last into the survey is of the base that is left, and stored with that.
void SitesPage::choose(int row)
{
    const RecordId wanted = row >= 0 && row < static_cast<int>(m_sites.size()) ? m_sites[static_cast<std::size_t>(row)].record : RecordId();
    takeSurvey();
    for (std::size_t i = 0; i < m_sites.size(); ++i)
        if (m_sites[i].record == wanted) {
            const QSignalBlocker quiet(m_list);
            m_list->setCurrentRow(static_cast<int>(i));
        }
    showSite();
}

void SitesPage::showSite()
{
    const int row = m_list->currentRow();
    const bool there = row >= 0 && row < static_cast<int>(m_sites.size());
    const bool editable = there && !m_context.stores.readOnly();
    m_fields.show(there ? m_sites[static_cast<std::size_t>(row)] : Site(), editable);
    m_remove->setEnabled(editable);
    emit stateChanged();
    m_model->setEnabled(editable && variationToday().has_value());
    m_table->setEnabled(editable);
    showSurvey();
    showFitness();
}

std::optional<double> SitesPage::variationToday() const
{
    Swing today;
    today.date = m_today();
    const auto stamp = stampFor(today, m_fields.record());
    return stamp ? std::optional(stamp->field.variation().degrees()) : std::nullopt;
}

void SitesPage::showFitness()
{
    const Site& site = m_fields.record();
    const Message why = whyUnfit({site.certificateExpiry, site.siteClass, SiteClass::None}, m_today());
    m_fitness->setText(why.empty() ? tr("● may be used today") : tr("▲ not to be used today: %1").arg(toText(why)));
    QString lines;
    if (const auto today = variationToday(); site.paintedVariation_deg && today) {
        const double offset = paintedLineOffset_deg(Variation::fromDegrees(*site.paintedVariation_deg), Variation::fromDegrees(*today));
        lines = tr("Painted lines: the variation is %1° today, so that %2° is to be added to what a line says.")
                    .arg(signedNumber(*today, 2), signedNumber(offset, 2));
    }
    Swing today;
    today.date = m_today();
    if (const Message doubt = variationDisagreement(site, stampFor(today, site)); !doubt.empty())
        lines += (lines.isEmpty() ? QString() : QStringLiteral("\n")) + QStringLiteral("▲ ") + toText(doubt);
    m_lines->setText(inAngleStyle(lines));
}

namespace {

/// A base that was removed and made again has another id: found by its RecordId.
Result<Site> asStored(db::Stores& stores, Site site)
{
    const auto sites = stores.sites.sites();
    if (!sites)
        return sites.error();
    const auto found = std::find_if(sites->begin(), sites->end(), [&](const Site& one) { return one.record == site.record; });
    if (found == sites->end())
        return Error{ErrorCode::NotFound, {MARKED("ui", "there is no base %1 any more"), site.name}};
    site.id = found->id;
    return site;
}

const StoredBy<Site>& storedSites()
{
    static const StoredBy<Site> by{[](db::Stores& stores, const Site& site) { return noValue(stores.sites.add(site)); },
        [](db::Stores& stores, const Site& known, const Site& wanted) -> Result<void> {
            const auto before = asStored(stores, known), after = asStored(stores, wanted);
            return before && after ? stores.sites.change(*before, *after) : Result<void>(before ? after.error() : before.error());
        },
        [](db::Stores& stores, const Site& site) { return stores.sites.removeSite(site.record); }};
    return by;
}

} // namespace

void SitesPage::store(const Site& after, const QString& what)
{
    m_stack.push(new StoredEdit(m_context, storedSites(), std::optional(m_fields.record()), std::optional(after),
        tr("%1 of %2").arg(what, toText(after.name)), Destination{QStringLiteral("sites")}));
    reload();
}

void SitesPage::addSite()
{
    Site site;
    site.name = freeName(kNewBase, m_sites, [](const Site& one) { return one.name; });
    site.record = newRecordId();
    m_fields.show(site, true);
    m_stack.push(new StoredEdit(
        m_context, storedSites(), std::optional<Site>(), std::optional(site), tr("new base"), Destination{QStringLiteral("sites")}));
    reload();
    if (m_fields.record().record != site.record)
        return; // refused
    findChild<QLineEdit*>(QStringLiteral("siteName"))->setFocus();
    findChild<QLineEdit*>(QStringLiteral("siteName"))->selectAll();
}

void SitesPage::removeSite()
{
    const Site site = m_fields.record();
    if (site.record.empty())
        return;
    m_stack.push(new StoredEdit(m_context, storedSites(), std::optional(site), std::optional<Site>(),
        tr("removal of %1").arg(toText(site.name)), Destination{QStringLiteral("sites")}));
    reload();
}

void SitesPage::takeModelVariation()
{
    Site after = m_fields.record();
    Swing today;
    today.date = m_today();
    const auto stamp = stampFor(today, after);
    if (!stamp)
        return;
    after.variation_deg = std::round(stamp->field.variation().degrees() * 100) / 100;
    after.variationSource = stamp->model + ", " + stamp->date.text();
    store(after, tr("variation"));
}

} // namespace lubberline::ui
