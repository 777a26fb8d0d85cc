#include "ui/calibration/LineOfSightPage.h"

#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/format/exchange/ModelJson.h"
#include "ui/calibration/TestWidgets.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/plots/calibration/SightDrawing.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/report/forms/LineOfSightSheet.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kFormWidth = 400;

/// Numbers of one line, each of them allowed.
Result<std::vector<double>> numbersOf(const QLineEdit& line, std::size_t count, double least, double most)
{
    const auto numbers = typedNumbers(line.text(), count);
    const bool stands
        = numbers && std::all_of(numbers->begin(), numbers->end(), [&](double number) { return number >= least && number <= most; });
    if (!stands)
        return Error{ErrorCode::InvalidInput,
            said(LineOfSightPage::tr("“%1”: %2; expected %3 number(s) from %4 to %5")
                     .arg(line.text(), line.accessibleName())
                     .arg(count)
                     .arg(least)
                     .arg(most))};
    return *numbers;
}

} // namespace

LineOfSightPage::LineOfSightPage(FileQuestions questions, std::function<QString()> now, QWidget* parent)
    : Page(parent)
    , m_questions(std::move(questions))
    , m_now(std::move(now))
    , m_plot(new DrawnPlot(tr("Line of sight"), {320, 180}))
    , m_causes(testTable("sightCauses", tr("Causes")))
    , m_words(new QLabel)
{
    setObjectName(QStringLiteral("lineOfSightPage"));
    build();
    showBudget();
}

LineOfSightPage::~LineOfSightPage()
{
    for (auto* line : findChildren<QLineEdit*>())
        line->disconnect(this);
}

QLineEdit* LineOfSightPage::addLine(QFormLayout& form, const QString& title, const char* name, const QString& text)
{
    auto* line = new QLineEdit(text);
    line->setObjectName(QString::fromLatin1(name));
    line->setAccessibleName(title);
    form.addRow(title + QLatin1Char(':'), line);
    connect(line, &QLineEdit::textChanged, this, &LineOfSightPage::showBudget);
    return line;
}

QPushButton* LineOfSightPage::addIron(QFormLayout& form, const QString& title, const char* name, SensorModel& iron)
{
    auto* button = new QPushButton(tr("open a model…"));
    button->setObjectName(QString::fromLatin1(name));
    button->setToolTip(tr("A Model JSON of what iron is left in its headings; cancel the question to take it away"));
    form.addRow(title + QLatin1Char(':'), button);
    connect(button, &QPushButton::clicked, this, [this, button, &iron] { chooseIron(*button, iron); });
    return button;
}

void LineOfSightPage::chooseIron(QPushButton& button, SensorModel& iron)
{
    const QString path = m_questions.open(tr("Open a sensor model"), tr("Sensor model (*.json)"));
    if (path.isEmpty()) {
        iron = SensorModel();
        button.setText(tr("open a model…"));
    } else if (const auto setup = readModelJsonFile(path.toStdString())) {
        iron = setup->model;
        button.setText(QFileInfo(path).fileName());
    } else {
        emit failed(messageOf(setup.error()));
        return;
    }
    showBudget();
}

void LineOfSightPage::build()
{
    setTitle(tr("Line of sight of a helmet"));
    auto* left = new QWidget;
    auto* form = new QFormLayout(left);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_field = addLine(*form, tr("Earth's field (nT), dip (° down +)"), "sightField", QStringLiteral("50000, 67"));
    m_aircraft = addLine(*form, tr("Aircraft: magnetic heading, pitch, roll (°)"), "sightAircraft", QStringLiteral("0, 0, 0"));
    m_look = addLine(*form, tr("Looking: azimuth, elevation, roll of the helmet (°)"), "sightLook", QStringLiteral("30, 0, 0"));
    m_noise = addLine(*form, tr("Noise of an axis: aircraft, helmet (nT)"), "sightNoise", QStringLiteral("50, 50"));
    m_tilt = addLine(*form, tr("Pitch and roll sure to: aircraft, helmet (°)"), "sightTilt", QStringLiteral("0.1, 0.2"));
    addIron(*form, tr("Iron left at the aircraft's sensor"), "sightAircraftIron", m_aircraftIron);
    addIron(*form, tr("Iron left at the helmet's sensor"), "sightHelmetIron", m_helmetIron);
    m_cockpit = addLine(*form, tr("Field of the cockpit at the helmet: x, y, z (nT)"), "sightCockpit", QStringLiteral("0, 0, 0"));
    m_turret = addLine(*form, tr("Turret's mount: roll, pitch, yaw (°)"), "sightTurret", QStringLiteral("0, 0, 0"));
    m_turretError = addLine(*form, tr("Its mount sure to (°)"), "sightTurretError", QStringLiteral("0.05"));
    m_words->setObjectName(QStringLiteral("sightWords"));
    m_words->setWordWrap(true);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* results = new QSplitter(Qt::Vertical);
    results->addWidget(m_plot);
    results->addWidget(m_causes);
    results->setSizes({260, 260});
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_words);
    column->addWidget(results, 1);
    auto* splitter = new SideBySide;
    splitter->addWidget(new SidePanel(left));
    splitter->addWidget(right);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({kFormWidth, 2 * kFormWidth});
    body().addWidget(splitter, 1);
    setFocusProxy(m_field);
    follow(*m_plot);
}

