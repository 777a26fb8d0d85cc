#pragma once
/// Coefficients of one compass over the years.

#include <QDate>
#include <QWidget>

#include <array>
#include <optional>
#include <vector>

class QPainter;

namespace lubberline::ui {

struct HistoryPoint {
    QDate date;
    int swing = 0;                                        ///< index into what the page listed: emitted when the point is clicked
    std::array<std::optional<double>, 5> coefficient_deg; ///< A…E, approximate
    std::optional<double> maxAbsDeviation_deg;
};

class HistoryPlot : public QWidget {
    Q_OBJECT

public:
    using QWidget::QWidget;
    virtual void setHistory(const std::vector<HistoryPoint>& points, std::optional<double> limit_deg) = 0;
    virtual void render(QPainter& painter, const QRectF& target) const = 0;

signals:
    void swingSelected(int swing);
    void readOut(const QString& text);
};

[[nodiscard]] HistoryPlot* makeHistoryPlot(QWidget* parent = nullptr);

} // namespace lubberline::ui
