#pragma once
/// The points of a base's survey from above, true north up, coloured by what differs from their mean; the figures beside them.

#include <QWidget>

#include "core/record/Site.h"

namespace lubberline::ui {

class SurveyDrawing : public QWidget {
    Q_OBJECT

public:
    explicit SurveyDrawing(QWidget* parent = nullptr);
    /// Declination where it was measured, else total field.
    void setSurvey(const std::vector<SurveyPoint>& points);
    [[nodiscard]] QSize sizeHint() const override { return {360, 320}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Scale {
        double mean = 0, largest = 0; ///< largest |value − mean|
        bool declination = true;
    };
    [[nodiscard]] std::optional<double> valueOf(const SurveyPoint& point) const;
    [[nodiscard]] QString words(const SurveyPoint& point) const;
    [[nodiscard]] QPointF onScreen(const SurveyPoint& point) const;

    std::vector<SurveyPoint> m_points;
    Scale m_scale;
    QRectF m_extent_m;
};

} // namespace lubberline::ui
