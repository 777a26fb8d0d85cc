#include "tests/ui/plots/swing/SamplePictures.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QSignalSpy>

#include <qwt_plot_curve.h>
#include <qwt_text.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/swing/ChartPlot.h"

using namespace lubberline;
using namespace lubberline::ui;

class ComponentsPlotTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_plot.reset(makeComponentsPlot());
        m_plot->resize(600, 480);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
        m_cartesian = m_plot->findChild<CartesianPlot*>("componentsPlot");
        QVERIFY(m_cartesian);
    }

    void eachComponentHasACurveOfItsOwnAmplitude()
    {
        const SwingPicture picture = samplePicture(16);
        m_plot->setPicture(picture);
        const ApproximateFit& fit = picture.analysis->approximate;
        const auto atEast = [this](const QString& title) { return curve(title)->sample(90).y(); };
        QVERIFY(std::abs(atEast("A") - toDegrees(*fit.of(Coefficient::A))) < 1e-9);
        QVERIFY(std::abs(atEast("B sin ψ′") - toDegrees(*fit.of(Coefficient::B))) < 1e-9);
        QVERIFY(std::abs(atEast("C cos ψ′")) < 1e-9);
        QVERIFY(std::abs(atEast("D sin 2ψ′")) < 1e-9);
        QVERIFY(std::abs(atEast("E cos 2ψ′") + toDegrees(*fit.of(Coefficient::E))) < 1e-9);
        QCOMPARE(m_cartesian->axisTitle(QwtAxis::XBottom).text(), QString("compass heading (°)"));
    }

    void coefficientsThatCannotBeToldAreNotListed()
    {
        m_plot->setPicture(samplePicture(4));
        QVERIFY(listed("B sin ψ′"));
        QVERIFY(!listed("D sin 2ψ′"));
        QCOMPARE(static_cast<int>(curve("D sin 2ψ′")->dataSize()), 0);
        m_plot->setPicture(samplePicture(8));
        QVERIFY(listed("D sin 2ψ′"));
    }

    void legendTogglesByClick()
    {
        m_plot->setPicture(samplePicture(8));
        auto* legend = m_plot->findChild<PlotLegend*>("plotLegend");
        QVERIFY(legend);
        QPoint onB(-1, -1);
        for (int x = 0; x < legend->width() && onB.x() < 0; x += 4) {
            const QPoint at(x, 10);
            const int entry = legendEntryAt(chart().legend(), legend->rect(), legend->font(), at);
            if (entry >= 0 && chart().legend()[static_cast<std::size_t>(entry)].title == "B sin ψ′")
                onB = at + QPoint(4, 0);
        }
        QVERIFY(onB.x() >= 0);
        QTest::mouseClick(legend, Qt::LeftButton, {}, onB);
        QVERIFY(!curve("B sin ψ′")->isVisible());
        QTest::mouseClick(legend, Qt::LeftButton, {}, onB);
        QVERIFY(curve("B sin ψ′")->isVisible());
    }

    void menuTogglesByKeyboard()
    {
        m_plot->setPicture(samplePicture(8));
        QTimer::singleShot(50, this, [] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            for (QAction* action : menu->actions()) {
                if (action->text() == "sum")
                    action->trigger();
            }
            menu->close();
        });
        QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(50, 50), m_plot->mapToGlobal(QPoint(50, 50)));
        QCoreApplication::sendEvent(m_plot.get(), &event);
        QVERIFY(!curve("sum")->isVisible());
    }

    void readingsStandAtTheirCompassHeadings()
    {
        const SwingPicture picture = samplePicture(8);
        m_plot->setPicture(picture);
        const auto places = chart().rowsOn(m_cartesian->canvas());
        QCOMPARE(places.size(), picture.readings.size());
        const double compass_deg = m_cartesian->valueAt(places[3].at).x();
        QVERIFY(std::abs(compass_deg - picture.readings[3].compass.degrees()) < 1e-6);
    }

private:
    QwtPlotCurve* curve(const QString& title)
    {
        for (QwtPlotItem* item : m_cartesian->itemList(QwtPlotItem::Rtti_PlotCurve)) {
            if (item->title().text() == title)
                return static_cast<QwtPlotCurve*>(item);
        }
        return nullptr;
    }
    bool listed(const QString& title)
    {
        for (const LegendEntry& entry : chart().legend()) {
            if (entry.title == title)
                return entry.present;
        }
        return false;
    }
    Chart& chart() { return *static_cast<ChartPlot*>(m_plot.get())->chart(); }

    std::unique_ptr<SwingPlot> m_plot;
    CartesianPlot* m_cartesian = nullptr;
};

QTEST_MAIN(ComponentsPlotTest)
#include "ComponentsPlotTest.moc"
