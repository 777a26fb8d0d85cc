// The pages of the sensor in the Earth's field, and how the window reaches them.

#include <QAction>
#include <QLabel>
#include <QMenuBar>
#include <QStackedWidget>

#include "core/swing/SwingField.h"
#include "ui/bench/IronBenchPage.h"
#include "ui/earth/EarthFieldPage.h"
#include "ui/earth/PredictionPage.h"
#include "ui/kit/Words.h"
#include "ui/sensor/SensorPage.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingPage.h"
#include "ui/window/MainWindow.h"

namespace lubberline::ui {

void MainWindow::buildModelMenu()
{
    auto& menu = *menuBar()->addMenu(tr("&Model"));
    m_compassActions += addCommand(
        menu, tr("&Sensor model of this compass"), tr("Ctrl+L"), [this] { showSensor(compassShown()); }, "sensorModel");
    m_compassActions += addCommand(
        menu, tr("&Iron bench of this compass"), tr("Ctrl+Shift+B"), [this] { showIronBench(compassShown()); }, "ironBench");
    m_swingActions += addCommand(
        menu, tr("What it will read at another &base"), tr("Ctrl+B"), [this] { showPrediction(); }, "predict");
    addCommand(
        menu, tr("&Earth's field"), tr("Ctrl+Shift+F"), [this] { showEarthField(); }, "earthField");
}

FileQuestions MainWindow::fileQuestions()
{
    return {[this](const QString& title, const QString& filter) { return m_services.dialogs.openFile(this, title, filter); },
        [this](const QString& title, const QString& suggestion, const QString& filter) {
            return m_services.dialogs.saveFile(this, title, suggestion, filter);
        }};
}

void MainWindow::showSensor(CompassId id)
{
    leaveField();
    if (const auto shown = sensorPage().showCompass(id); !shown) {
        fail(messageOf(shown.error()));
        return;
    }
    turnTo(sensorPage());
}

void MainWindow::showIronBench(CompassId id)
{
    leaveField();
    if (const auto shown = ironBenchPage().showCompass(id); !shown) {
        fail(messageOf(shown.error()));
        return;
    }
    turnTo(ironBenchPage());
}

void MainWindow::showPrediction()
{
    leaveField();
    if (const auto shown = predictionPage().showSwing(m_swingPage->editor().id()); !shown) {
        fail(messageOf(shown.error()));
        return;
    }
    turnTo(predictionPage());
}

/// At the site and on the day of the swing that is shown, where these are known.
void MainWindow::showEarthField()
{
    leaveField();
    if (swingShown()) {
        const SwingRecord& record = m_swingPage->editor().record();
        const auto stamp = record.swing.field ? record.swing.field : stampFor(record.swing, record.site);
        if (stamp)
            earthFieldPage().showPlace(record.site ? toText(record.site->name) : QString(), stamp->place, toText(stamp->date));
    }
    turnTo(earthFieldPage());
}

SensorPage& MainWindow::sensorPage()
{
    if (m_sensorPage)
        return *m_sensorPage;
    m_sensorPage = new SensorPage(m_context, m_stack, fileQuestions());
    m_pages->addWidget(m_sensorPage);
    connect(m_sensorPage, &SensorPage::readOut, m_readOut, &QLabel::setText);
    connect(m_sensorPage, &SensorPage::failed, this, &MainWindow::fail);
    connect(m_sensorPage, &SensorPage::benchWanted, this, &MainWindow::showIronBench);
    return *m_sensorPage;
}

IronBenchPage& MainWindow::ironBenchPage()
{
    if (m_ironBenchPage)
        return *m_ironBenchPage;
    m_ironBenchPage = new IronBenchPage(m_context, m_stack, fileQuestions());
    m_pages->addWidget(m_ironBenchPage);
    connect(m_ironBenchPage, &IronBenchPage::readOut, m_readOut, &QLabel::setText);
    connect(m_ironBenchPage, &IronBenchPage::failed, this, &MainWindow::fail);
    return *m_ironBenchPage;
}

EarthFieldPage& MainWindow::earthFieldPage()
{
    if (m_earthFieldPage)
        return *m_earthFieldPage;
    m_earthFieldPage = new EarthFieldPage(m_stores, fileQuestions().open);
    m_pages->addWidget(m_earthFieldPage);
    connect(m_earthFieldPage, &EarthFieldPage::readOut, m_readOut, &QLabel::setText);
    connect(m_earthFieldPage, &EarthFieldPage::failed, this, &MainWindow::fail);
    return *m_earthFieldPage;
}

PredictionPage& MainWindow::predictionPage()
{
    if (m_predictionPage)
        return *m_predictionPage;
    m_predictionPage = new PredictionPage(m_stores);
    m_pages->addWidget(m_predictionPage);
    connect(m_predictionPage, &PredictionPage::readOut, m_readOut, &QLabel::setText);
    connect(m_predictionPage, &PredictionPage::failed, this, &MainWindow::fail);
    return *m_predictionPage;
}

} // namespace lubberline::ui
