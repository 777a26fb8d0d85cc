#pragma once
/// The five components of the approximate fit one by one, and their sum, against compass heading (their argument).

#include <array>

#include "ui/plots/swing/CartesianChart.h"
#include "ui/plots/swing/SwingPicture.h"

class QwtPlotCurve;

namespace lubberline::ui {

class CartesianReadings;

class ComponentsChart : public CartesianChart {
    Q_OBJECT

public:
    explicit ComponentsChart(QWidget* parent = nullptr);

    void setPicture(const SwingPicture& picture) override;
    void setSelectedRow(int row) override;
    [[nodiscard]] std::vector<RowPlace> rowsOn(const QWidget* canvas) const override;
    [[nodiscard]] QString readOutAt(const CanvasPlace& place) const override;

protected:
    void styleItems() override;

private:
    std::array<QwtPlotCurve*, 5> m_components;
    QwtPlotCurve* m_sum;
    CartesianReadings* m_readings;
    std::array<int, 5> m_componentEntries;
    int m_sumEntry, m_readingsEntry;
};

} // namespace lubberline::ui
