#pragma once
/// The curve expected at another base, with its band, over the curve of here.

#include <optional>

#include "core/swing/Prediction.h"
#include "ui/plots/base/Plot.h"

namespace lubberline::ui {

struct PredictionPicture {
    std::optional<Prediction> there; ///< none: an empty plot that says `notice`
    std::optional<Prediction> here;
    std::optional<double> limit_deg;
    QString notice;
};

class PredictionChart;

class PredictionPlot : public Plot {
    Q_OBJECT

public:
    explicit PredictionPlot(QWidget* parent = nullptr);
    void setPicture(const PredictionPicture& picture);
    [[nodiscard]] const PredictionPicture& picture() const { return m_picture; }
    [[nodiscard]] PredictionChart* chart() const { return m_chart; }
    void render(QPainter& painter, const QRectF& target) const override;

private:
    PredictionChart* m_chart;
    PredictionPicture m_picture;
};

} // namespace lubberline::ui
