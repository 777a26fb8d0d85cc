#include "ui/sites/InstrumentsPage.h"

#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>

#include "core/angle/PrintedHeading.h"
#include "core/procedure/SunDatum.h"
#include "core/record/DefaultNames.h"
#include "ui/earth/FieldText.h"
#include "ui/kit/StoredEdit.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr double kExampleFigure_deg = 358, kExampleVariation_deg = 6;

/// What a kind of instrument usually is.
void takeKind(DatumInstrument& instrument, int choice)
{
    instrument.kind = static_cast<DatumKind>(choice);
    instrument.givesTrue
        = instrument.kind == DatumKind::Inertial || instrument.kind == DatumKind::Astrocompass || instrument.kind == DatumKind::ShadowPin;
    if (instrument.kind != DatumKind::SightingCompass && instrument.kind != DatumKind::Theodolite)
        instrument.ahead = SightingDirection::Direct;
}

} // namespace

QString datumExample(const DatumInstrument& instrument)
{
    if (needsSun(instrument.kind))
        return InstrumentsPage::tr(
            "Its figure is the bearing of the shadow from the nose, clockwise; with place and time of the reading it gives a true heading.");
    const auto heading = datumHeading(instrument, {{kExampleFigure_deg}, {}, {}}, Variation::fromDegrees(kExampleVariation_deg));
    if (!heading)
        return messageOf(heading.error());
    QString text = InstrumentsPage::tr("Where it shows %1, the aircraft heads %2° magnetic")
                       .arg(kExampleFigure_deg)
                       .arg(printedHeading_deg(heading->magnetic.degrees(), 1), 0, 'f', 1);
    if (instrument.givesTrue)
        text += InstrumentsPage::tr(" at a variation of %1° east").arg(kExampleVariation_deg);
    return text + '.';
}

