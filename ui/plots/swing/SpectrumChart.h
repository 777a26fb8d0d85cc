#pragma once
/// The amplitude of every order that the headings resolve, with the noise floor; the orders that they do not are hatched.

#include "ui/plots/swing/CartesianChart.h"
#include "ui/plots/swing/SwingPicture.h"

class QwtPlotCurve;

namespace lubberline::ui {

class SpectrumBars;

class SpectrumChart : public CartesianChart {
    Q_OBJECT

public:
    explicit SpectrumChart(QWidget* parent = nullptr);

    void setPicture(const SwingPicture& picture) override;
    void setSelectedRow(int) override {} // an order belongs to all readings
    [[nodiscard]] std::vector<RowPlace> rowsOn(const QWidget*) const override { return {}; }
    [[nodiscard]] QString readOutAt(const CanvasPlace& place) const override;

protected:
    void styleItems() override;

private:
    SpectrumBars* m_bars;
    QwtPlotCurve* m_noise;
    int m_barsEntry, m_nyquistEntry, m_noiseEntry, m_hatchEntry;
};

} // namespace lubberline::ui
