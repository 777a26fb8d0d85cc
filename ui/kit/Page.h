#pragma once
/// What stands at the right of the window: everything that the window asks a page, and that a page tells the window.

#include <QWidget>

#include <vector>

#include "core/angle/AngleText.h"
#include "core/base/Result.h"
#include "ui/kit/Destination.h"

namespace lubberline::ui {

struct PageContext;
struct PageDescription;

/// What commands act upon; ids that are not valid: the page is of no such record.
struct Shown {
    AircraftId aircraft = {};
    CompassId compass = {};
    SwingId swing = {};
    bool editable = false;    ///< a swing whose readings may be changed
    bool rowSelected = false; ///< a reading is chosen
    bool writable = false;    ///< the database can be written; the window's to say

    /// The nearest of them as a place to go: compass, else aircraft.
    [[nodiscard]] FleetItem item() const;
};

class Page : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;
    ~Page() override;

    /// Puts a record on it. Errors: those of the stores, or that it shows no such record; what was shown stays then.
    virtual Result<void> open(const FleetItem& record);
    /// Whether it can open a record as it stands. A page owns one record: where this says no, the window makes the page anew, and
    /// whatever was typed or opened on the old one is gone with it. A list, which owns none, says yes.
    [[nodiscard]] virtual bool isOf(const FleetItem& record) const;
    [[nodiscard]] virtual Shown shown() const { return {}; }
    /// Its place in the tree from the type down; empty: it has none, and the tree stays.
    [[nodiscard]] virtual std::vector<FleetItem> path() const { return {}; }
    /// Takes over how people have set out the page before.
    virtual void takeLook(const Page& before);
    virtual void setAngleStyle(AngleStyle) {}
    /// Records came, went or were changed while it is in front.
    virtual void fleetChanged() {}

signals:
    void readOut(const QString& text);   ///< for the status bar
    void failed(const QString& message); ///< stays above the page until dismissed
    void stateChanged();                 ///< shown() is another: commands may be enabled otherwise now
};

} // namespace lubberline::ui
