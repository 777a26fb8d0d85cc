#pragma once
/// The legend under a plot: on the screen each entry is a switch for its curve; on paper only what is shown is listed.

#include <QBrush>
#include <QPen>
#include <QWidget>

#include <vector>

#include "ui/plots/base/PlotColours.h"

namespace lubberline::ui {

struct LegendEntry {
    enum class Key { Line, Area, Dot, Bar };
    QString title;
    Key key = Key::Line;
    QPen pen = {};
    QBrush fill = {};
    bool present = true; ///< has something to show; otherwise it is not listed
    bool shown = true;   ///< not switched off
};

/// The height that the entries need in a width, wrapped into centred rows; 0 without entries. [units of the painter]
[[nodiscard]] double legendHeight(const std::vector<LegendEntry>& entries, double width, const QFont& font);
void paintLegend(QPainter& painter, const QRectF& rect, const std::vector<LegendEntry>& entries, const PlotColours& colours);
/// The entry at a place, −1 for none; as paintLegend() with the same rectangle and font.
[[nodiscard]] int legendEntryAt(const std::vector<LegendEntry>& entries, const QRectF& rect, const QFont& font, QPointF place);

/// The legend as a widget.
class PlotLegend : public QWidget {
    Q_OBJECT

public:
    explicit PlotLegend(QWidget* parent = nullptr);
    void setEntries(const std::vector<LegendEntry>& entries);
    void setColours(const PlotColours& colours);

signals:
    void toggled(int entry);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    std::vector<LegendEntry> m_entries;
    PlotColours m_colours;
};

} // namespace lubberline::ui
