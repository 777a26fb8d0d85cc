#pragma once
/// How the window knows a page: its name, how it is made, its help topic, the commands that reach it or act on it, and what can be printed
/// or exported of it. Each folder of pages describes
/// its own; ui/window/Pages.cpp lists them.

#include <QKeySequence>
#include <QString>

#include <functional>
#include <vector>

#include "ui/kit/Page.h"
#include "ui/kit/PageContext.h"

namespace lubberline::ui {

enum class MenuId { File, Edit, Swing, Fleet, Model, View, Help };

struct Command {
    MenuId menu;
    int place; ///< in the menu, rising; a line is drawn between hundreds
    QString text;
    QKeySequence keys;
    QString name; ///< of the action
    std::function<void(Page& shown)> act;
    bool (*needs)(const Shown&) = nullptr; ///< when it can be used; none: always
    QString submenu = {};                  ///< its title, where it stands in one
};

[[nodiscard]] inline bool needsWriting(const Shown& shown) { return shown.writable; }
[[nodiscard]] inline bool needsAircraft(const Shown& shown) { return shown.aircraft.valid(); }
[[nodiscard]] inline bool needsCompass(const Shown& shown) { return shown.compass.valid(); }
[[nodiscard]] inline bool needsSwing(const Shown& shown) { return shown.swing.valid(); }
[[nodiscard]] inline bool needsDraft(const Shown& shown) { return shown.editable; }
[[nodiscard]] inline bool needsPlot(const Shown& shown) { return shown.plot; }
[[nodiscard]] inline bool needsType(const Shown& shown) { return shown.writable && shown.type.valid(); }
[[nodiscard]] inline bool needsAircraftToChange(const Shown& shown) { return shown.writable && shown.aircraft.valid(); }
[[nodiscard]] inline bool needsCompassToChange(const Shown& shown) { return shown.writable && shown.compass.valid(); }
[[nodiscard]] inline bool needsReading(const Shown& shown) { return shown.editable && shown.rowSelected; }

struct PageDescription {
    QString id;
    std::function<Page*()> make;
    QString help = {};                  ///< its topic: what it is for and how it is used, in two or three sentences (F1)
    std::vector<Command> commands = {}; ///< there always
    std::vector<Command> outputs = {};  ///< what can be printed or exported: in the menu File while the page is in front
    /// Whether it is the page of such a record when no page is named; the first that says so is taken.
    std::function<bool(const FleetItem&)> shows = {};
    std::function<void(Page&)> print = {}; ///< what Ctrl+P prints of it, with a preview; none: the page as it is seen
    bool focus = false;                    ///< the cursor goes into it whenever it is shown
};

} // namespace lubberline::ui
