#include "ui/electrical/ElectricalPage.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>
#include <QVBoxLayout>

#include <cmath>

#include "core/angle/AngleText.h"
#include "core/procedure/ElectricalChecks.h"
#include "core/swing/Analysis.h"
#include "core/swing/SwingResult.h"
#include "ui/earth/FieldText.h"
#include "ui/electrical/ElectricalSteps.h"
#include "ui/kit/OpenCell.h"
#include "ui/kit/StoredEdit.h"
#include "ui/kit/TableEntry.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/text/AngleWords.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

enum FourColumn { Before, BeforeError, After, AfterError, kFourColumns };
enum HeadingColumn { Indicated, HeadingError, Turntable, kHeadingColumns };
constexpr int kPoints = 4;

QString figure(std::optional<double> value) { return value ? QString::number(*value, 'f', 2) : QString(); }

QString errorWords(std::optional<double> indicated_deg, double selected_deg)
{
    return indicated_deg ? signedNumber(wrap180(*indicated_deg - selected_deg), 2) : QString();
}

Result<std::optional<double>> takeFigure(const QString& text)
{
    if (text.trimmed().isEmpty())
        return std::optional<double>();
    const auto heading = parseHeading_deg(text.trimmed().toStdString());
    if (!heading)
        return heading.error();
    return std::optional(*heading);
}

FormFields<ElectricalSwing>::Take takeNumber(std::function<std::optional<double>&(ElectricalSwing&)> field, double most)
{
    return [field = std::move(field), most](ElectricalSwing& swing, const QString& text) -> Result<void> {
        const bool isEmpty = text.trimmed().isEmpty();
        const auto value = typedNumber(text);
        if (!isEmpty && (!value || std::abs(*value) > most))
            return Error{ErrorCode::InvalidInput,
                said(ElectricalPage::tr("'%1' is not allowed; expected a number from −%2 to %2").arg(text).arg(most))};
        field(swing) = value;
        return {};
    };
}

} // namespace

ElectricalPage::ElectricalPage(EditContext& context, QUndoStack& undo, std::function<Date()> today, QWidget* parent)
    : Page(parent)
    , m_context(context)
    , m_stores(context.stores)
    , m_undo(undo)
    , m_today(std::move(today))
    , m_fields([this](const ElectricalSwing& after, const QString&) { store(after); })
    , m_chooser(new QComboBox)
    , m_add(new QPushButton(tr("&New electrical swing")))
    , m_make(new QPushButton(tr("As a &swing")))
    , m_write(new QPushButton(tr("Write the &record…")))
    , m_fourPoints(new QTableWidget(kPoints, kFourColumns))
    , m_headings(new QTableWidget(24, kHeadingColumns))
    , m_turn(new QLabel)
    , m_verdict(new QLabel)
    , m_plot(makeCurvePlot())
{
    build();
}

void ElectricalPage::build()
{
    setTitle(tr("Electrical swings"));
    m_chooser->setObjectName(QStringLiteral("electricalChooser"));
    m_add->setObjectName(QStringLiteral("newElectrical"));
    m_make->setObjectName(QStringLiteral("electricalAsSwing"));
    m_write->setObjectName(QStringLiteral("electricalRecord"));
    m_turn->setObjectName(QStringLiteral("electricalTurn"));
    m_verdict->setObjectName(QStringLiteral("electricalVerdict"));
    m_turn->setWordWrap(true);
    m_verdict->setWordWrap(true);
    m_fourPoints->setObjectName(QStringLiteral("tableF1"));
    m_fourPoints->setHorizontalHeaderLabels({tr("before"), tr("error"), tr("after"), tr("error")});
    m_fourPoints->setVerticalHeaderLabels({QStringLiteral("000"), QStringLiteral("090"), QStringLiteral("180"), QStringLiteral("270")});
    m_headings->setObjectName(QStringLiteral("electricalHeadings"));
    m_headings->setHorizontalHeaderLabels({tr("indicated"), tr("error"), tr("by turntable")});
    for (QTableWidget* table : {m_fourPoints, m_headings}) {
        table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
        new EnterAdvances(*table);
    }
    for (QWidget* tool : std::initializer_list<QWidget*>{m_chooser, m_add, m_make, m_write})
        head().addWidget(tool);
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->addWidget(m_headings, 3);
    column->addWidget(m_plot, 2);
    auto* splitter = new SideBySide;
    splitter->addWidget(buildSheet());
    splitter->addWidget(right);
    splitter->setSizes({480, 520});
    body().addWidget(splitter, 1);
    connect(m_chooser, &QComboBox::activated, this, [this](int choice) {
        m_current = choice;
        showSwing();
    });
    connect(m_add, &QPushButton::clicked, this, &ElectricalPage::add);
    connect(m_make, &QPushButton::clicked, this, &ElectricalPage::make);
    connect(m_write, &QPushButton::clicked, this, &ElectricalPage::write);
    // Queued: storing shows the table anew, which would delete the item that is just being changed.
    connect(m_fourPoints, &QTableWidget::cellChanged, this, &ElectricalPage::takeFourPoints, Qt::QueuedConnection);
    connect(m_headings, &QTableWidget::cellChanged, this, &ElectricalPage::takeHeading, Qt::QueuedConnection);
    follow(*m_plot);
    connect(&m_stores.changes(), &db::Changes::electricalChanged, this, [this](CompassId id) {
        if (id == m_compass.id)
            reload();
    });
}

