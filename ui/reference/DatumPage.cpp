#include "ui/reference/DatumPage.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>

#include <cmath>

#include "core/angle/AngleText.h"
#include "core/base/Number.h"
#include "ui/kit/PlaceText.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/kit/fit/TableFit.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/report/forms/ReferenceSheet.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kDatumFormWidth = 340;

Result<void> takeSize(double& size, const QString& typed)
{
    const auto number = typedNumber(typed);
    if (!number || *number < 0 || *number > 1e6)
        return Error{ErrorCode::InvalidInput, said(DatumPage::tr("“%1” is no size; expected a number from 0").arg(typed))};
    size = *number;
    return {};
}

Result<void> takePlace(DatumInputs& inputs, Result<double> latitude, Result<double> longitude)
{
    for (const auto* angle : {&latitude, &longitude})
        if (!*angle)
            return angle->error();
    const auto place = makePlace(*latitude, *longitude);
    if (!place)
        return place.error();
    inputs.place = *place;
    return {};
}

QString timeWords(UtcTime time)
{
    const auto day = std::chrono::floor<std::chrono::days>(time);
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time - day).count();
    return QStringLiteral("%1T%2:%3:%4Z")
        .arg(toText(Date(std::chrono::year_month_day(day))))
        .arg(seconds / 3600, 2, 10, QChar('0'))
        .arg(seconds / 60 % 60, 2, 10, QChar('0'))
        .arg(seconds % 60, 2, 10, QChar('0'));
}

QString sizeWords(double size) { return toText(shortestNumber(size)); }

/// In degrees, as documents take them.
std::vector<TableRow> budgetRows(const ErrorBudget& budget)
{
    std::vector<TableRow> rows;
    for (const ErrorPart& part : budget.parts)
        rows.push_back({{toText(part.what), plainNumber(part.size_deg, 3)}});
    rows.push_back({{DatumPage::tr("in all"), plainNumber(budget.total_deg(), 3)}});
    return rows;
}

} // namespace

DatumPage::DatumPage(FileQuestions files, std::function<std::string()> nowUtc, QWidget* parent)
    : Page(parent)
    , m_files(std::move(files))
    , m_nowUtc(std::move(nowUtc))
    , m_fields([this](const DatumInputs& inputs, const QString&) { take(inputs); })
    , m_method(new QComboBox)
    , m_forms(new QStackedWidget)
    , m_headline(new QLabel)
    , m_lines(new QLabel)
    , m_budget(new QTableWidget(0, 2))
    , m_day(new DrawnPlot(tr("Sun over the day")))
{
    setObjectName(QStringLiteral("datumPage"));
    build();
    DatumInputs first;
    if (const auto now = readUtcTime(m_nowUtc()))
        first.time = *now;
    take(first);
}

void DatumPage::addSize(QFormLayout& form, const QString& title, const char* name, std::function<double&(DatumInputs&)> member)
{
    m_fields.addLine(
        form, title, QString::fromLatin1(name),
        [member](const DatumInputs& inputs) {
            DatumInputs copy = inputs;
            return sizeWords(member(copy));
        },
        [member](DatumInputs& inputs, const QString& typed) { return takeSize(member(inputs), typed); });
}

void DatumPage::addBearing(QFormLayout& form, const QString& title, const char* name, std::optional<double> DatumInputs::*member)
{
    m_fields.addLine(
        form, title, QString::fromLatin1(name),
        [member](const DatumInputs& inputs) { return inputs.*member ? sizeWords(*(inputs.*member)) : QString(); },
        [member](DatumInputs& inputs, const QString& typed) -> Result<void> {
            if (typed.trimmed().isEmpty()) {
                (inputs.*member).reset();
                return {};
            }
            const auto bearing = parseHeading_deg(typed.toStdString());
            if (!bearing)
                return bearing.error();
            inputs.*member = *bearing;
            return {};
        });
}

