#pragma once
/// A flight drawn by hand: three lanes (turn, acceleration, climb) over time, with a block for each manoeuvre. The mouse draws, moves, stretches
/// and raises blocks; the keyboard does the same: Insert, Page Up and Down (choose), arrows (move, raise), Shift with arrows (stretch), Delete.

#include <QWidget>

#include <optional>
#include <vector>

#include "core/reference/Scenario.h"

namespace lubberline::ui {

class ManoeuvreLine : public QWidget {
    Q_OBJECT

public:
    explicit ManoeuvreLine(QWidget* parent = nullptr);
    void show(const std::vector<Manoeuvre>& manoeuvres, double duration_s);
    [[nodiscard]] const std::vector<Manoeuvre>& manoeuvres() const { return m_manoeuvres; }

    enum Lane { Turn, Acceleration, Climb, kLanes };
    [[nodiscard]] QRectF laneRect(int lane) const;
    [[nodiscard]] double xOf(double time_s) const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void drawn(const std::vector<lubberline::Manoeuvre>& manoeuvres); ///< with every move of the hand
    void readOut(const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Block {
        std::size_t manoeuvre = 0;
        int lane = Turn;
        friend bool operator==(const Block&, const Block&) = default;
    };
    enum class Grip { None, From, To, Whole, New };
    struct Hit {
        Block block;
        Grip grip = Grip::None;
    };
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double valueAt(int lane, double y) const;
    [[nodiscard]] QRectF blockRect(const Block& block) const;
    [[nodiscard]] std::vector<Block> blocks() const; ///< by time, lane by lane
    [[nodiscard]] Hit hitAt(const QPointF& at) const;
    [[nodiscard]] QString textOf(const Block& block) const;
    void choose(int step);
    void insert();
    void remove();
    void take(Block block, double from_s, double to_s, double value);
    void tell();

    std::vector<Manoeuvre> m_manoeuvres;
    double m_duration_s = 600;
    std::optional<Block> m_chosen;
    Grip m_grip = Grip::None;
    QPointF m_pressedAt;
    Manoeuvre m_before; ///< of the block that is held, as it was when it was taken
};

} // namespace lubberline::ui
