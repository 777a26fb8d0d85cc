#pragma once
/// What stands at the right of the window: everything that the window asks a page, and that a page tells the window. How it is reached,
/// what can be printed or exported of it and its help topic stand in its PageDescription.

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>

#include <vector>

#include "core/base/Result.h"
#include "ui/kit/Destination.h"

namespace lubberline::ui {

struct PageContext;
struct PageDescription;
class Plot;

/// What commands act upon; ids that are not valid: the page is of no such record.
struct Shown {
    AircraftId aircraft = {};
    CompassId compass = {};
    SwingId swing = {};
    bool editable = false;    ///< a swing whose readings may be changed
    bool rowSelected = false; ///< a reading is chosen
    bool writable = false;    ///< the database can be written; the window's to say
    bool plot = false;        ///< a plot is in front; likewise
    bool base = false;        ///< a compass base is chosen
    AircraftTypeId type = {}; ///< alone, on the overview of a type

    /// The nearest of them as a place to go: compass, else aircraft.
    [[nodiscard]] FleetItem item() const;
};

class Page : public QWidget {
    Q_OBJECT

public:
    explicit Page(QWidget* parent = nullptr);
    ~Page() override;

    [[nodiscard]] QString title() const { return windowTitle(); }
    /// Whose record it is, where its title tells only what is done there.
    [[nodiscard]] virtual QString whose() const { return {}; }
    [[nodiscard]] QString message() const { return m_message->text(); }
    /// The plot that is in front on it, for the commands that copy and export one; none: it has none now.
    [[nodiscard]] virtual Plot* plot() const { return nullptr; }

    /// Puts a record on it. Errors: those of the stores, or that it shows no such record; what was shown stays then.
    virtual Result<void> open(const FleetItem& record);
    /// Whether it can open a record as it stands. A page owns one record: where this says no, the window makes the page anew, and
    /// whatever was typed or opened on the old one is gone with it. A list, which owns none, says yes.
    [[nodiscard]] virtual bool isOf(const FleetItem& record) const;
    [[nodiscard]] virtual Shown shown() const { return {}; }
    /// Its place in the tree from the type down; empty: it has none, and the tree stays.
    [[nodiscard]] virtual std::vector<FleetItem> path() const { return {}; }
    /// What was typed on it and refused: it goes with the page, and is told then.
    [[nodiscard]] virtual QStringList unstored() const;
    /// Takes over how people have set out the page before.
    virtual void takeLook(const Page& before);
    /// Angles are shown in another style now: what is said is said anew.
    void restyle();
    /// Records came, went or were changed while it is in front.
    virtual void fleetChanged() {}

signals:
    void readOut(const QString& text);   ///< for the status bar
    void failed(const QString& message); ///< stays above the page until dismissed
    void stateChanged();                 ///< shown() is another: commands may be enabled otherwise now

protected:
    /// What a page writes of angles itself, it writes anew; its message and its plots follow alone.
    virtual void anglesChanged() {}
    void setTitle(const QString& title);
    void say(const QString& message);    ///< under the title, until something else is said; empty: nothing
    void refuse(const QString& message); ///< likewise, and marked: what was typed does not stand
    /// A plot tells of itself through the page.
    void follow(Plot& plot);

    [[nodiscard]] QHBoxLayout& head() { return *m_head; } ///< the title's line; buttons stand at its right
    [[nodiscard]] QVBoxLayout& body() { return *m_body; } ///< all beneath title and message: scrolled where the window is too small for it
    [[nodiscard]] QLabel& titleLine() { return *m_title; }
    [[nodiscard]] QLabel& messageLine() { return *m_message; }

private:
    QLabel *m_title, *m_message;
    QString m_said; ///< in decimal degrees
    QHBoxLayout* m_head;
    QVBoxLayout* m_body;
};

} // namespace lubberline::ui
