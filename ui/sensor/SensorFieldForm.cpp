#include "ui/sensor/SensorFieldForm.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include <cmath>

#include "core/angle/Angle.h"
#include "ui/earth/FieldText.h"
#include "ui/kit/FormField.h"
#include "ui/kit/Words.h"
#include "ui/sensor/ParameterCell.h"

namespace lubberline::ui {

namespace {

/// Middle latitudes, until something is chosen.
constexpr double kUsualHorizontal_nT = 20000, kUsualDip_deg = 65;
/// Within these a dip still tells Z; at a pole Z is typed.
constexpr double kMostDip_deg = 89.9;
constexpr double kMostEarthField_nT = 100000;

Result<Place> placeOf(const Site& site) { return makePlace(*site.latitude_deg, *site.longitude_deg, site.elevation_m.value_or(0)); }

} // namespace

SensorFieldForm::SensorFieldForm(const Clock& clock, QWidget* parent)
    : QWidget(parent)
    , m_choice(new QComboBox)
    , m_date(new QLineEdit(toText(clock.today())))
    , m_words(new QLabel)
    , m_field(MeridianField::fromDip(kUsualHorizontal_nT, toRadians(kUsualDip_deg)))
    , m_last(*m_field)
{
    m_choice->setObjectName(QStringLiteral("fieldSite"));
    m_choice->setAccessibleName(tr("Site of the field"));
    m_choice->addItem(tr("typed"));
    m_date->setObjectName(QStringLiteral("fieldDate"));
    m_date->setAccessibleName(tr("Date of the field"));
    m_date->setMaximumWidth(fontMetrics().horizontalAdvance(QStringLiteral("2026-11-23")) + 20);
    m_words->setObjectName(QStringLiteral("fieldWords"));
    m_words->setWordWrap(true);
    auto* head = new QHBoxLayout;
    head->addWidget(m_choice, 1);
    head->addWidget(m_date);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(head);
    layout->addWidget(buildCells());
    layout->addWidget(m_words);
    connect(m_choice, &QComboBox::activated, this, [this] {
        compute();
        emit changed();
    });
    connect(m_date, &QLineEdit::editingFinished, this, [this] {
        if (!m_date->isModified())
            return;
        m_date->setModified(false);
        compute();
        emit changed();
    });
    showField();
}

QWidget* SensorFieldForm::buildCells()
{
    const QString nT = QStringLiteral(" nT");
    m_horizontal
        = new ParameterCell({QStringLiteral("field_H"), tr("H"), tr("horizontal field H"), nT, 1, 0, 42000, 0, kMostEarthField_nT});
    m_dip = new ParameterCell({QStringLiteral("field_dip"), tr("dip"), tr("dip, positive down"), QStringLiteral("°"), 2, -kMostDip_deg,
        kMostDip_deg, -kMostDip_deg, kMostDip_deg});
    m_down
        = new ParameterCell({QStringLiteral("field_Z"), tr("Z"), tr("vertical field Z, positive down"), nT, 1, -68000, 68000, -1e8, 1e8});
    connect(m_horizontal, &ParameterCell::played, this, &SensorFieldForm::playHorizontal);
    connect(m_dip, &ParameterCell::played, this, &SensorFieldForm::playDip);
    connect(m_down, &ParameterCell::played, this, &SensorFieldForm::playDown);
    auto* cells = new QWidget;
    auto* layout = new QGridLayout(cells);
    layout->setContentsMargins(0, 0, 0, 0);
    int column = 0;
    for (ParameterCell* cell : {m_horizontal, m_dip, m_down}) {
        layout->addWidget(cell, 0, column++);
        connect(cell, &ParameterCell::settled, this, &SensorFieldForm::changed);
    }
    return cells;
}

const Site* SensorFieldForm::site() const
{
    const int choice = m_choice->currentIndex();
    return choice > 0 ? &m_sites[static_cast<std::size_t>(choice) - 1] : nullptr;
}

void SensorFieldForm::setSites(const std::vector<Site>& sites)
{
    const SiteId chosen = site() ? site()->id : SiteId();
    m_sites.clear();
    m_choice->clear();
    m_choice->addItem(tr("typed"));
    for (const Site& one : sites) {
        if (!one.latitude_deg || !one.longitude_deg)
            continue;
        m_sites.push_back(one);
        m_choice->addItem(toText(one.name));
        if (one.id == chosen)
            m_choice->setCurrentIndex(m_choice->count() - 1);
    }
    if (chosen.valid())
        compute();
}

void SensorFieldForm::showSite(SiteId site, Date date)
{
    m_date->setText(toText(date));
    for (std::size_t i = 0; i < m_sites.size(); ++i)
        if (m_sites[i].id == site)
            m_choice->setCurrentIndex(static_cast<int>(i) + 1);
    compute();
}

void SensorFieldForm::showTyped(const MeridianField& field)
{
    m_choice->setCurrentIndex(0);
    m_last = field;
    compute();
}

std::variant<MeridianField, PlaceAndDate, TotalField> SensorFieldForm::stated() const
{
    if (const Site* chosen = site(); chosen && m_field)
        return PlaceAndDate{*placeOf(*chosen), m_date->text().trimmed().toStdString()};
    return m_last;
}

void SensorFieldForm::playHorizontal(double horizontal_nT)
{
    const double dip_deg = toDegrees(m_last.inclination_rad());
    const bool dipTellsZ = m_last.horizontal_nT > 0 && std::abs(dip_deg) <= kMostDip_deg;
    playTyped(dipTellsZ && horizontal_nT > 0 ? MeridianField::fromDip(horizontal_nT, toRadians(dip_deg))
                                             : MeridianField{horizontal_nT, m_last.down_nT});
}

void SensorFieldForm::playDip(double dip_deg) { playTyped(MeridianField::fromDip(m_last.horizontal_nT, toRadians(dip_deg))); }

void SensorFieldForm::playDown(double down_nT) { playTyped({m_last.horizontal_nT, down_nT}); }

void SensorFieldForm::playTyped(const MeridianField& field)
{
    m_choice->setCurrentIndex(0);
    m_last = field;
    compute();
    emit played();
}

void SensorFieldForm::compute()
{
    m_source = tr("typed");
    m_field = m_last;
    markRefused(*m_date, {});
    m_date->setEnabled(site());
    if (site()) {
        const auto date = parseDate(m_date->text(), false);
        const auto place = placeOf(*site());
        const auto stamp = !date ? Result<FieldStamp>(date.error())
            : !place             ? Result<FieldStamp>(place.error())
                                 : stampField(*place, *date);
        m_field = stamp ? Result<MeridianField>(stamp->field.meridian()) : Result<MeridianField>(stamp.error());
        if (stamp)
            m_source = toText(stamp->model);
        else
            markRefused(*m_date, messageOf(stamp.error()));
    }
    if (m_field)
        m_last = *m_field;
    showField();
}

void SensorFieldForm::showField()
{
    m_horizontal->setValue(m_last.horizontal_nT);
    m_dip->setValue(toDegrees(m_last.inclination_rad()));
    m_down->setValue(m_last.down_nT);
    if (!m_field) {
        m_words->setText(tr("No field: %1.").arg(messageOf(m_field.error())));
        return;
    }
    QString words = tr("%1: F %2 nT").arg(m_source).arg(m_last.total_nT(), 0, 'f', 0);
    if (m_last.horizontal_nT < kCautionHorizontal_nT)
        words += tr(" · H below %1 nT: a compass is unreliable here").arg(kCautionHorizontal_nT);
    m_words->setText(words);
}

} // namespace lubberline::ui
