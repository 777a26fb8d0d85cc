#pragma once
/// The mouse on the canvas of a plot: hover, click, drag (left: a frame to zoom into; middle: pan), wheel, double click.

#include <QObject>
#include <QPointF>
#include <QRectF>

class QMouseEvent;
class QRubberBand;
class QWheelEvent;
class QWidget;

namespace lubberline::ui {

class CanvasMouse : public QObject {
    Q_OBJECT

public:
    /// Watches the canvas and is owned by it.
    explicit CanvasMouse(QWidget* canvas);

signals: // places in pixels of the canvas
    void hovered(const QPointF& at);
    void left();
    void clicked(const QPointF& at);
    void framed(const QRectF& rect);
    void panned(const QPointF& by);
    void wheeled(const QPointF& at, double steps); ///< positive: away from the user
    void doubleClicked();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);

    QWidget* m_canvas;
    QRubberBand* m_frame;
    QPointF m_pressedAt, m_pannedFrom;
    bool m_framing = false, m_panning = false, m_wasDoubleClick = false;
};

} // namespace lubberline::ui
