#pragma once
/// The main window: the fleet at the left, the page of what is chosen at the right, messages above it that stay until
/// dismissed. Pages and plots are made when they are first needed; nothing is read from storage before the first paint.

#include <QMainWindow>
#include <QUndoStack>

#include <functional>
#include <utility>

#include "ui/intake/ImportFile.h"
#include "ui/kit/PageDescription.h"
#include "ui/plots/base/AsksToSave.h"
#include "ui/window/Trail.h"
#include "ui/window/Transfers.h"

class QAction;
class QLabel;
class QMenu;

namespace lubberline::ui {

class DueWatch;
class FleetPanel;
class MessagePanel;
class NamingStrip;
class PageStack;
class ProgressStrip;

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
    bool eventFilter(QObject* object, QEvent* event) override; ///< the mouse's buttons for back and forward, wherever it points

private:
    // MainWindow.cpp: parts and navigation
    [[nodiscard]] PageContext contextOfPages();
    void buildParts();
    void buildCentre();
    void buildStatusBar();
    void populate();
    void navigate(const Destination& destination);
    void goBack(const QString& page);
    void choose(const FleetItem& item); ///< in the tree
    void step(int step);                ///< −1: back along what was shown, +1: forward
    void showPlace();                   ///< where the window is: in its title and in the tree
    void restorePlacement();
    void afterFleetChange();
    void leaveField(); ///< what is being typed is stored before something else happens
    void showSaved(bool saved);
    void watchDue();
    void watchElsewhere();
    void lookElsewhere(); ///< what another window or a command has stored is shown
    void offerRecovery();
    void keepElsewhere(const SwingRecord& record, std::variant<LostStep, LostReading> what);
    void makeSwing(Swing swing); ///< of readings that a page has made
    [[nodiscard]] Shown shown() const;

    // MainWindowActions.cpp: menus, toolbar, undo
    void buildActions();
    void buildEditMenu(QMenu& menu);
    void addViewChoices(QMenu& menu);
    [[nodiscard]] std::vector<Command> ownCommands();
    [[nodiscard]] std::vector<Command> plotCommands();
    [[nodiscard]] std::vector<Command> helpCommands();
    void help(); ///< the topic of the page in front
    void showOutputs();
    void addCommands(QMenu& menu, const std::vector<Command>& commands);
    QAction* addCommand(QMenu& menu, const Command& command);
    void buildToolBar();
    void updateActions();
    void undo();
    void redo();
    void showEdited(int command);

    // MainWindowFiles.cpp: import, export, backup
    void chooseImport();
    void finishTransfer(const Result<TransferOutcome>& outcome);
    void askWhose(const QString& path);
    void startTransfer(const QString& what, const Transfer& transfer);
    void exportExchange(bool wholeFleet);
    void backUp();

    db::Stores& m_stores;
    WindowServices m_services;
    EditContext m_context;
    QUndoStack m_stack;
    Recovery m_recovery;
    Worker<TransferOutcome> m_transfer; ///< of a file, in or out
    QString m_importPath;               ///< of the import that is running
    DueWatch* m_dueWatch;
    PageContext m_pageContext;

    FleetPanel* m_fleet = nullptr;
    MessagePanel* m_messages = nullptr;
    ProgressStrip* m_progress = nullptr;
    NamingStrip* m_naming = nullptr;
    PageStack* m_pages = nullptr;
    QLabel* m_saved = nullptr;
    QLabel* m_readOut = nullptr;

    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    std::vector<std::pair<QAction*, bool (*)(const Shown&)>> m_needs; ///< when each can be used
    std::vector<std::pair<QAction*, QString>> m_outputs;              ///< and the page that each is of
    bool m_painted = false;
    Trail m_trail;
    std::vector<FleetItem> m_path; ///< that is marked in the tree
    QAction *m_back = nullptr, *m_forward = nullptr;
};

} // namespace lubberline::ui
