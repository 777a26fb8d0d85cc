#pragma once
/// What a page is made of: the window's stores, undo stack, questions and clock, and what it may ask of the window.

#include <QSettings>
#include <QUndoStack>

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "ui/kit/Destination.h"
#include "ui/kit/Dialogs.h"
#include "ui/kit/EditContext.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Recovery.h"

namespace lubberline::ui {

class DueWatch;
class Preferences;
struct PageDescription;

struct PageContext {
    db::Stores& stores;
    EditContext& edits;
    QUndoStack& undo;
    QSettings& settings;
    Dialogs& dialogs;
    QWidget& window; ///< receives what a page tells until it is retired; parent of dialogs
    FileQuestions files;
    DueWatch* due = nullptr; ///< finds what is due in the background
    Preferences* preferences = nullptr;

    std::function<void(const Destination&)> go = {};
    std::function<void(const QString& page)> goBack = {}; ///< to a page as it was left; to the fleet where it shows nothing any more
    std::function<void(const QString&)> say = {};         ///< a message that is no failure
    std::function<void(const QString&)> fail = {};
    std::function<void(Swing)> makeSwing = {}; ///< stores one undoably and shows it
    /// What could not be stored; `waits`: because another program is writing, so that it is tried again.
    std::function<void(const SwingRecord&, std::variant<LostStep, LostReading>, bool waits)> keep = {};
    std::function<void()> leaveField = {}; ///< what is being typed is stored before something else happens
    std::function<void()> chooseImport = {};
    std::function<void()> openDemonstration = {};
    std::function<const std::vector<PageDescription>&()> pages = {}; ///< all that there are
    std::function<QString()> pageInFront = {};                       ///< PageDescription::id; empty before there is one
    std::function<void()> reopen = {};                               ///< the window anew; may be empty

    /// ISO 8601, UTC.
    [[nodiscard]] std::function<Date()> today() const
    {
        return [&stores = stores] { return stores.clock().today(); };
    }
};

} // namespace lubberline::ui
