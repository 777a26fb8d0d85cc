// The pages of the sensor in the Earth's field, and how the window reaches them.

#include <QAction>
#include <QLabel>
#include <QMenuBar>
#include <QStackedWidget>

#include "core/base/OutputFile.h"
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
        [this](const QString& title, const QString& suggestion, const QString& filter) { return askToSave(title, suggestion, filter); }};
}

QString MainWindow::askToSave(const QString& title, const QString& suggestion, const QString& filter)
{
    const QString path = m_services.dialogs.saveFile(this, title, suggestion, filter);
    if (path.isEmpty())
        return {};
    if (const auto allowed = checkOutput(path.toStdString(), db::filesOf(m_stores.location())); !allowed) {
        fail(messageOf(allowed.error()));
        return {};
    }
    return path;
}

void MainWindow::showSensor(CompassId id)
{
    leaveField();
    const bool same = m_sensorPage && m_sensorPage->compass() == id;
    showOn(
        m_sensorPage, same, [this] { return makeSensorPage(); }, [id](SensorPage& page) { return page.showCompass(id); });
}

void MainWindow::showIronBench(CompassId id)
{
    leaveField();
    const bool same = m_ironBenchPage && m_ironBenchPage->compass() == id;
    showOn(
        m_ironBenchPage, same, [this] { return makeIronBenchPage(); }, [id](IronBenchPage& page) { return page.showCompass(id); });
}

void MainWindow::showPrediction()
{
    leaveField();
    const SwingId id = m_swingPage->editor().id();
    showOn(
        m_predictionPage, false, [this] { return makePredictionPage(); }, [id](PredictionPage& page) { return page.showSwing(id); });
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

SensorPage* MainWindow::makeSensorPage()
{
    auto* page = new SensorPage(m_context, m_stack, fileQuestions());
    connect(page, &SensorPage::readOut, m_readOut, &QLabel::setText);
    connect(page, &SensorPage::failed, this, &MainWindow::fail);
    connect(page, &SensorPage::benchWanted, this, &MainWindow::showIronBench);
    return page;
}

IronBenchPage* MainWindow::makeIronBenchPage()
{
    auto* page = new IronBenchPage(m_context, m_stack, fileQuestions());
    connect(page, &IronBenchPage::readOut, m_readOut, &QLabel::setText);
    connect(page, &IronBenchPage::failed, this, &MainWindow::fail);
    return page;
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

PredictionPage* MainWindow::makePredictionPage()
{
    auto* page = new PredictionPage(m_stores);
    connect(page, &PredictionPage::readOut, m_readOut, &QLabel::setText);
    connect(page, &PredictionPage::failed, this, &MainWindow::fail);
    return page;
}

} // namespace lubberline::ui
