#pragma once
/// A chart of a map as it goes into a file or to a printer: with all its points, in the colours and letters of paper.

#include <QPainter>

#include "ui/plots/base/Chart.h"
#include "ui/plots/base/PlotColours.h"
#include "ui/plots/map/MapPicture.h"

namespace lubberline::ui {

template <class Chart>
void paintOnPaper(Chart& chart, QPainter& painter, const QRectF& target, MapPicture picture)
{
    picture.coarse = false;
    chart.setFont(paperFont());
    chart.setColours(paperColours());
    chart.setPicture(picture);
    chart.paint(painter, target);
}

} // namespace lubberline::ui
