#pragma once
/// The bars of a spectrum, and the hatched ground of the orders that the headings do not resolve.

#include <QFont>

#include <optional>
#include <vector>

#include <qwt_plot_item.h>

#include "ui/plots/base/PlotColours.h"

namespace lubberline::ui {

struct SpectrumBar {
    int order = 0;
    double amplitude_deg = 0;
    bool nyquist = false; ///< only its cosine is known
};

class SpectrumBars : public QwtPlotItem {
public:
    SpectrumBars();
    /// Orders above `highestResolvable` up to `last` are hatched.
    void setBars(std::vector<SpectrumBar> bars, int highestResolvable, int last);
    void setNoise(std::optional<double> noise_deg) { m_noise_deg = noise_deg; } ///< figures stand clear of that line
    void setNyquistShown(bool shown) { m_nyquistShown = shown; }
    void setHatchShown(bool shown) { m_hatchShown = shown; }
    void setLook(const PlotColours& colours, const QFont& font);
    [[nodiscard]] const std::vector<SpectrumBar>& bars() const { return m_bars; }
    [[nodiscard]] int highestResolvable() const { return m_highestResolvable; }
    [[nodiscard]] int last() const { return m_last; }

    void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const override;

private:
    void drawHatch(QPainter& painter, const QwtScaleMap& xMap, const QRectF& canvasRect) const;
    void drawBar(QPainter& painter, const SpectrumBar& bar, const QwtScaleMap& xMap, const QwtScaleMap& yMap) const;
    void drawValue(QPainter& painter, const SpectrumBar& bar, const QwtScaleMap& xMap, const QwtScaleMap& yMap) const;

    std::vector<SpectrumBar> m_bars;
    int m_highestResolvable = 0, m_last = 0;
    std::optional<double> m_noise_deg;
    bool m_nyquistShown = true, m_hatchShown = true;
    PlotColours m_colours;
    QFont m_font;
};

} // namespace lubberline::ui
