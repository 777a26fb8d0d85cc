#pragma once
/// A slider of a figure that is played with.

#include <QSlider>

namespace lubberline::ui {

/// Says when it is let go, by mouse, key or because it is left. Arrow keys, and dragging with Shift, go in fine steps, the page keys in
/// coarse ones; a double click resets.
class PlaySlider : public QSlider {
    Q_OBJECT

public:
    using QSlider::QSlider;

signals:
    void letGo();
    void stepped(int steps, bool coarse);
    void resetWanted();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    int m_fineFrom_px = 0; ///< where the last fine step was made
};

} // namespace lubberline::ui