void DatumPage::addPlace(QFormLayout& form, const char* prefix)
{
    const QString name = QString::fromLatin1(prefix);
    m_fields.addLine(
        form, tr("&Latitude:"), name + QStringLiteral("Latitude"),
        [](const DatumInputs& inputs) { return latitudeToType(inputs.place.latitude_deg); },
        [](DatumInputs& inputs, const QString& typed) { return takePlace(inputs, parseLatitude_deg(typed), inputs.place.longitude_deg); });
    m_fields.addLine(
        form, tr("L&ongitude:"), name + QStringLiteral("Longitude"),
        [](const DatumInputs& inputs) { return longitudeToType(inputs.place.longitude_deg); },
        [](DatumInputs& inputs, const QString& typed) { return takePlace(inputs, inputs.place.latitude_deg, parseLongitude_deg(typed)); });
    m_fields.addLine(
        form, tr("&Time (UTC):"), name + QStringLiteral("Time"), [](const DatumInputs& inputs) { return timeWords(inputs.time); },
        [](DatumInputs& inputs, const QString& typed) -> Result<void> {
            const auto time = readUtcTime(typed.trimmed().toStdString());
            if (!time)
                return time.error();
            inputs.time = *time;
            return {};
        });
    m_fields
        .addLine(
            form, tr("&Variation (°, E +):"), name + QStringLiteral("Variation"),
            [](const DatumInputs& inputs) { return inputs.variation_deg ? signedNumber(*inputs.variation_deg, 2) : QString(); },
            [](DatumInputs& inputs, const QString& typed) -> Result<void> {
                if (typed.trimmed().isEmpty()) {
                    inputs.variation_deg.reset();
                    return {};
                }
                const auto variation = parseSignedAngle_deg(typed.toStdString());
                if (!variation)
                    return variation.error();
                inputs.variation_deg = *variation;
                return {};
            })
        ->setPlaceholderText(tr("by the model"));
}

void DatumPage::buildSun(QFormLayout& form)
{
    addPlace(form, "sun");
    m_fields.addChoice(
        form, tr("&Read is the bearing of:"), QStringLiteral("sunOf"), {tr("the shadow (pin)"), tr("the sun (astrocompass, sight)")},
        [](const DatumInputs& inputs) { return inputs.ofShadow ? 0 : 1; },
        [](DatumInputs& inputs, int choice) { inputs.ofShadow = choice == 0; });
    addBearing(form, tr("from the &nose, clockwise (°):"), "sunBearing", &DatumInputs::bearing_deg);
    addSize(form, tr("Error of the clock (s):"), "sunClock", [](DatumInputs& i) -> double& { return i.sighting.clock_s; });
    addSize(form, tr("of the position (km):"), "sunPosition", [](DatumInputs& i) -> double& { return i.sighting.position_km; });
    addSize(form, tr("of pin or level (°):"), "sunPlumb", [](DatumInputs& i) -> double& { return i.sighting.plumb_deg; });
    addSize(form, tr("of pointing (°):"), "sunPointing", [](DatumInputs& i) -> double& { return i.sighting.pointing_deg; });
    addSize(form, tr("of the variation (°):"), "sunVariationError", [](DatumInputs& i) -> double& { return i.variationError_deg; });
}

void DatumPage::buildGrid(QFormLayout& form)
{
    addPlace(form, "grid");
    m_fields.addLine(
        form, tr("True &heading (°):"), QStringLiteral("gridHeading"), [](const DatumInputs& i) { return sizeWords(i.heading_deg); },
        [](DatumInputs& i, const QString& typed) -> Result<void> {
            const auto heading = parseHeading_deg(typed.toStdString());
            if (!heading)
                return heading.error();
            i.heading_deg = *heading;
            return {};
        });
    m_fields.addLine(
        form, tr("&Meridian of grid north:"), QStringLiteral("gridMeridian"),
        [](const DatumInputs& i) { return longitudeToType(i.meridian_deg); },
        [](DatumInputs& i, const QString& typed) -> Result<void> {
            const auto meridian = parseLongitude_deg(typed);
            if (!meridian)
                return meridian.error();
            i.meridian_deg = *meridian;
            return {};
        });
    m_fields.addLine(
        form, tr("Steps of a variation &table (°):"), QStringLiteral("gridStep"),
        [](const DatumInputs& i) { return sizeWords(i.tableStep_deg); },
        [](DatumInputs& i, const QString& typed) -> Result<void> {
            const auto step = typedNumber(typed);
            if (!step || *step < 0.1 || *step > 30)
                return Error{
                    ErrorCode::InvalidInput, said(DatumPage::tr("“%1” are no steps of a table; expected 0.1 to 30 degrees").arg(typed))};
            i.tableStep_deg = *step;
            return {};
        });
}

