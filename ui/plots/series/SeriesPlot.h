#pragma once
/// Long columns over a common x: a sensor's log over time, headings before and after. Ten million samples are drawn as the largest and
/// smallest of every pixel, so that zoom and cursor stay quick.

#include <memory>
#include <vector>

#include "ui/plots/base/Plot.h"

namespace lubberline::ui {

struct Series {
    QString title;
    std::shared_ptr<const std::vector<double>> x; ///< rising where it is a line; null: the row
    std::shared_ptr<const std::vector<double>> y; ///< NaN is a gap
    bool dots = false;                            ///< points instead of a line
};

struct SeriesPicture {
    QString xTitle, yTitle;
    QString xUnit, yUnit; ///< for the read-out
    std::vector<Series> series;
    QString notice; ///< what to do, where there is nothing to see
};

class SeriesChart;

class SeriesPlot : public Plot {
    Q_OBJECT

public:
    explicit SeriesPlot(const QString& name, QWidget* parent = nullptr);
    void setPicture(SeriesPicture picture);
    [[nodiscard]] const SeriesPicture& picture() const { return m_picture; }
    /// The x that are seen, and whether they are a part only.
    struct Seen {
        double from = 0, to = 0;
        bool part = false;
    };
    [[nodiscard]] Seen seen() const;
    [[nodiscard]] SeriesChart* chart() const { return m_chart; }
    void render(QPainter& painter, const QRectF& target) const override;

private:
    SeriesChart* m_chart;
    SeriesPicture m_picture;
};

} // namespace lubberline::ui
