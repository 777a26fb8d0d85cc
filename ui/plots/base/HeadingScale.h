#pragma once
/// The scale of headings 0…360 in steps that sailors know, with the names of the points.

#include <qwt_scale_draw.h>
#include <qwt_scale_engine.h>

namespace lubberline::ui {

/// Steps of 45°, closer in of 30, 15, 10, 5, 2 and 1°.
class HeadingScaleEngine : public QwtLinearScaleEngine {
public:
    [[nodiscard]] QwtScaleDiv divideScale(double from, double to, int maxMajor, int maxMinor, double step) const override;
};

/// Labels of several lines, each centred under its tick; Qwt sets them flush left. Where they would touch only some are drawn.
class CentredScaleDraw : public QwtScaleDraw {
protected:
    void drawLabel(QPainter* painter, double value) const override;

private:
    [[nodiscard]] int ticksPerLabel(const QFont& font) const;
};

/// "045" with "NE" beneath.
class HeadingScaleDraw : public CentredScaleDraw {
public:
    [[nodiscard]] QwtText label(double heading_deg) const override;
};

/// "NE" for 45; empty between the eight points.
[[nodiscard]] QString pointName(int heading_deg);

} // namespace lubberline::ui