void DatumPage::build()
{
    setTitle(tr("A datum anywhere"));
    m_method->setObjectName(QStringLiteral("datumMethod"));
    m_method->setAccessibleName(tr("Way to a heading"));
    m_method->addItems({tr("The sun (shadow pin, astrocompass)"), tr("Lined up on a runway"), tr("Transfer gyro"), tr("By synchro"),
        tr("Grid heading near a pole")});
    std::array<QFormLayout*, 5> forms{};
    for (QFormLayout*& form : forms) {
        auto* sheet = new QWidget;
        form = new QFormLayout(sheet);
        form->setContentsMargins(0, 0, 0, 0);
        m_forms->addWidget(sheet);
    }
    buildSun(*forms[0]);
    addBearing(*forms[1], tr("&Direction, magnetic (°):"), "runwayDirection", &DatumInputs::runway_deg);
    addSize(*forms[1], tr("Error of its published direction (°):"), "runwayPublished",
        [](DatumInputs& i) -> double& { return i.runway.published_deg; });
    addSize(
        *forms[1], tr("Nose and tail off the line by (m):"), "runwayOff", [](DatumInputs& i) -> double& { return i.runway.offCentre_m; });
    addSize(*forms[1], tr("Between both points (m):"), "runwayWheelbase", [](DatumInputs& i) -> double& { return i.runway.wheelbase_m; });
    addSize(*forms[2], tr("Error of &setting it (°):"), "gyroSetting", [](DatumInputs& i) -> double& { return i.gyro.setting_deg; });
    addSize(*forms[2], tr("of &reading it (°):"), "gyroReading", [](DatumInputs& i) -> double& { return i.gyro.reading_deg; });
    addSize(*forms[2], tr("Free &drift (°/h):"), "gyroDrift", [](DatumInputs& i) -> double& { return i.gyro.drift_deg_h; });
    addSize(*forms[2], tr("&Minutes since it was set:"), "gyroMinutes", [](DatumInputs& i) -> double& { return i.gyro.minutes; });
    addSize(
        *forms[3], tr("&One-cycle error, amplitude (°):"), "synchroOne", [](DatumInputs& i) -> double& { return i.synchro.oneCycle_deg; });
    addSize(
        *forms[3], tr("&Two-cycle error, amplitude (°):"), "synchroTwo", [](DatumInputs& i) -> double& { return i.synchro.twoCycle_deg; });
    buildGrid(*forms[4]);
    m_headline->setObjectName(QStringLiteral("datumHeadline"));
    m_lines->setObjectName(QStringLiteral("datumLines"));
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.3);
    m_headline->setFont(large);
    for (QLabel* label : {m_headline, m_lines}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    m_budget->setObjectName(QStringLiteral("datumBudget"));
    m_budget->setAccessibleName(tr("Parts of the error"));
    wrapHeadings(*m_budget);
    m_budget->setHorizontalHeaderLabels({tr("Part of the error"), tr("one standard deviation (°)")});
    m_budget->verticalHeader()->hide();
    m_budget->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    m_budget->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_budget->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_day->setObjectName(QStringLiteral("datumDay"));
    auto* now = new QPushButton(tr("Time of no&w"));
    now->setObjectName(QStringLiteral("datumNow"));
    auto* left = new QVBoxLayout;
    left->addWidget(m_method);
    left->addWidget(m_forms);
    left->addWidget(now);
    left->addStretch(1);
    auto* panel = new QWidget;
    panel->setLayout(left);
    auto* answers = new QWidget;
    auto* right = new QVBoxLayout(answers);
    right->setContentsMargins(0, 0, 0, 0);
    right->addWidget(m_headline);
    right->addWidget(m_lines);
    right->addWidget(m_budget);
    right->addWidget(m_day, 1);
    auto* across = new SideBySide;
    across->addWidget(new SidePanel(panel));
    across->addWidget(answers);
    across->setStretchFactor(1, 1);
    across->setSizes({kDatumFormWidth, 2 * kDatumFormWidth});
    body().addWidget(across, 1);
    follow(*m_day);
    setFocusProxy(m_method);
    connect(m_method, &QComboBox::currentIndexChanged, this, [this, now](int index) {
        m_forms->setCurrentIndex(index);
        now->setVisible(method() == DatumMethod::Sun || method() == DatumMethod::Grid);
        answer();
        emit stateChanged();
    });
    connect(now, &QPushButton::clicked, this, [this] {
        DatumInputs changed = inputs();
        if (const auto time = readUtcTime(m_nowUtc()))
            changed.time = *time;
        take(changed);
    });
}

