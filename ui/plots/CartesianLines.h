#pragma once
/// Small helpers that the rectangular plots share.

#include <QString>

#include <vector>

#include "ui/plots/Chart.h"

class QwtPlot;
class QwtPlotCurve;

namespace lubberline::ui {

class CartesianPlot;
class CartesianReadings;

/// Headings 0…360 below, with room at both ends for half a label.
void makeHeadingAxis(CartesianPlot& plot);
[[nodiscard]] QwtPlotCurve* attachedCurve(QwtPlot* plot, const QString& title, double z);
[[nodiscard]] std::vector<Chart::RowPlace> rowPlaces(const CartesianPlot& plot, const CartesianReadings& readings);

} // namespace lubberline::ui
