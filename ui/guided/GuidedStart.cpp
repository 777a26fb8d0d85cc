#include "ui/guided/GuidedStart.h"

#include <QComboBox>
#include <QFormLayout>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QVBoxLayout>

#include <cmath>

#include "core/procedure/Checklist.h"
#include "core/procedure/DatumHeading.h"
#include "core/site/SiteSurvey.h"
#include "core/swing/SwingField.h"
#include "ui/earth/FieldText.h"
#include "ui/guided/BigWidgets.h"
#include "ui/guided/GuidedWords.h"
#include "ui/kit/OpenSwings.h"
#include "ui/kit/Words.h"
#include "ui/kit/keys/EnterGoesOn.h"

namespace lubberline::ui {

namespace {

constexpr int kForm_px = 17;
constexpr int kPoints[] = {8, 12, 24};

std::string typed(const QLineEdit& line) { return line.text().trimmed().toStdString(); }

/// East positive: stated for the site, else of the Earth's field there.
std::optional<double> variationOf(const Swing& swing, const Site* site)
{
    if (!site)
        return {};
    if (site->variation_deg)
        return site->variation_deg;
    const auto stamp = stampFor(swing, *site);
    if (!stamp)
        return {};
    return stamp->field.variation().degrees();
}

} // namespace

DatumInstrument plainDatum()
{
    DatumInstrument plain;
    plain.name = "magnetic heading, as read"; // it is stored
    plain.kind = DatumKind::DigitalCompass;
    return plain;
}

GuidedStart::GuidedStart(db::Stores& stores, QWidget* parent)
    : QWidget(parent)
    , m_stores(stores)
    , m_open(new QVBoxLayout)
    , m_meaning(new QLabel)
    , m_checklist(new QPlainTextEdit)
    , m_complaint(bigLabel("guidedComplaint", kForm_px, true))
    , m_start(bigButton(tr("Begin (Ctrl+Enter)"), "beginGuided"))
{
    build();
}

QLineEdit* GuidedStart::addLine(QFormLayout& form, const QString& title, const char* name, const QString& placeholder)
{
    auto* line = new QLineEdit;
    line->setObjectName(QString::fromLatin1(name));
    line->setPlaceholderText(placeholder);
    form.addRow(title, line);
    connect(line, &QLineEdit::returnPressed, this, [this] { focusNextChild(); });
    return line;
}

QComboBox* GuidedStart::addBox(QFormLayout& form, const QString& title, const char* name, const QStringList& words)
{
    auto* box = new QComboBox;
    box->setObjectName(QString::fromLatin1(name));
    box->addItems(words);
    form.addRow(title, box);
    new EnterGoesOn(*box);
    return box;
}

void GuidedStart::build()
{
    auto* inner = new QWidget;
    inner->setFont(bigFont(font(), kForm_px));
    auto* form = new QFormLayout;
    m_procedure = addBox(*form, tr("&Procedure:"), "guidedProcedure", choiceWords<ProcedureKind>());
    m_meaning->setWordWrap(true);
    m_meaning->setFont(font());
    m_meaning->setAlignment(Qt::AlignTop);
    m_start->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Return));
    form->addRow(QString(), m_meaning);
    m_points = addBox(*form, tr("&Check swing:"), "guidedPoints", {tr("8 headings"), tr("12 headings"), tr("24 headings")});
    m_datum = addBox(*form, tr("&Datum:"), "guidedDatumBox");
    m_site = addBox(*form, tr("&Site:"), "guidedSite");
    m_date = addLine(*form, tr("Da&te (UTC):"), "guidedDate");
    m_radio = addBox(*form, tr("&Radio:"), "guidedRadio", choiceWords<RadioState>());
    m_engines = addLine(*form, tr("&Engines:"), "guidedEngines", tr("as running, 1500 rpm"));
    m_electrics = addLine(*form, tr("E&lectrics:"), "guidedElectrics", tr("loads on and off"));
    m_further = addLine(*form, tr("&Further configurations:"), "guidedFurther", tr("each read once more, as radio on; pitot heat on"));
    m_datumReader = addLine(*form, tr("Datum read &by:"), "guidedDatumReader");
    m_cockpitReader = addLine(*form, tr("Compass read b&y:"), "guidedCockpitReader");
    m_adjuster = addLine(*form, tr("&Adjusted by:"), "guidedAdjuster");
    m_reason = addLine(*form, tr("Reaso&n:"), "guidedWhy", tr("as yearly, compass replaced"));
    m_workOrder = addLine(*form, tr("&Work order:"), "guidedWorkOrder");
    m_checklist->setObjectName(QStringLiteral("guidedChecklist"));
    m_checklist->setTabChangesFocus(true);
    m_checklist->setMaximumHeight(150);
    form->addRow(tr("Chec&klist, a line each:"), m_checklist);
    m_override = addLine(*form, tr("&In spite of that, because:"), "guidedOverride");
    auto* buttons = new QHBoxLayout;
    auto* cancel = bigButton(tr("Cancel"), "cancelGuided");
    buttons->addWidget(m_start);
    buttons->addWidget(cancel);
    buttons->addStretch();
    auto* column = new QVBoxLayout(inner);
    column->addLayout(m_open);
    column->addLayout(form);
    column->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(inner);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll, 1);
    layout->addWidget(m_complaint); // what begins it is seen however small the window is
    layout->addLayout(buttons);
    setFocusProxy(m_procedure);

    connect(m_procedure, &QComboBox::currentIndexChanged, this,
        [this](int kind) { m_meaning->setText(procedureMeaning(static_cast<ProcedureKind>(kind))); });
    for (QComboBox* box : {m_datum, m_site})
        connect(box, &QComboBox::currentIndexChanged, this, &GuidedStart::check);
    connect(m_date, &QLineEdit::editingFinished, this, &GuidedStart::check);
    connect(m_start, &QPushButton::clicked, this, &GuidedStart::start);
    connect(cancel, &QPushButton::clicked, this, &GuidedStart::cancelled);
}

