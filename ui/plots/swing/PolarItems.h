#pragma once
/// What Qwt's polar plot lacks: a ground with a zero circle and a limit band, and readings with bars.
/// Radius: deviation [deg, east positive], from −R at the pole to +R at the rim. Azimuth: heading [deg], north up, clockwise.

#include <QFont>

#include <optional>
#include <vector>

#include <qwt_polar_item.h>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/base/PlotColours.h"
#include "ui/plots/swing/ReadingMarks.h"

namespace lubberline::ui {

class PolarGround : public QwtPolarItem {
public:
    PolarGround();
    void setScale(const NiceScale& scale) { m_scale = scale; }
    void setLimit(std::optional<double> limit_deg) { m_limit_deg = limit_deg; }
    void setLimitShown(bool shown) { m_limitShown = shown; }
    void setLook(const PlotColours& colours, const QFont& font);
    [[nodiscard]] std::optional<double> limit_deg() const { return m_limit_deg; }

    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap, const QPointF& pole, double radius,
        const QRectF& canvasRect) const override;
    [[nodiscard]] QwtInterval boundingInterval(int scaleId) const override;
    [[nodiscard]] int marginHint() const override; ///< room for the names of the headings outside the rim

private:
    void drawLimit(QPainter& painter, const QwtScaleMap& radialMap, const QPointF& pole) const;
    void drawLimitEdge(QPainter& painter, const QwtScaleMap& radialMap, const QPointF& pole) const;
    void drawGrid(QPainter& painter, const QwtScaleMap& radialMap, const QPointF& pole, double radius) const;
    void drawHeadings(QPainter& painter, const QPointF& pole, double radius) const;
    void drawScale(QPainter& painter, const QwtScaleMap& radialMap, const QPointF& pole, double radius) const;
    void drawCaptions(QPainter& painter, const QRectF& within, const QPointF& pole, double radius) const;

    NiceScale m_scale;
    std::optional<double> m_limit_deg;
    bool m_limitShown = true;
    PlotColours m_colours;
    QFont m_font;
};

class PolarReadings : public QwtPolarItem {
public:
    PolarReadings();
    void setPoints(std::vector<ReadingPoint> points)
    {
        m_points = std::move(points);
        setZ(depthOf(m_points.size()));
    }
    void setSelectedRow(int row) { m_selectedRow = row; }
    void setLook(const PlotColours& colours, const QFont& font);
    [[nodiscard]] const std::vector<ReadingPoint>& points() const { return m_points; }
    [[nodiscard]] int selectedRow() const { return m_selectedRow; }

    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap, const QPointF& pole, double radius,
        const QRectF& canvasRect) const override;
    [[nodiscard]] QwtInterval boundingInterval(int scaleId) const override;

private:
    std::vector<ReadingPoint> m_points;
    int m_selectedRow = -1;
    PlotColours m_colours;
    QFont m_font;
};

/// What to do, or why there is no curve: in the middle.
class PolarNotice : public QwtPolarItem {
public:
    PolarNotice();
    void setText(const QString& text) { m_text = text; }
    void setLook(const PlotColours& colours, const QFont& font);
    [[nodiscard]] const QString& text() const { return m_text; }

    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap, const QPointF& pole, double radius,
        const QRectF& canvasRect) const override;
    [[nodiscard]] QwtInterval boundingInterval(int scaleId) const override;

private:
    QString m_text;
    PlotColours m_colours;
    QFont m_font;
};

/// The place of a heading at a distance from the pole: north up, clockwise.
[[nodiscard]] QPointF polarPlace(const QPointF& pole, double heading_deg, double distance);

} // namespace lubberline::ui
