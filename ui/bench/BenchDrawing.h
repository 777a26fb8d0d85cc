#pragma once
/// The airframe bench from above and from the side: the sensor as a cross, parts as outlines with their names, conductors as
/// lines, a scale in metres. The nose is to the left; starboard is up in the view from above. Parts are moved by dragging them.

#include <QWidget>

#include <optional>

#include "core/iron/FerrousPart.h"

namespace lubberline::ui {

class BenchDrawing : public QWidget {
    Q_OBJECT

public:
    explicit BenchDrawing(QWidget* parent = nullptr);
    void setBench(const IronBench& bench, const BenchStates& states);
    void setSelected(int part);
    void setMovable(bool movable) { m_movable = movable; }
    /// Where a place falls on the screen, in the view from above or from the side.
    [[nodiscard]] QPointF onScreen(const Eigen::Vector3d& at_m, bool fromAbove) const;
    [[nodiscard]] QSize sizeHint() const override { return {420, 420}; }

signals:
    void partChosen(int part);
    /// The mouse let it go somewhere else: its centre there [m], to millimetres.
    void partMoved(int part, int placement, const Eigen::Vector3d& centre_m);
    void readOut(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct View;
    /// A part under the mouse: it moves in the plane of one view.
    struct Drag {
        int part, placement;
        bool fromAbove;
        QPointF begin;
        Eigen::Vector3d from_m, to_m;
        bool moved = false;
    };
    [[nodiscard]] std::vector<View> views() const;               ///< of the bench as it is, so that the scale stays while a part is dragged
    [[nodiscard]] Placement placementOf(std::size_t part) const; ///< as dragged
    void paintView(QPainter& painter, const View& view) const;

    IronBench m_bench;
    BenchStates m_states;
    std::optional<Drag> m_drag;
    int m_selected = -1;
    bool m_movable = false;
};

} // namespace lubberline::ui