QWidget* ElectricalPage::buildSheet()
{
    auto* form = new QFormLayout;
    m_fields.addLine(
        *form, tr("Date:"), QStringLiteral("electricalDate"), [](const ElectricalSwing& swing) { return toText(swing.date); },
        [](ElectricalSwing& swing, const QString& text) -> Result<void> {
            const auto date = parseDate(text, false);
            if (!date)
                return date.error();
            swing.date = *date;
            return {};
        });
    const auto text = [&](const QString& title, const char* name, std::string ElectricalSwing::*member) {
        m_fields.addLine(
            *form, title, QString::fromLatin1(name), [member](const ElectricalSwing& swing) { return toText(swing.*member); },
            takeText(member));
    };
    text(tr("North–south line:"), "electricalLine", &ElectricalSwing::line);
    text(tr("Calibrator:"), "electricalCalibrator", &ElectricalSwing::calibrator);
    text(tr("Its serial number:"), "electricalSerial", &ElectricalSwing::calibratorSerial);
    text(tr("Sensor sheet:"), "electricalSensor", &ElectricalSwing::sensorSheet);
    const auto number
        = [&](const QString& title, const char* name, std::function<std::optional<double>&(ElectricalSwing&)> field, double most) {
              m_fields.addLine(
                  *form, title, QString::fromLatin1(name),
                  [field](const ElectricalSwing& swing) {
                      ElectricalSwing copy = swing;
                      const auto& value = field(copy);
                      return value ? QString::number(*value) : QString();
                  },
                  takeNumber(field, most));
          };
    number(
        tr("E1 normal (V):"), "e1Normal", [](ElectricalSwing& swing) -> std::optional<double>& { return swing.E1.normal_V; }, 1000);
    number(
        tr("E1 reversed (V):"), "e1Reversed", [](ElectricalSwing& swing) -> std::optional<double>& { return swing.E1.reversed_V; }, 1000);
    number(
        tr("E2 normal (V):"), "e2Normal", [](ElectricalSwing& swing) -> std::optional<double>& { return swing.E2.normal_V; }, 1000);
    number(
        tr("E2 reversed (V):"), "e2Reversed", [](ElectricalSwing& swing) -> std::optional<double>& { return swing.E2.reversed_V; }, 1000);
    number(
        tr("MISAL (°):"), "misal", [](ElectricalSwing& swing) -> std::optional<double>& { return swing.misalignment_deg; }, 360);
    number(
        tr("δ180 (°):"), "delta180", [](ElectricalSwing& swing) -> std::optional<double>& { return swing.delta180_deg; }, 360);
    number(
        tr("δ270 (°):"), "delta270", [](ElectricalSwing& swing) -> std::optional<double>& { return swing.delta270_deg; }, 360);
    text(tr("By:"), "electricalBy", &ElectricalSwing::by);
    text(tr("Note:"), "electricalNote", &ElectricalSwing::note);
    auto* sheet = new QWidget;
    auto* column = new QVBoxLayout(sheet);
    column->addLayout(form);
    column->addWidget(new QLabel(tr("Table F1 (error = indicated − selected; deviation is its negative):")));
    m_fourPoints->setMinimumHeight(150);
    column->addWidget(m_fourPoints);
    column->addWidget(m_turn);
    column->addWidget(m_verdict);
    column->addStretch();
    return new SidePanel(sheet);
}

