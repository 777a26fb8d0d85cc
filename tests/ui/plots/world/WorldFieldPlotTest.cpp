#include "tests/ui/plots/swing/SamplePictures.h"

#include <QSignalSpy>
#include <QTemporaryDir>

#include <qwt_plot_canvas.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/world/WorldFieldChart.h"
#include "ui/plots/world/WorldFieldItem.h"
#include "ui/plots/world/WorldFieldPlot.h"
#include "ui/plots/world/WorldFieldText.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// The field of a dipole along the Earth's axis: tan I = 2 tan latitude, H = H₀ cos latitude; declination is put in by hand.
std::shared_ptr<FieldGrid> dipole(FieldElement element)
{
    auto grid = std::make_shared<FieldGrid>();
    grid->element = element;
    grid->model = "dipole";
    grid->year = 2026.5;
    grid->columns = 181;
    grid->rows = 91;
    for (int row = 0; row < grid->rows; ++row) {
        for (int column = 0; column < grid->columns; ++column) {
            const double latitude_rad = toRadians(grid->latitudeAt_deg(row)), longitude_deg = grid->longitudeAt_deg(column);
            if (element == FieldElement::Declination)
                grid->values.push_back(longitude_deg / 6);
            else if (element == FieldElement::Inclination)
                grid->values.push_back(toDegrees(std::atan2(2 * std::sin(latitude_rad), std::cos(latitude_rad))));
            else
                grid->values.push_back(30'000 * std::cos(latitude_rad));
        }
    }
    return grid;
}

} // namespace

class WorldFieldPlotTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_plot = std::make_unique<WorldFieldPlot>();
        m_plot->resize(800, 450);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
    }

    void isolinesLieWhereTheFieldHasTheirValue()
    {
        m_plot->setGrid(dipole(FieldElement::Inclination));
        const auto& lines = m_plot->chart()->item().isolines();
        QVERIFY(lines.size() >= 17); // ±80, …, 0
        for (const ContourLine& line : lines) {
            if (std::abs(line.level) > 60)
                continue; // linear between nodes of 2°
            for (const ContourPoint& point : line.points)
                QVERIFY(std::abs(toDegrees(std::atan(2 * std::tan(toRadians(point.y)))) - line.level) < 0.1);
        }
    }

    void isolinesAreLabelled()
    {
        m_plot->setGrid(dipole(FieldElement::Declination));
        m_plot->grab();
        const auto& labels = m_plot->chart()->item().labels();
        const auto has = [&](const QString& text) {
            return std::any_of(labels.begin(), labels.end(), [&](const ContourLabel& l) { return l.text == text; });
        };
        QVERIFY(has("+10°"));
        QVERIFY(has("−20°"));
        QVERIFY(has("0°"));
    }

    void readOutTellsPlaceAndValue()
    {
        const auto grid = dipole(FieldElement::Declination);
        QCOMPARE(worldReadOut(*grid, 52.2, 21), QString("52.2° N, 21.0° E: declination +3.5°"));
        QCOMPARE(worldReadOut(*grid, -33.9, -70.5), QString("33.9° S, 70.5° W: declination −11.8°"));
        QCOMPARE(worldReadOut(*dipole(FieldElement::Horizontal), 0, 0), QString("0.0°, 0.0°: horizontal field H 30000 nT"));
        m_plot->setGrid(grid);
        QSignalSpy read(m_plot.get(), &WorldFieldPlot::readOut);
        CartesianPlot& plot = m_plot->chart()->plot();
        QTest::mouseMove(plot.canvas(), plot.pixelOf({60, 30}).toPoint());
        QVERIFY(read.last().first().toString().contains("declination +10"));
    }

    void edgesOfTheWorldHaveValues()
    {
        const auto grid = dipole(FieldElement::Declination);
        QCOMPARE(gridValueAt(*grid, 90, 180), 30.0);
        QCOMPARE(gridValueAt(*grid, -90, -180), -30.0);
    }

    void aJumpOfDeclinationIsNotInterpolated()
    {
        auto grid = dipole(FieldElement::Declination);
        for (int row = 0; row < grid->rows; ++row) {
            for (int column = 0; column < grid->columns; ++column)
                grid->values[static_cast<std::size_t>(row) * grid->columns + column] = column <= 90 ? 175 : -175;
        }
        QCOMPARE(gridValueAt(*grid, 0, 0.5), 175.0);
        QCOMPARE(gridValueAt(*grid, 0, 1.5), -175.0);
        m_plot->setGrid(grid);
        QVERIFY(m_plot->chart()->item().isolines().empty());
    }

    void titleNamesElementUnitModelAndYear()
    {
        m_plot->setGrid(dipole(FieldElement::Horizontal));
        QCOMPARE(m_plot->chart()->plot().axisTitle(QwtAxis::XBottom).text(),
            QString("horizontal field H (nT), dipole, 2026.5\nequirectangular, equal scales"));
        QVERIFY(m_plot->chart()->plot().axisTitle(QwtAxis::YLeft).isEmpty()); // a low map has no room beside it
        QCOMPARE(m_plot->chart()->plot().axisScaleDraw(QwtAxis::XBottom)->label(-90).text(), QString("90° W"));
        QCOMPARE(m_plot->chart()->plot().axisScaleDraw(QwtAxis::YLeft)->label(0).text(), QString("0°"));
    }

    void labelsOfASmallMapDoNotCollide()
    {
        const auto longitude = [this](double at) { return m_plot->chart()->plot().axisScaleDraw(QwtAxis::XBottom)->label(at).text(); };
        QCOMPARE(longitude(-45), QString("45° W"));
        m_plot->resize(300, 200);
        QApplication::processEvents();
        QCOMPARE(longitude(-45), QString()); // every second or every third stays, by the font
        QCOMPARE(longitude(45), QString());
        QCOMPARE(longitude(0), QString("0°"));
    }

    void coastsAreDrawn()
    {
        // Between 50° S and 60° S, away from America, there is only sea; between 50° N and 60° N there is much land.
        m_plot->setGrid(nullptr);
        CartesianPlot& plot = m_plot->chart()->plot();
        const QImage image = plot.canvas()->grab().toImage();
        const auto inkBetween = [&](double south_deg, double north_deg) {
            const QRectF band = QRectF(plot.pixelOf({-30, north_deg}), plot.pixelOf({170, south_deg})).adjusted(2, 2, -2, -2);
            const QImage part = image.copy(band.toRect());
            int ink = 0;
            for (int y = 0; y < part.height(); ++y) {
                for (int x = 0; x < part.width(); ++x)
                    ink += part.pixelColor(x, y) != Qt::white && part.pixelColor(x, y) != coloursFor(m_plot->palette()).grid;
            }
            return ink;
        };
        QVERIFY2(inkBetween(50, 60) > inkBetween(-60, -50) + 200,
            qPrintable(QString("%1 %2").arg(inkBetween(50, 60)).arg(inkBetween(-60, -50))));
    }

    void placeIsMarked()
    {
        m_plot->setGrid(dipole(FieldElement::Declination));
        const QImage without = m_plot->grab().toImage();
        m_plot->setPlace(Place{52.2, 21, 0}, "EPWA");
        const QImage with = m_plot->grab().toImage();
        QVERIFY(with != without);
        const QPoint at = m_plot->chart()->plot().canvas()->mapTo(m_plot.get(), m_plot->chart()->plot().pixelOf({21, 52.2}).toPoint());
        QCOMPARE(with.pixelColor(at), coloursFor(m_plot->palette()).selected);
        m_plot->setPlace({}, {});
        QCOMPARE(m_plot->grab().toImage(), without);
    }

    void withoutAGridItSaysSo()
    {
        m_plot->setGrid(nullptr);
        QVERIFY(m_plot->chart()->plot().axisTitle(QwtAxis::XBottom).text().contains("being computed"));
        QVERIFY(inkOf(m_plot->grab().toImage()) > 500);
        QTemporaryDir folder;
        QVERIFY(m_plot->exportTo(folder.filePath("world.svg")));
    }

private:
    std::unique_ptr<WorldFieldPlot> m_plot;
};

QTEST_MAIN(WorldFieldPlotTest)
#include "WorldFieldPlotTest.moc"
