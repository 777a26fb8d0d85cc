#pragma once
/// Electrical swings of a remote compass: the swing data sheet with its errors, what to turn to which figure, and the tests
/// that it must pass. Errors here are indicated − selected, as on the sheet; the deviation of the rest of the program is their
/// negative.

#include <functional>

#include "ui/kit/EditContext.h"
#include "ui/kit/FormField.h"
#include "ui/kit/Page.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QUndoStack;

namespace lubberline::ui {

class SwingPlot;

class ElectricalPage : public Page {
    Q_OBJECT

public:
    /// @param today UTC.
    ElectricalPage(EditContext& context, QUndoStack& undo, std::function<Date()> today, QWidget* parent = nullptr);
    Result<void> showCompass(CompassId compass);

    static PageDescription description(PageContext& context);
    Result<void> open(const FleetItem& record) override;
    [[nodiscard]] Shown shown() const override { return {m_compass.aircraft, m_compass.id}; }
    [[nodiscard]] Plot* plot() const override;

signals:
    void makeSwing(const lubberline::Swing& swing);
    /// Its record on paper is wanted.
    void writeRecord(const lubberline::ElectricalSwing& swing, const lubberline::CompassSystem& compass);

private:
    void build();
    QWidget* buildSheet();
    void reload();
    void anglesChanged() override { showSwing(); }
    void showSwing();
    void showFourPoints();
    void showHeadings();
    void showVerdict();
    void takeFourPoints(int row, int column);
    void takeHeading(int row, int column);
    void store(ElectricalSwing after);
    void storeTyped(ElectricalSwing after, const QString& typed, double selected_deg);
    void add();
    void make();
    void write();
    [[nodiscard]] ElectricalSwing& current() { return m_swings[static_cast<std::size_t>(m_current)]; }

    EditContext& m_context;
    db::Stores& m_stores;
    QUndoStack& m_undo;
    std::function<Date()> m_today;
    CompassSystem m_compass;
    std::vector<ElectricalSwing> m_swings;
    int m_current = -1;
    FormFields<ElectricalSwing> m_fields;
    QComboBox* m_chooser;
    QPushButton *m_add, *m_make, *m_write;
    QTableWidget *m_fourPoints, *m_headings;
    QLabel *m_turn, *m_verdict;
    SwingPlot* m_plot;
};

} // namespace lubberline::ui
