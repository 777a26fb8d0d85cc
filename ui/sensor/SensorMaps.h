#pragma once
/// Map, surface and level swing of a model as tabs: only the one in front is computed and painted.

#include <QTabWidget>

#include "ui/sensor/SensorPictures.h"

namespace lubberline::ui {

class MapPlot;
class Plot;
class SurfacePlot;
class SwingPlot;

class SensorMaps : public QTabWidget {
    Q_OBJECT

public:
    explicit SensorMaps(QWidget* parent = nullptr);

    /// None: the plots say that there is nothing.
    void show(const std::optional<ModelView>& view, const QString& whyNothing);
    [[nodiscard]] Plot& front() const;

signals:
    void readOut(const QString& text);
    void failed(const QString& message);

private:
    void catchUp();
    void add(Plot* plot, const QString& title);
    [[nodiscard]] MapPicture mapPicture() const;

    MapPlot* m_map;
    SurfacePlot* m_surface;
    SwingPlot* m_level;
    std::optional<ModelView> m_view;
    QString m_whyNothing;
};

} // namespace lubberline::ui
