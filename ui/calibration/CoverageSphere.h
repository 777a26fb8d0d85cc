#pragma once
/// The directions that the field had in the sensor's axes, on a sphere that the mouse or the arrow keys turn; coloured by residual, the
/// largest hole as a ring.

#include <QWidget>

#include <vector>

#include <Eigen/Core>

namespace lubberline::ui {

struct SphereDot {
    Eigen::Vector3d direction; ///< of length 1, body axes
    double residual = 0;       ///< in standard deviations
};

class CoverageSphere : public QWidget {
    Q_OBJECT

public:
    explicit CoverageSphere(QWidget* parent = nullptr);
    /// @param gap middle of the largest hole. @param gap_deg its radius; 0: none is drawn
    void setDots(std::vector<SphereDot> dots, const Eigen::Vector3d& gap, double gap_deg);
    [[nodiscard]] std::size_t dots() const { return m_dots.size(); }
    /// Turned by the hand: from body axes to right, up, towards the eye.
    [[nodiscard]] Eigen::Matrix3d turn() const;

    [[nodiscard]] QSize sizeHint() const override { return {420, 420}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 200}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void turnBy(double azimuth_deg, double elevation_deg);

    std::vector<SphereDot> m_dots;
    Eigen::Vector3d m_gap = Eigen::Vector3d::Zero();
    double m_gap_deg = 0;
    double m_azimuth_deg = 30, m_elevation_deg = 20;
    QPoint m_last;
};

} // namespace lubberline::ui