DatumMethod DatumPage::method() const { return static_cast<DatumMethod>(m_method->currentIndex()); }
Plot* DatumPage::plot() const { return method() == DatumMethod::Sun ? m_day : nullptr; }

void DatumPage::take(const DatumInputs& inputs)
{
    m_fields.show(inputs, true);
    answer();
}

void DatumPage::answer()
{
    const auto told = answerOf(method(), inputs());
    m_budget->setRowCount(0);
    m_budget->setVisible(told && told->budget);
    m_day->setVisible(method() == DatumMethod::Sun);
    m_day->setPicture(sunDay(inputs()));
    if (!told) {
        m_headline->clear();
        m_lines->clear();
        refuse(messageOf(told.error()));
        return;
    }
    say(told->warnings.join(u'\n'));
    m_headline->setText(inAngleStyle(told->headline));
    m_lines->setText(inAngleStyle(told->lines.join(u'\n')));
    if (!told->budget)
        return;
    for (const TableRow& part : budgetRows(*told->budget)) {
        const int row = m_budget->rowCount();
        m_budget->insertRow(row);
        m_budget->setItem(row, 0, new QTableWidgetItem(part.cells[0]));
        auto* size = new QTableWidgetItem(inAngleColumn(part.cells[1]));
        size->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_budget->setItem(row, 1, size);
    }
    m_budget->setFixedHeight(heightOfRows(*m_budget, m_budget->rowCount()) + 2);
}

void DatumPage::writeReport()
{
    const QString path = m_files.save(tr("Report"), QStringLiteral("datum.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    ReferenceSheet sheet;
    sheet.title = tr("A datum away from a base");
    sheet.subject = m_method->currentText();
    sheet.text << m_headline->text() << m_lines->text().split(u'\n') << message().split(u'\n');
    if (method() == DatumMethod::Sun || method() == DatumMethod::Grid)
        sheet.text.prepend(QStringLiteral("%1 · %2").arg(placeText(inputs().place), timeWords(inputs().time)));
    if (method() == DatumMethod::Sun)
        sheet.pictures.push_back(
            {80, [day = sunDay(inputs())](QPainter& painter, const QRectF& rect) { renderDrawn(painter, rect, day); }});
    sheet.table = {tr("Parts of the error"),
        {{tr("Part"), {}, {}, 60, TableColumn::Align::Left}, {tr("Size"), tr("one standard deviation"), QStringLiteral("°"), 40}}, {}};
    if (const auto told = answerOf(method(), inputs()); told && told->budget)
        sheet.table.rows = budgetRows(*told->budget);
    sheet.madeAtUtc = QString::fromStdString(m_nowUtc());
    m_files.write({path, [sheet, path](const Progress& progress) { return writeReferenceSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