void GuidedStart::setUsual(std::function<RecordId()> site, std::function<RecordId()> datum)
{
    m_usualSite = std::move(site);
    m_usualDatum = std::move(datum);
}

namespace {

template <class Record>
void chooseUsual(QComboBox& box, const std::vector<Record>& records, const std::function<RecordId()>& usual, int first)
{
    for (std::size_t i = 0; usual && i < records.size(); ++i)
        if (records[i].record == usual())
            box.setCurrentIndex(static_cast<int>(i) + first);
}

} // namespace

Result<void> GuidedStart::begin(CompassId compass, Date today)
{
    const auto system = m_stores.fleet.compass(compass);
    if (!system)
        return system.error();
    const auto aircraft = m_stores.fleet.aircraft(system->aircraft);
    if (!aircraft)
        return aircraft.error();
    auto sites = m_stores.sites.sites();
    auto instruments = m_stores.sites.instruments();
    if (!sites || !instruments)
        return sites ? instruments.error() : sites.error();
    offerOpen(compass);
    m_compassSystem = *system;
    m_sites = std::move(sites.value());
    m_instruments = std::move(instruments.value());
    m_whose = QStringLiteral("%1 · %2").arg(toText(aircraft->registration), toText(system->name));
    m_site->clear();
    m_site->addItem(tr("not stated"));
    for (const auto& one : m_sites)
        m_site->addItem(toText(one.name));
    m_datum->clear();
    for (const auto& one : m_instruments)
        m_datum->addItem(toText(one.name));
    m_datum->addItem(toText(plainDatum().name));
    chooseUsual(*m_site, m_sites, m_usualSite, 1);
    chooseUsual(*m_datum, m_instruments, m_usualDatum, 0);
    m_procedure->setCurrentIndex(static_cast<int>(system->compensator == Compensator::None ? ProcedureKind::CheckOnly
            : system->kind == CompassKind::RemoteUnstabilised || system->kind == CompassKind::RemoteStabilised
            ? ProcedureKind::FluxValve
            : ProcedureKind::Coefficient));
    m_meaning->setText(procedureMeaning(static_cast<ProcedureKind>(m_procedure->currentIndex())));
    m_date->setText(toText(today));
    QStringList items;
    for (const auto& item : usualChecklist(*system))
        items += toText(item);
    m_checklist->setPlainText(items.join('\n'));
    m_override->clear();
    check();
    m_start->setEnabled(!m_stores.readOnly());
    return {};
}