InstrumentsPage::InstrumentsPage(EditContext& context, QUndoStack& undo, std::function<Date()> today, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_stores(context.stores)
    , m_undo(undo)
    , m_today(std::move(today))
    , m_fields([this](const DatumInstrument& after, const QString& field) {
        edit(m_fields.record(), after, tr("%1 of %2").arg(field, toText(after.name)));
    })
    , m_list(new QListWidget)
    , m_add(new QPushButton(tr("&New instrument")))
    , m_remove(new QPushButton(tr("&Remove")))
    , m_example(new QLabel)
    , m_state(new QLabel)
{
    build();
}

void InstrumentsPage::build()
{
    m_list->setObjectName(QStringLiteral("instrumentList"));
    m_add->setObjectName(QStringLiteral("newInstrument"));
    m_remove->setObjectName(QStringLiteral("removeInstrument"));
    m_example->setObjectName(QStringLiteral("instrumentExample"));
    m_state->setObjectName(QStringLiteral("instrumentState"));
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    m_example->setFont(large);
    m_example->setWordWrap(true);
    auto* form = new QFormLayout;
    const auto text = [&](const QString& title, const char* name, std::string DatumInstrument::*member) {
        m_fields.addLine(
            *form, title, QString::fromLatin1(name), [member](const DatumInstrument& one) { return toText(one.*member); },
            takeText(member));
    };
    text(tr("Name:"), "instrumentName", &DatumInstrument::name);
    m_fields.addChoice(
        *form, tr("Kind:"), QStringLiteral("instrumentKind"), choiceWords<DatumKind>(),
        [](const DatumInstrument& one) { return static_cast<int>(one.kind); }, takeKind);
    text(tr("Maker:"), "instrumentMaker", &DatumInstrument::maker);
    text(tr("Serial number:"), "instrumentSerial", &DatumInstrument::serialNumber);
    m_fields.addLine(
        *form, tr("Calibration due:"), QStringLiteral("instrumentDue"),
        [](const DatumInstrument& one) { return toText(one.calibrationDue); },
        [](DatumInstrument& one, const QString& typed) -> Result<void> {
            const auto date = parseDate(typed, true);
            if (!date)
                return date.error();
            one.calibrationDue = *date;
            return {};
        });
    m_fields.addChoice(
        *form, tr("From ahead it reads:"), QStringLiteral("instrumentAhead"), choiceWords<SightingDirection>(),
        [](const DatumInstrument& one) { return static_cast<int>(one.ahead); },
        [](DatumInstrument& one, int choice) { one.ahead = static_cast<SightingDirection>(choice); });
    m_fields.addChoice(
        *form, tr("Its figures are from:"), QStringLiteral("instrumentTrue"), {tr("magnetic north"), tr("true north")},
        [](const DatumInstrument& one) { return one.givesTrue ? 1 : 0; },
        [](DatumInstrument& one, int choice) { one.givesTrue = choice == 1; });
    m_fields.addLine(
        *form, tr("Added to every figure (°):"), QStringLiteral("instrumentZero"),
        [](const DatumInstrument& one) { return signedNumber(one.zero_deg, 2); },
        [](DatumInstrument& one, const QString& typed) -> Result<void> {
            const auto zero = parseOptionalAngle_deg(typed);
            if (!zero)
                return zero.error();
            one.zero_deg = zero->value_or(0);
            return {};
        });
    m_fields.addLine(
        *form, tr("Read to (°):"), QStringLiteral("instrumentResolution"),
        [](const DatumInstrument& one) { return QString::number(one.resolution_deg); },
        [](DatumInstrument& one, const QString& typed) -> Result<void> {
            const auto resolution = parsePositive_deg(typed);
            if (!resolution)
                return resolution.error();
            one.resolution_deg = *resolution;
            return {};
        });
    text(tr("Note:"), "instrumentNote", &DatumInstrument::note);
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->addLayout(form);
    column->addWidget(m_example);
    column->addWidget(m_state);
    column->addStretch();
    auto* left = new QWidget;
    auto* list = new QVBoxLayout(left);
    list->addWidget(m_list);
    list->addWidget(m_add);
    list->addWidget(m_remove);
    auto* splitter = new SideBySide;
    splitter->addWidget(left);
    splitter->addWidget(new SidePanel(right));
    splitter->setSizes({220, 700});
    setTitle(tr("Datum instruments"));
    body().addWidget(splitter, 1);
    setFocusProxy(m_list);
    connect(m_list, &QListWidget::currentRowChanged, this, &InstrumentsPage::showInstrument);
    connect(m_add, &QPushButton::clicked, this, &InstrumentsPage::add);
    connect(m_remove, &QPushButton::clicked, this, &InstrumentsPage::remove);
    connect(&m_stores.changes(), &db::Changes::sitesChanged, this, &InstrumentsPage::reload);
}

void InstrumentsPage::reload()
{
    auto instruments = m_stores.sites.instruments();
    if (!instruments) {
        emit failed(messageOf(instruments.error()));
        return;
    }
    const RecordId kept = m_fields.record().record;
    m_instruments = std::move(instruments.value());
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    int row = 0;
    for (std::size_t i = 0; i < m_instruments.size(); ++i) {
        m_list->addItem(toText(m_instruments[i].name));
        if (m_instruments[i].record == kept)
            row = static_cast<int>(i);
    }
    m_list->setCurrentRow(row);
    showInstrument();
}

void InstrumentsPage::showInstrument()
{
    const int row = m_list->currentRow();
    const bool there = row >= 0 && row < static_cast<int>(m_instruments.size());
    const DatumInstrument instrument = there ? m_instruments[static_cast<std::size_t>(row)] : DatumInstrument();
    m_fields.show(instrument, there && !m_stores.readOnly());
    m_add->setEnabled(!m_stores.readOnly());
    m_remove->setEnabled(there && !m_stores.readOnly());
    m_example->setText(there ? inAngleStyle(datumExample(instrument)) : tr("No instrument yet."));
    m_state->setText(!there || !calibrationOver(instrument, m_today())
            ? QString()
            : tr("▲ its calibration was due on %1: a swing with it needs a reason").arg(toText(instrument.calibrationDue)));
}

void InstrumentsPage::add()
{
    DatumInstrument instrument;
    instrument.record = newRecordId();
    instrument.name = freeName(kNewInstrument, m_instruments, [](const DatumInstrument& one) { return one.name; });
    m_fields.show(instrument, true);
    edit({}, instrument, tr("new instrument"));
    if (m_fields.record().record != instrument.record)
        return; // refused
    auto* name = findChild<QLineEdit*>(QStringLiteral("instrumentName"));
    name->setFocus();
    name->selectAll();
}

void InstrumentsPage::remove() { edit(m_fields.record(), {}, tr("removal of %1").arg(toText(m_fields.record().name))); }

void InstrumentsPage::edit(std::optional<DatumInstrument> before, std::optional<DatumInstrument> after, const QString& text)
{
    static const StoredBy<DatumInstrument> kBy{
        [](db::Stores& stores, const DatumInstrument& one) { return noValue(stores.sites.add(one)); },
        [](db::Stores& stores, const DatumInstrument& known, const DatumInstrument& one) { return stores.sites.change(known, one); },
        [](db::Stores& stores, const DatumInstrument& one) { return stores.sites.removeInstrument(one.record); }};
    m_undo.push(new StoredEdit(m_context, kBy, std::move(before), std::move(after), text, Destination{QStringLiteral("instruments")}));
    reload();
}

} // namespace lubberline::ui