Result<void> ElectricalPage::showCompass(CompassId compass)
{
    const auto system = m_stores.fleet.compass(compass);
    if (!system)
        return system.error();
    const auto aircraft = m_stores.fleet.aircraft(system->aircraft);
    if (!aircraft)
        return aircraft.error();
    m_compass = *system;
    setTitle(tr("Electrical swings · %1 · %2").arg(toText(aircraft->registration), toText(system->name)));
    m_current = -1;
    reload();
    return {};
}

void ElectricalPage::reload()
{
    if (waitsForCell(*m_fourPoints, this, &ElectricalPage::reload) || waitsForCell(*m_headings, this, &ElectricalPage::reload))
        return; // what is being typed is of the record that is shown
    auto swings = m_stores.electrical.of(m_compass.id);
    if (!swings) {
        emit failed(messageOf(swings.error()));
        return;
    }
    const RecordId kept = m_current >= 0 ? current().record : RecordId();
    m_swings = std::move(swings.value());
    m_current = m_swings.empty() ? -1 : 0;
    m_chooser->clear();
    for (std::size_t i = 0; i < m_swings.size(); ++i) {
        m_chooser->addItem(toText(m_swings[i].date));
        if (!kept.empty() && m_swings[i].record == kept)
            m_current = static_cast<int>(i);
    }
    m_chooser->setCurrentIndex(m_current);
    showSwing();
}

void ElectricalPage::showSwing()
{
    const bool there = m_current >= 0, editable = there && !m_stores.readOnly();
    m_fields.show(there ? current() : ElectricalSwing(), editable);
    m_write->setEnabled(there);
    m_chooser->setEnabled(there);
    say(there ? QString() : tr("No electrical swing of this compass is on record: “New electrical swing” begins one."));
    m_add->setEnabled(!m_stores.readOnly());
    for (QTableWidget* table : {m_fourPoints, m_headings})
        table->setEnabled(editable);
    showFourPoints();
    showHeadings();
    showVerdict();
}

void ElectricalPage::showFourPoints()
{
    const QSignalBlocker quiet(m_fourPoints);
    const ElectricalSwing& swing = m_fields.record();
    for (int row = 0; row < kPoints; ++row) {
        const double selected = 90.0 * row;
        const auto before = swing.before.indicated_deg[static_cast<std::size_t>(row)],
                   after = swing.after.indicated_deg[static_cast<std::size_t>(row)];
        m_fourPoints->setItem(row, Before, new QTableWidgetItem(figure(before)));
        m_fourPoints->setItem(row, BeforeError, fixedCell(errorWords(before, selected)));
        m_fourPoints->setItem(row, After, new QTableWidgetItem(figure(after)));
        m_fourPoints->setItem(row, AfterError, fixedCell(errorWords(after, selected)));
    }
    m_turn->setText(electricalSteps(swing.before).join('\n'));
}

void ElectricalPage::showHeadings()
{
    const QSignalBlocker quiet(m_headings);
    const ElectricalSwing& swing = m_fields.record();
    for (int row = 0; row < m_headings->rowCount(); ++row) {
        const bool there = row < static_cast<int>(swing.headings.size()), checked = row < static_cast<int>(swing.selfCheck.size());
        const double selected = 15.0 * row;
        m_headings->setVerticalHeaderItem(row, new QTableWidgetItem(QStringLiteral("%1").arg(selected, 3, 'f', 0, QChar('0'))));
        const auto indicated = there ? swing.headings[static_cast<std::size_t>(row)].indicated_deg : std::nullopt;
        m_headings->setItem(row, Indicated, new QTableWidgetItem(figure(indicated)));
        m_headings->setItem(row, HeadingError, fixedCell(errorWords(indicated, selected)));
        m_headings->setItem(row, Turntable,
            new QTableWidgetItem(figure(checked ? swing.selfCheck[static_cast<std::size_t>(row)].indicated_deg : std::nullopt)));
    }
    SwingRecord record;
    record.swing = swingFrom(swing);
    record.compass = m_compass;
    record.compass.resolution_deg = divisionOf_deg(record.swing); // the calibrator's figures are finer than the compass's
    auto made = resultOf(record);
    const QString why = made ? QString() : toText(made.error().message);
    m_plot->setPicture(
        pictureOf(record, made ? std::make_shared<const Analysis>(std::move(made.value())) : nullptr, why, nullptr, {}, shownAngles()));
    m_make->setEnabled(!record.swing.readings.empty() && !m_stores.readOnly());
}