Plot* LineOfSightPage::plot() const { return m_plot; }

Result<LineOfSightPage::Typed> LineOfSightPage::typed() const
{
    const auto field = numbersOf(*m_field, 2, -90, 200000), aircraft = numbersOf(*m_aircraft, 3, -360, 360),
               look = numbersOf(*m_look, 3, -180, 180), noise = numbersOf(*m_noise, 2, 0, 100000), tilt = numbersOf(*m_tilt, 2, 0, 45),
               cockpit = numbersOf(*m_cockpit, 3, -100000, 100000), turret = numbersOf(*m_turret, 3, -180, 180),
               turretError = numbersOf(*m_turretError, 1, 0, 45);
    for (const auto* one : {&field, &aircraft, &look, &noise, &tilt, &cockpit, &turret, &turretError})
        if (!*one)
            return one->error();
    const double size_nT = (*field)[0], dip_deg = (*field)[1];
    if (size_nT < 1000 || std::abs(dip_deg) > 90)
        return Error{ErrorCode::InvalidInput, said(tr("the Earth's field is 1000 nT or more, and its dip from −90° to 90°"))};
    const auto angle = [](const Result<std::vector<double>>& line, std::size_t place) { return toRadians((*line)[place]); };
    Typed all;
    all.given.field = MeridianField{size_nT * std::cos(toRadians(dip_deg)), size_nT * std::sin(toRadians(dip_deg))};
    all.given.aircraft = {m_aircraftIron, (*noise)[0], (*tilt)[0]};
    all.given.helmet = {m_helmetIron, (*noise)[1], (*tilt)[1]};
    all.given.aircraftAttitude = {MagneticHeading::fromDegrees((*aircraft)[0]), angle(aircraft, 1), angle(aircraft, 2)};
    all.given.turret = {angle(turret, 0), angle(turret, 1), angle(turret, 2)};
    all.given.turretError_deg = (*turretError)[0];
    all.given.cockpit_nT = {(*cockpit)[0], (*cockpit)[1], (*cockpit)[2]};
    all.look = {(*look)[0], (*look)[1]};
    all.helmetRoll_deg = (*look)[2];
    return all;
}

void LineOfSightPage::showBudget()
{
    if (!m_turretError)
        return; // not yet built
    const auto now = typed();
    if (!now) {
        refuse(messageOf(now.error()));
        return; // the last that stood stays
    }
    const SightBudget budget = sightBudget(now->given, now->look, now->helmetRoll_deg);
    QStringList warnings;
    for (const Message& warning : budget.warnings)
        warnings += toText(warning);
    say(warnings.join(QLatin1Char('\n')));
    m_words->setText(inAngleStyle(sightWords(budget)));
    fillFrom(*m_causes, sightTable(budget));
    m_plot->setPicture(sightDrawing(sightSweep(now->given)));
}

void LineOfSightPage::writeReport()
{
    const auto now = typed();
    if (!now) {
        refuse(messageOf(now.error()));
        return;
    }
    const QString path = m_questions.save(tr("Write the report"), QStringLiteral("line-of-sight.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    ReferenceSheet sheet = sightSheet(now->given, sightBudget(now->given, now->look, now->helmetRoll_deg));
    sheet.madeAtUtc = m_now();
    m_questions.write({path, [sheet, path](const Progress& progress) { return writeReferenceSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
