#pragma once
/// The main window: the fleet at the left, the page of what is chosen at the right, messages above it that stay until
/// dismissed. Pages and plots are made when they are first needed; nothing is read from storage before the first paint.

#include <QMainWindow>
#include <QTimer>
#include <QUndoStack>

#include <functional>
#include <utility>

#include "ui/intake/ImportFile.h"
#include "ui/kit/MessagePanel.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Preferences.h"
#include "ui/plots/base/AsksToSave.h"
#include "ui/window/Trail.h"
#include "ui/window/Transfers.h"

class QAction;
class QLabel;
class QMenu;

namespace lubberline::ui {

class DueWatch;
class FleetPanel;
class NamingStrip;
class PageStack;
class Placement;
class ProgressStrip;

/// What the window needs from outside besides stores.
struct WindowServices {
    Dialogs& dialogs;
    QSettings& settings;
    std::function<void()> openDemonstration;                 ///< the first of the three choices of an empty database
    std::function<Result<void>(const QString& path)> backup; ///< may be empty: then there is no Backup
    QStringList recoveryFiles = {};                          ///< where what cannot be stored is kept; none: nowhere
    /// Another database in place of this window; `make`: a new one. Errors: those of opening it; then this window stays. May be empty.
    std::function<Result<void>(const QString& path, bool make)> openDatabase = {};
    /// A backup in place of this database, which is kept beside it; the window is opened anew. May be empty.
    std::function<Result<void>(const QString& backup)> restore = {};
    std::function<void()> reopen = {}; ///< this window anew, for what is chosen at its start; may be empty
    bool demonstration = false;        ///< the database is the demonstration fleet
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
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override; ///< the mouse's buttons for back and forward, wherever it points
    void keyPressEvent(QKeyEvent* event) override;

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
    void afterFleetChange();
    void leaveField(); ///< what is being typed is stored before something else happens
    void showSaved(bool saved);
    void watchDue();
    void makeSwing(Swing swing); ///< of readings that a page has made
    [[nodiscard]] Shown shown() const;

    // MainWindowElsewhere.cpp: what another window or a command stores
    void watchElsewhere();
    void lookElsewhere(); ///< it is shown
    void leaveRemoved();

    // MainWindowActions.cpp: menus, toolbar, undo
    void buildActions();
    void addViewChoices(QMenu& menu);
    [[nodiscard]] std::vector<Command> ownCommands();
    [[nodiscard]] std::vector<Command> plotCommands();
    void showOutputs();
    void addCommands(QMenu& menu, const std::vector<Command>& commands);
    QAction* addCommand(QMenu& menu, const Command& command);
    void buildToolBar();
    void updateActions();
    void undo();
    bool undoesWhatIsSigned(int command);
    void redo();
    void showEdited(int command);

    // MainWindowEdit.cpp: the menu Edit; what is chosen once for all
    void buildEditMenu(QMenu& menu);
    void applyPreferences();
    void setTextSize(int change_percent); ///< 0: as it comes
    void setFullScreen(bool full);

    // MainWindowDatabases.cpp: which database, its copies; print
    [[nodiscard]] std::vector<Command> databaseCommands();
    void addRecent(QMenu& file);
    void rememberDatabase();
    void openAnother(const QString& path, bool make);
    void goBackToOwn();
    void print();
    void saveCopy();
    void backUp();
    void restore();
    void writeBackup(const QString& path, std::function<void()> then = {});
    void tellWritten(const QString& message, const QString& path);

    // MainWindowRecovery.cpp: what could not be stored
    void offerRecovery();
    void putBack(const std::vector<LostEntry>& entries);
    void keepElsewhere(const SwingRecord& record, std::variant<LostStep, LostReading> what, bool waits);
    void tryWaiting();

    // MainWindowFiles.cpp: import, export
    void chooseImport();
    void write(const FileToWrite& file);
    void finishTransfer(const Result<TransferOutcome>& outcome);
    void askWhose(const QString& path);
    void startTransfer(const QString& what, const Transfer& transfer);
    void exportExchange(bool wholeFleet);
    void watchFile(const QString& path);
    [[nodiscard]] QString namedFor(const QString& suggestion) const;

    db::Stores& m_stores;
    WindowServices m_services;
    Preferences m_preferences;
    EditContext m_context;
    QUndoStack m_stack;
    Recovery m_recovery;
    std::vector<LostEntry> m_waiting; ///< kept while another program writes, an import of ours mostly
    QTimer m_tryAgain;
    Worker<TransferOutcome> m_transfer; ///< of a file, in or out
    QString m_importPath;               ///< of the import that is running
    QString m_asked;                    ///< the file that was asked for last, until it is told that it was written
    DueWatch* m_dueWatch;
    PageContext m_pageContext;

    FleetPanel* m_fleet = nullptr;
    MessagePanel* m_messages = nullptr;
    ProgressStrip* m_progress = nullptr;
    NamingStrip* m_naming = nullptr;
    PageStack* m_pages = nullptr;
    Placement* m_placement = nullptr;
    QLabel* m_saved = nullptr;
    QLabel* m_readOut = nullptr;

    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QAction *m_fullScreen = nullptr, *m_minutes = nullptr, *m_dark = nullptr;
    std::vector<std::pair<QAction*, bool (*)(const Shown&)>> m_needs; ///< when each can be used
    std::vector<std::pair<QAction*, QString>> m_outputs;              ///< and the page that each is of
    bool m_painted = false;
    Trail m_trail;
    std::vector<FleetItem> m_path; ///< that is marked in the tree
    QAction *m_back = nullptr, *m_forward = nullptr;
    bool m_takingOff = false; ///< edits that cannot be undone any more
    bool m_refused = false;   ///< storage has refused an edit
    bool m_leaving = false;   ///< a field, on the way to another page
};

} // namespace lubberline::ui
