#include "ui/earth/EarthFieldPage.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

#include "db/stores/Stores.h"
#include "ui/earth/FieldValues.h"
#include "ui/kit/FormField.h"
#include "ui/kit/PlaceText.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/SideBySide.h"
#include "ui/plots/world/WorldFieldPlot.h"
#include "ui/plots/world/WorldFieldText.h"

namespace lubberline::ui {

namespace {

constexpr double kMapStep_deg = 2.0;
constexpr int kFormWidth = 390;
constexpr int kFirstLoaded = 3; ///< after the default and the two that are built in
constexpr std::array kElements{
    FieldElement::Declination, FieldElement::Inclination, FieldElement::Horizontal, FieldElement::Down, FieldElement::Total};

QLineEdit* line(const QString& name, const QString& placeholder)
{
    auto* edit = new QLineEdit;
    edit->setObjectName(name);
    edit->setPlaceholderText(placeholder);
    return edit;
}

QComboBox* choice(const QString& name)
{
    auto* box = new QComboBox;
    box->setObjectName(name);
    return box;
}

QLabel* wrappingLabel(const QString& name)
{
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QString titleOf(const FieldModel& model)
{
    return EarthFieldPage::tr("%1, %2 to %3")
        .arg(toText(model.name()), QString::number(model.firstYear()), QString::number(model.lastYear()));
}

bool hasPlace(const Site& site) { return site.latitude_deg && site.longitude_deg; }

} // namespace

EarthFieldPage::EarthFieldPage(db::Stores& stores, ChooseFile chooseFile, QWidget* parent)
    : Page(parent)
    , m_stores(stores)
    , m_chooseFile(std::move(chooseFile))
    , m_site(choice(QStringLiteral("fieldSite")))
    , m_latitude(line(QStringLiteral("fieldLatitude"), tr("51.55 N")))
    , m_longitude(line(QStringLiteral("fieldLongitude"), tr("21.89 E")))
    , m_height(line(QStringLiteral("fieldHeight"), tr("0")))
    , m_date(line(QStringLiteral("fieldDate"), tr("year-month-day, or 2026.5")))
    , m_model(choice(QStringLiteral("fieldModel")))
    , m_used(wrappingLabel(QStringLiteral("fieldUsed")))
    , m_values(new FieldValues)
    , m_element(choice(QStringLiteral("fieldElement")))
    , m_map(new WorldFieldPlot)
    , m_worker([this](Result<FieldGrid> grid) { takeMap(std::move(grid)); })
{
    setObjectName(QStringLiteral("earthFieldPage"));
    m_date->setText(toText(m_stores.clock().today()));
    build();
    connectInputs();
}

void EarthFieldPage::build()
{
    m_map->setObjectName(QStringLiteral("fieldMap"));
    for (const FieldElement element : kElements)
        m_element->addItem(fieldElementTitle(element));
    auto* choose = new QHBoxLayout;
    auto* title = new QLabel(tr("Ma&p of:"));
    title->setBuddy(m_element);
    choose->addWidget(title);
    choose->addWidget(m_element, 1);
    choose->addStretch(1);
    auto* map = new QWidget;
    auto* right = new QVBoxLayout(map);
    right->setContentsMargins(0, 0, 0, 0);
    right->addLayout(choose);
    right->addWidget(m_map, 1);
    auto* across = new SideBySide;
    across->addWidget(new SidePanel(buildForm()));
    across->addWidget(map);
    across->setStretchFactor(1, 1);
    across->setSizes({kFormWidth, 2 * kFormWidth});
    body().addWidget(across, 1);
    setFocusProxy(m_site);
}

QWidget* EarthFieldPage::buildForm()
{
    m_values->setObjectName(QStringLiteral("fieldTable"));
    m_model->addItems({tr("WMM in its years, else IGRF"), QStringLiteral("WMM2025"), QStringLiteral("IGRF-14"), tr("From a file …")});
    m_model->setToolTip(tr("Coefficient files: WMM and WMMHR (.COF), tables of the IGRF"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Site:"), m_site);
    form->addRow(tr("&Latitude:"), m_latitude);
    form->addRow(tr("L&ongitude:"), m_longitude);
    form->addRow(tr("&Height (m):"), m_height);
    form->addRow(tr("&Date (UTC):"), m_date);
    form->addRow(tr("&Model:"), m_model);
    m_height->setToolTip(tr("Above the WGS84 ellipsoid; a height above the sea will do"));
    setTitle(tr("Earth's field"));
    messageLine().setObjectName(QStringLiteral("fieldMessage"));
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);
    column->addWidget(&messageLine()); // beside the fields that it speaks of
    column->addWidget(m_values);
    column->addWidget(m_used);
    column->addStretch();
    return left;
}

void EarthFieldPage::connectInputs()
{
    connect(m_site, &QComboBox::activated, this, &EarthFieldPage::takeSite);
    for (QLineEdit* edit : {m_latitude, m_longitude, m_height})
        connect(edit, &QLineEdit::editingFinished, this, [this, edit] {
            if (edit->isModified())
                typedPlace();
            edit->setModified(false);
        });
    connect(m_date, &QLineEdit::editingFinished, this, &EarthFieldPage::recompute);
    connect(m_model, &QComboBox::activated, this, &EarthFieldPage::takeModel);
    connect(m_element, &QComboBox::activated, this, &EarthFieldPage::recompute);
    connect(m_map, &WorldFieldPlot::placeClicked, this, [this](double latitude_deg, double longitude_deg) {
        const auto hundredths = [](double value_deg) { return std::round(value_deg * 100) / 100; };
        m_latitude->setText(latitudeToType(hundredths(latitude_deg)));
        m_longitude->setText(longitudeToType(hundredths(longitude_deg)));
        typedPlace();
    });
    follow(*m_map);
}

void EarthFieldPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    loadSites();
    const bool nothingTyped = m_latitude->text().isEmpty() && m_longitude->text().isEmpty();
    if (nothingTyped && !m_sites.empty())
        takeSite(1);
    else
        recompute();
}

/// What was chosen stays chosen, as long as the site is there.
void EarthFieldPage::loadSites()
{
    auto sites = m_stores.sites.sites();
    if (!sites)
        emit failed(messageOf(sites.error()));
    m_sites = sites ? std::move(sites.value()) : std::vector<Site>();
    std::erase_if(m_sites, [](const Site& site) { return !hasPlace(site); });
    m_site->clear();
    m_site->addItem(tr("as typed below"));
    for (const Site& site : m_sites)
        m_site->addItem(toText(site.name));
    const auto known = std::find_if(m_sites.begin(), m_sites.end(), [this](const Site& site) { return toText(site.name) == m_label; });
    m_site->setCurrentIndex(known == m_sites.end() ? 0 : static_cast<int>(known - m_sites.begin()) + 1);
}

void EarthFieldPage::takeSite(int index)
{
    m_site->setCurrentIndex(index);
    m_label = index > 0 ? m_site->itemText(index) : QString();
    if (index > 0) {
        const Site& site = m_sites[static_cast<std::size_t>(index) - 1];
        typePlace({*site.latitude_deg, *site.longitude_deg, site.elevation_m.value_or(0.0)});
    }
    recompute();
}

void EarthFieldPage::typedPlace()
{
    m_site->setCurrentIndex(0);
    m_label.clear();
    recompute();
}

void EarthFieldPage::typePlace(const Place& place)
{
    m_latitude->setText(latitudeToType(place.latitude_deg));
    m_longitude->setText(longitudeToType(place.longitude_deg));
    m_height->setText(QString::number(place.height_m, 'f', 0));
}

void EarthFieldPage::showPlace(const QString& label, const Place& place, const QString& date)
{
    m_label = label;
    typePlace(place);
    m_date->setText(date.isEmpty() ? toText(m_stores.clock().today()) : date);
    if (!isVisible())
        return; // showEvent() goes on
    loadSites();
    recompute();
}

void EarthFieldPage::takeModel(int index)
{
    if (index == m_model->count() - 1) {
        loadModel();
        return;
    }
    m_modelBefore = index;
    recompute();
}

void EarthFieldPage::loadModel()
{
    m_model->setCurrentIndex(m_modelBefore);
    const QString path = m_chooseFile(tr("Coefficients of the Earth's field"), tr("Coefficients (*.COF *.cof *.txt);;All files (*)"));
    if (path.isEmpty())
        return;
    const auto model = readFieldModel(path.toStdString());
    if (!model) {
        emit failed(messageOf(model.error()));
        return;
    }
    m_loaded.push_back(*model);
    m_modelBefore = m_model->count() - 1;
    m_model->insertItem(m_modelBefore, titleOf(*model));
    m_model->setCurrentIndex(m_modelBefore);
    recompute();
}

Result<FieldModel> EarthFieldPage::chosenModel(double year) const
{
    switch (m_model->currentIndex()) {
    case 0: return defaultFieldModel(year);
    case 1: return wmm2025();
    case 2: return igrf14();
    default: return m_loaded[static_cast<std::size_t>(m_model->currentIndex() - kFirstLoaded)];
    }
}

/// Each line that is refused is marked, and says why.
Result<Place> EarthFieldPage::readPlace()
{
    const auto latitude_deg = parseLatitude_deg(m_latitude->text());
    const auto longitude_deg = parseLongitude_deg(m_longitude->text());
    const auto height_m = parseHeight_m(m_height->text());
    const auto mark = [](QLineEdit& edit, const Result<double>& value) { markRefused(edit, value ? QString() : messageOf(value.error())); };
    mark(*m_latitude, latitude_deg);
    mark(*m_longitude, longitude_deg);
    mark(*m_height, height_m);
    for (const auto* value : {&latitude_deg, &longitude_deg, &height_m})
        if (!*value)
            return value->error();
    return makePlace(*latitude_deg, *longitude_deg, *height_m);
}

FieldElement EarthFieldPage::element() const { return kElements[static_cast<std::size_t>(m_element->currentIndex())]; }

void EarthFieldPage::recompute()
{
    const bool noPlace = m_latitude->text().trimmed().isEmpty() && m_longitude->text().trimmed().isEmpty();
    const auto place
        = noPlace ? Result<Place>(Error{ErrorCode::InvalidInput, said(tr("Pick a site, or type latitude and longitude."))}) : readPlace();
    const auto year = decimalYear(m_date->text().trimmed().toStdString());
    markRefused(*m_date, year ? QString() : messageOf(year.error()));
    const auto model = year ? chosenModel(*year) : Result<FieldModel>(year.error());
    m_map->setPlace(place ? std::optional(*place) : std::nullopt, !place || !m_label.isEmpty() ? m_label : placeText(*place));
    m_values->showNothing();
    m_used->setText(model ? titleOf(*model) : QString());
    if (!model) {
        refuse(messageOf(model.error()));
        return;
    }
    showField(*model, place, *year);
    updateMap(*model, *year);
}

/// Near a magnetic pole the figures are shown with the refusal: the field is known there, it is the compass that tells nothing.
void EarthFieldPage::showField(const FieldModel& model, const Result<Place>& place, double year)
{
    const auto answer = place ? model.evaluate(*place, year) : Result<FieldAnswer>(place.error());
    if (!answer) {
        refuse(messageOf(answer.error()));
        return;
    }
    m_values->showAnswer(*answer);
    const auto compass = fieldForCompass(model, *place, year);
    QStringList cautions;
    for (const auto& warning : answer->warnings)
        cautions.append(toText(warning));
    compass ? say(cautions.join(u'\n')) : refuse(messageOf(compass.error()));
}

void EarthFieldPage::updateMap(const FieldModel& model, double year)
{
    const Wish wish{&model.data(), year, element()};
    if (m_wished == wish || year < model.firstYear() || year > model.lastYear())
        return;
    m_wished = wish;
    m_worker.start([model, year, element = wish.element](
                       const Progress& progress) { return fieldGrid(model, year, element, kMapStep_deg, progress); });
}

void EarthFieldPage::takeMap(Result<FieldGrid> grid)
{
    if (grid) {
        m_map->setGrid(std::make_shared<const FieldGrid>(std::move(grid.value())));
    } else {
        m_wished.reset();
        emit failed(messageOf(grid.error()));
    }
}

} // namespace lubberline::ui