void ElectricalPage::showVerdict()
{
    const ElectricalSwing& swing = m_fields.record();
    QStringList lines;
    for (const auto& [table, words] : {std::pair{&swing.before, tr("Before")}, {&swing.after, tr("After")}})
        if (const auto errors = errorsOf(*table))
            lines += tr("%1: N–S %2°, E–W %3°, index %4°; pairs 0/180 %5°, 90/270 %6°: %7")
                         .arg(words, signedNumber(errors->northSouth_deg, 2), signedNumber(errors->eastWest_deg, 2),
                             signedNumber(errors->index_deg, 2))
                         .arg(errors->pair0_180_deg, 0, 'f', 2)
                         .arg(errors->pair90_270_deg, 0, 'f', 2)
                         .arg(errors->pairsAgree ? tr("agree within 0.2° (TM 11-4920-292-15)")
                                                 : tr("do NOT agree within 0.2° (TM 11-4920-292-15)"));
    if (const auto mean = swing.E1.mean_V())
        lines += tr("E1 mean %1 V").arg(*mean);
    if (const auto mean = swing.E2.mean_V())
        lines += tr("E2 mean %1 V").arg(*mean);
    if (const auto errors = electricalErrorsOf(swing))
        lines += tr("Headings: largest error %1° with %2° selected, mean %3°, of %n heading(s)", nullptr, errors->read)
                     .arg(signedNumber(errors->largest_deg, 2))
                     .arg(errors->largestAt_deg)
                     .arg(signedNumber(errors->mean_deg, 2));
    if (const auto check = selfCheckOf(swing))
        lines += tr("Set self-check: largest %1′, mean %2′: %3")
                     .arg(check->largest_deg * 60, 0, 'f', 1)
                     .arg(check->mean_deg * 60, 0, 'f', 1)
                     .arg(check->passed ? tr("passed") : tr("NOT passed"));
    if (m_current >= 0)
        for (const auto& point : openPoints(swing))
            lines += tr("open: %1").arg(toText(point));
    m_verdict->setText(inAngleStyle(lines.join('\n')));
}

void ElectricalPage::takeFourPoints(int row, int column)
{
    if (m_current < 0 || (column != Before && column != After))
        return;
    ElectricalSwing after = current();
    auto& place = (column == Before ? after.before : after.after).indicated_deg[static_cast<std::size_t>(row)];
    const auto value = takeFigure(m_fourPoints->item(row, column)->text());
    if (!value) {
        emit failed(messageOf(value.error()));
        showFourPoints();
        return;
    }
    place = *value;
    storeTyped(std::move(after), m_fourPoints->item(row, column)->text(), 90.0 * row);
}

void ElectricalPage::takeHeading(int row, int column)
{
    if (m_current < 0 || (column != Indicated && column != Turntable))
        return;
    ElectricalSwing after = current();
    auto& list = column == Indicated ? after.headings : after.selfCheck;
    if (list.empty())
        list = everyFifteenDegrees();
    const auto value = takeFigure(m_headings->item(row, column)->text());
    if (!value) {
        emit failed(messageOf(value.error()));
        showHeadings();
        return;
    }
    SelectedHeading& heading = list[static_cast<std::size_t>(row)];
    heading.indicated_deg = *value;
    const double selected_deg = heading.selected_deg;
    storeTyped(std::move(after), m_headings->item(row, column)->text(), selected_deg);
}

/// Where another window has changed the record meanwhile, nothing is stored and the table shows what is: the figure is told.
void ElectricalPage::storeTyped(ElectricalSwing after, const QString& typed, double selected_deg)
{
    if (after == current())
        return;
    store(after);
    if (m_current < 0 || !(current() == after))
        emit failed(tr("“%1”, typed with %2° selected, is not stored: look at the table as it is now, and type it again.")
                        .arg(typed)
                        .arg(selected_deg));
}

} // namespace lubberline::ui
