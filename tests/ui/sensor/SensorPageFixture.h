#pragma once
/// The sensor page on a compass with limits, with stores in memory and answers to its questions for files.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QTableWidget>
#include <QTest>
#include <QUndoStack>

#include "core/sensor/PoissonSmith.h"
#include "tests/db/TestStores.h"
#include "tests/ui/window/Typing.h"
#include "ui/kit/Words.h"
#include "ui/plots/map/MapChart.h"
#include "ui/plots/map/MapPlot.h"
#include "ui/sensor/SensorEditor.h"
#include "ui/sensor/SensorPage.h"

namespace lubberline::ui {

inline SensorModel someIron()
{
    SensorModel model;
    model.softIron << 0.02, -0.01, 0.03, 0.015, -0.02, 0.01, 0.01, 0.02, -0.04;
    model.hardIron_nT = {1200, -800, 300};
    Circuit light;
    light.name = "landing light";
    light.field_nT_per_A = {40, -25, 10};
    light.current_A = 20;
    model.circuits.push_back(light);
    return model;
}

/// A compass with limits of 10°, and the page on it.
struct OpenPage {
    test::TestStores stores;
    CompassId compass;
    QStringList errors;
    QString answer; ///< to all questions for files
    EditContext context{stores, [this](const Error& error) { errors += messageOf(error); }};
    QUndoStack stack;
    std::unique_ptr<SensorPage> page;

    OpenPage()
    {
        AircraftType type;
        type.name = "Su-22";
        Aircraft aircraft;
        aircraft.type = *stores.save(type);
        aircraft.registration = "3713";
        LimitsProfile limits;
        limits.name = "25.1327";
        limits.document = "14 CFR 25.1327";
        limits.maxDeviation_deg = 10.0;
        CompassSystem standby;
        standby.name = "standby compass";
        standby.aircraft = *stores.save(aircraft);
        standby.limits = *stores.save(limits);
        compass = *stores.save(standby);
    }
    SensorRecord add(const std::string& name, const SensorModel& model)
    {
        SensorRecord sensor;
        sensor.compass = compass;
        sensor.name = name;
        sensor.model = model;
        sensor.id = *stores.save(sensor);
        return *stores.sensors.sensor(sensor.id);
    }
    SiteId addSite(const std::string& name, double latitude_deg, double longitude_deg)
    {
        Site site;
        site.name = name;
        site.latitude_deg = latitude_deg;
        site.longitude_deg = longitude_deg;
        return *stores.save(site);
    }
    /// Every 30°, as the model reads there in the field of the day.
    SwingId addSwing(SiteId site, Date date, const SensorModel& model)
    {
        Swing swing;
        swing.compass = compass;
        swing.site = site;
        swing.date = date;
        const SwingId empty = *stores.swings.add(swing);
        const auto stamped = *stores.swings.record(empty);
        for (int heading_deg = 0; heading_deg < 360; heading_deg += 30) {
            Reading reading;
            reading.magnetic = MagneticHeading::fromDegrees(heading_deg);
            reading.compass = readSensor(model, stamped.swing.field->field.meridian(), {*reading.magnetic}).compass;
            static_cast<void>(*stores.swings.insertReading(empty, heading_deg / 30, reading));
        }
        return empty;
    }
    void open()
    {
        const auto ask = [this](auto&&...) { return answer; };
        page = std::make_unique<SensorPage>(context, stack, FileQuestions{ask, ask});
        QObject::connect(page.get(), &SensorPage::failed, page.get(), [this](const QString& message) { errors += message; });
        page->resize(1100, 660);
        page->show();
        QApplication::setActiveWindow(page.get());
        QVERIFY(page->showCompass(compass).ok());
        QApplication::processEvents();
    }
    template <class Widget>
    Widget& find(const char* name)
    {
        return in<Widget>(*page, name);
    }
    void type(const char* name, const QString& text)
    {
        auto& spin = find<QDoubleSpinBox>(name);
        spin.setFocus();
        spin.selectAll();
        QTest::keyClicks(&spin, text);
        QTest::keyClick(&spin, Qt::Key_Return);
        QApplication::processEvents();
    }
    void choose(const char* name, int index)
    {
        auto& box = find<QComboBox>(name);
        box.setCurrentIndex(index);
        emit box.activated(index);
        QApplication::processEvents();
    }
    SensorModel stored() { return stores.whole().sensors.front().model; }
    const MapPicture& picture() { return page->findChild<MapPlot*>()->chart()->picture(); }
    QString cell(Coefficient coefficient, int column)
    {
        return find<QTableWidget>("smithTerms").item(static_cast<int>(indexOf(coefficient)), column)->text();
    }
};

/// Every value, held against the plain formula of core.
inline void compareMap(const DeviationMap& map, const SensorModel& model, const MeridianField& field)
{
    DeviationMap plain;
    computeMapPlainly(responseOf(model), field, map.request, plain);
    QCOMPARE(map.deviation_rad.size(), plain.deviation_rad.size());
    for (std::size_t i = 0; i < plain.deviation_rad.size(); ++i) {
        QCOMPARE(map.defined[i], plain.defined[i]);
        const double apart_rad = std::remainder(map.deviation_rad[i] - plain.deviation_rad[i], 2 * kPi);
        QVERIFY2(std::abs(apart_rad) < 1e-12, qPrintable(QString::number(apart_rad)));
    }
}

} // namespace lubberline::ui
