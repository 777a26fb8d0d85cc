#pragma once
/// The main window: the fleet at the left, the page of what is chosen at the right, messages above it that stay until
/// dismissed. Pages and plots are made when they are first needed; nothing is read from storage before the first paint.

#include <QMainWindow>
#include <QStackedWidget>
#include <QUndoStack>

#include <functional>
#include <utility>

#include "core/angle/AngleText.h"
#include "ui/fleet/FleetModel.h"
#include "ui/intake/ImportFile.h"
#include "ui/kit/Dialogs.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/FileQuestions.h"
#include "ui/plots/base/AsksToSave.h"
#include "ui/window/Recovery.h"
#include "ui/window/Transfers.h"

class QAction;
class QLabel;
class QMenu;
class QSettings;

namespace lubberline::ui {

class AircraftPage;
struct CardInput;
class DueWatch;
class DuePage;
class EarthFieldPage;
class ElectricalPage;
class FleetPanel;
class GuidedPage;
class MessagePanel;
class NamingStrip;
class NewSwingPage;
class NmeaImportPage;
class OverviewPage;
class InstrumentsPage;
class IronBenchPage;
class PredictionPage;
class ProgressStrip;
class SensorPage;
class SitesPage;
class StartPage;
class SwingPage;

/// What the window needs from outside besides stores.
struct WindowServices {
    Dialogs& dialogs;
    QSettings& settings;
    std::function<void()> openDemonstration;                 ///< the first of the three choices of an empty database
    std::function<Result<void>(const QString& path)> backup; ///< may be empty: then there is no Backup
    QStringList recoveryFiles = {};                          ///< where what cannot be stored is kept; none: nowhere
};

class MainWindow : public QMainWindow, public AsksToSave {
    Q_OBJECT

public:
    MainWindow(db::Stores& stores, WindowServices services);
    ~MainWindow() override;

    /// Shows the page of an item and marks it in the tree.
    void go(const FleetItem& item);
    void importFile(const QString& path, const CsvParticulars& particulars = {});
    /// Every file that the window writes is asked for here: what the database keeps, and what takes no file, is refused with a message.
    QString askToSave(const QString& title, const QString& suggestion, const QString& filter) override;
    [[nodiscard]] QUndoStack& undoStack() { return m_stack; }
    [[nodiscard]] MessagePanel& messages() { return *m_messages; }

public slots:
    void fail(const QString& message);

signals:
    void firstPainted();
    void importFinished();

protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    // MainWindow.cpp: parts and navigation
    void buildParts();
    void buildStatusBar();
    void populate();
    void showHome();
    void showSwing(SwingId id);
    void showAircraft(AircraftId id, CompassId compass);
    void showNewSwing();
    void turnTo(QWidget& page);
    void failWith(const Error& error);
    void afterFleetChange();
    void leaveRemovedSwing();
    void leaveField(); ///< what is being typed is stored before something else happens
    void showSaved(bool saved);
    /// A page owns one record: for another one it is made anew, and whatever was typed or opened on the old page is gone with it.
    /// `show(page)` puts the record on it; when that fails what was shown stays. @return whether the record is shown
    template <class Page, class Make, class Show>
    bool showOn(Page*& place, bool ofSameRecord, Make make, Show show);
    void retire(QWidget* page); ///< takes it out of the window at once
    SwingPage* makeSwingPage();
    AircraftPage* makeAircraftPage();
    OverviewPage& overviewPage();
    StartPage& startPage();
    NewSwingPage* makeNewSwingPage();
    [[nodiscard]] bool swingShown() const;

    // MainWindowModels.cpp: the pages of the sensor in the Earth's field
    void buildModelMenu();
    void showSensor(CompassId id);
    void showIronBench(CompassId id);
    void showEarthField();
    void showPrediction();
    SensorPage* makeSensorPage();
    IronBenchPage* makeIronBenchPage();
    EarthFieldPage& earthFieldPage();
    PredictionPage* makePredictionPage();
    [[nodiscard]] FileQuestions fileQuestions();
    [[nodiscard]] AircraftId aircraftShown() const;
    [[nodiscard]] CompassId compassShown() const;

