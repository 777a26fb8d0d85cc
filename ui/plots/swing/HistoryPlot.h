#pragma once
/// Coefficients of one compass over the years.

#include <QDate>

#include <array>
#include <optional>
#include <vector>

#include "ui/plots/base/Plot.h"

namespace lubberline::ui {

struct HistoryPoint {
    QDate date;
    int swing = 0;                                        ///< index into what the page listed: emitted when the point is clicked
    std::array<std::optional<double>, 5> coefficient_deg; ///< A…E, approximate
    std::optional<double> maxAbsDeviation_deg;
};

class HistoryChart;

class HistoryPlot : public Plot {
    Q_OBJECT

public:
    explicit HistoryPlot(QWidget* parent = nullptr);
    void setHistory(const std::vector<HistoryPoint>& points, std::optional<double> limit_deg);
    void render(QPainter& painter, const QRectF& target) const override;
    [[nodiscard]] QSize sizeHint() const override { return {560, 300}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 230}; } ///< the legend may take three lines

signals:
    void swingSelected(int swing);

private:
    HistoryChart* m_chart;
    std::vector<HistoryPoint> m_points;
    std::optional<double> m_limit_deg;
};

} // namespace lubberline::ui