/// Whoever begins one anew while another stands half-way is told of that first.
void GuidedStart::offerOpen(CompassId compass)
{
    while (QLayoutItem* item = m_open->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    setFocusProxy(m_procedure);
    const auto open = openSwings(m_stores);
    for (const OpenSwing& one : open ? *open : std::vector<OpenSwing>()) {
        if (one.compass != compass)
            continue;
        auto* button = bigButton(inLines(one.words), "goOnGuided");
        connect(button, &QPushButton::clicked, this, [this, swing = one.swing] { emit goOn(swing); });
        m_open->addWidget(button);
        if (m_open->count() == 1)
            setFocusProxy(button);
    }
}

const Site* GuidedStart::site() const
{
    const int row = m_site->currentIndex() - 1;
    return row < 0 ? nullptr : &m_sites[static_cast<std::size_t>(row)];
}

DatumInstrument GuidedStart::datum() const
{
    const auto row = static_cast<std::size_t>(std::max(m_datum->currentIndex(), 0));
    DatumInstrument chosen = row < m_instruments.size() ? m_instruments[row] : plainDatum();
    if (chosen.kind == DatumKind::RoseLine)
        chosen.zero_deg += paintedOffset_deg();
    return chosen;
}

/// What the lines of the site are out by on that day; none where it is not known when they were painted.
double GuidedStart::paintedOffset_deg() const
{
    Swing day;
    if (const auto date = parseDate(m_date->text(), true))
        day.date = *date;
    if (day.date.empty() || !site() || !site()->paintedVariation_deg)
        return 0;
    const auto stamp = stampFor(day, *site());
    if (!stamp)
        return 0;
    const Variation today = stamp->field.variation();
    return paintedLineOffset_deg(Variation::fromDegrees(*site()->paintedVariation_deg), today);
}

Message GuidedStart::whyNot() const
{
    const auto date = parseDate(m_date->text(), false);
    Message why;
    if (!date)
        return why;
    if (site())
        why = whyUnfit({site()->certificateExpiry, site()->siteClass, SiteClass::None}, *date);
    if (calibrationOver(datum(), *date))
        why = together({std::move(why), {MARKED("ui", "the calibration of %1 was due on %2"), datum().name, datum().calibrationDue}});
    return why;
}

void GuidedStart::check()
{
    const Message why = whyNot();
    QStringList words;
    if (!why.empty())
        words += tr("Not to be used on that day: %1").arg(toText(why));
    if (datum().kind == DatumKind::RoseLine && paintedOffset_deg() != 0)
        words += tr("The painted lines are out by %1° since they were laid out; this is added to every figure.")
                     .arg(signedNumber(paintedOffset_deg(), 2));
    m_complaint->setText(words.join('\n'));
    m_override->setEnabled(!why.empty());
}

Result<Swing> GuidedStart::particulars() const
{
    auto date = parseDate(m_date->text(), false);
    if (!date)
        return date.error();
    Swing swing;
    swing.compass = m_compassSystem.id;
    swing.date = *date;
    swing.site = site() ? site()->id : SiteId();
    swing.stage
        = static_cast<ProcedureKind>(m_procedure->currentIndex()) == ProcedureKind::CheckOnly ? SwingStage::AsFound : SwingStage::AsLeft;
    swing.configuration = {static_cast<RadioState>(m_radio->currentIndex()), typed(*m_engines), typed(*m_electrics), {}};
    const DatumInstrument instrument = datum();
    swing.datum = {instrument.name, instrument.serialNumber, instrument.calibrationDue, readOutWords(instrument)};
    swing.people = {typed(*m_datumReader), typed(*m_cockpitReader), typed(*m_adjuster), {}};
    swing.procedure = Message(shownWord(static_cast<ProcedureKind>(m_procedure->currentIndex()))).english(); // not in the window's language
    swing.reason = typed(*m_reason);
    swing.workOrder = typed(*m_workOrder);
    if (instrument.givesTrue) {
        swing.variation_deg = variationOf(swing, site());
        if (!swing.variation_deg)
            return Error{ErrorCode::InvalidInput,
                said(tr("%1 gives true headings; expected a site with its variation or its position").arg(toText(instrument.name)))};
    }
    if (!whyNot().empty()) {
        if (typed(*m_override).empty())
            return Error{ErrorCode::InvalidInput,
                said(tr("Not to be used on that day: %1. A reason is expected to swing in spite of that.").arg(toText(whyNot())))};
        swing.siteOverride = whyNot().english() + ": " + typed(*m_override);
    }
    return swing;
}

SwingJob GuidedStart::job() const
{
    SwingJob job;
    job.plan.kind = static_cast<ProcedureKind>(m_procedure->currentIndex());
    job.plan.checkPoints = kPoints[std::max(m_points->currentIndex(), 0)];
    for (const QString& words : m_further->text().split(';', Qt::SkipEmptyParts))
        if (!words.trimmed().isEmpty())
            job.plan.configurations.push_back(words.trimmed().toStdString());
    for (const QString& line : m_checklist->toPlainText().split('\n', Qt::SkipEmptyParts))
        if (!line.trimmed().isEmpty())
            job.checklist.push_back(line.trimmed().toStdString());
    job.datum = datum();
    job.resolution_deg = m_compassSystem.resolution_deg;
    return job;
}

void GuidedStart::start()
{
    const auto swing = particulars();
    if (!swing) {
        m_complaint->setText(messageOf(swing.error()));
        return;
    }
    const auto started = m_stores.jobs.start(*swing, job());
    if (!started) {
        m_complaint->setText(messageOf(started.error()));
        return;
    }
    emit this->started(*started);
}

} // namespace lubberline::ui