    // MainWindowRamp.cpp: the work on the ramp
    void showGuided();
    void beginGuided(CompassId compass);
    void takeUpGuided(SwingId swing);
    GuidedPage* makeGuidedPage();
    void watchDue();
    void offerRecovery();
    void keepElsewhere(const SwingRecord& record, std::variant<LostStep, LostReading> what);
    void showDue();
    DuePage& duePage();
    void showSites();
    void showInstruments();
    void showElectrical();
    void showNmeaImport();
    void makeSwing(Swing swing); ///< of readings that a page has made
    /// Made on first use, with its messages and read-out wired.
    template <class Page, class Make>
    Page& pageOf(Page*& place, Make make);
    template <class Page>
    Page* wired(Page* page);
    [[nodiscard]] bool guidedOpen(SwingId id);
    [[nodiscard]] std::string nowUtc() const;

    // MainWindowActions.cpp: menus, toolbar
    QAction* addCommand(QMenu& menu, const QString& text, const QKeySequence& keys, const std::function<void()>& act, const QString& name);
    void buildActions();
    void buildFileMenu();
    void buildEditMenu();
    void buildSwingMenu();
    void buildFleetMenu();
    void buildViewMenu();
    void buildHelpMenu();
    void buildToolBar();
    void updateActions();
    void undo();
    void redo();
    void showEdited(int command);

    // MainWindowFiles.cpp: documents, import, export
    void chooseImport();
    void finishTransfer(const Result<TransferOutcome>& outcome);
    void startTransfer(const QString& what, const Transfer& transfer);
    void exportExchange(bool wholeFleet);
    void writeReportFile();
    void previewReport();
    [[nodiscard]] Result<CardInput> cardShown(int step_deg);
    void writeCardFile(int step_deg);
    void writeJobCardFile();
    void write1613File();
    void previewCard();
    void backUp();
    void removeDraft();
    void report(const Result<void>& done, const QString& success);
    void applyAngleStyle(bool minutes);

    db::Stores& m_stores;
    WindowServices m_services;
    EditContext m_context;
    QUndoStack m_stack;
    Recovery m_recovery;
    Worker<TransferOutcome> m_transfer; ///< of a file, in or out
    QString m_importPath;               ///< of the import that is running
    AngleStyle m_style = AngleStyle::DecimalDegrees;

    FleetPanel* m_fleet = nullptr;
    MessagePanel* m_messages = nullptr;
    ProgressStrip* m_progress = nullptr;
    NamingStrip* m_naming = nullptr;
    QStackedWidget* m_pages = nullptr;
    StartPage* m_startPage = nullptr;
    OverviewPage* m_overviewPage = nullptr;
    AircraftPage* m_aircraftPage = nullptr;
    SwingPage* m_swingPage = nullptr;
    NewSwingPage* m_newSwingPage = nullptr;
    SensorPage* m_sensorPage = nullptr;
    IronBenchPage* m_ironBenchPage = nullptr;
    EarthFieldPage* m_earthFieldPage = nullptr;
    PredictionPage* m_predictionPage = nullptr;
    GuidedPage* m_guidedPage = nullptr;
    DuePage* m_duePage = nullptr;
    SitesPage* m_sitesPage = nullptr;
    InstrumentsPage* m_instrumentsPage = nullptr;
    ElectricalPage* m_electricalPage = nullptr;
    NmeaImportPage* m_nmeaPage = nullptr;
    DueWatch* m_dueWatch = nullptr;
    QLabel* m_saved = nullptr;
    QLabel* m_readOut = nullptr;

    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QAction* m_exclude = nullptr;
    QList<QAction*> m_writingActions; ///< need a database that can be written
    QList<QAction*> m_swingActions;   ///< need a swing on the page
    QList<QAction*> m_compassActions; ///< need a compass on the page
    QList<QAction*> m_draftActions;   ///< need a swing whose readings may be changed
    bool m_painted = false;
};

template <class Page, class Make, class Show>
bool MainWindow::showOn(Page*& place, bool ofSameRecord, Make make, Show show)
{
    Page* page = place && ofSameRecord ? place : make();
    if (const Result<void> shown = show(*page); !shown) {
        if (page != place)
            delete page;
        failWith(shown.error());
        return false;
    }
    if (page != place) {
        m_pages->addWidget(page);
        retire(std::exchange(place, page));
    }
    turnTo(*page);
    return true;
}

} // namespace lubberline::ui
