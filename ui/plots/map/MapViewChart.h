#pragma once
/// What the flat map and the surface have in common: the data, the header (title, held angle, MODELLED or MEASURED), the colour
/// bar.

#include <memory>

#include "ui/plots/base/Chart.h"
#include "ui/plots/map/ColourBar.h"
#include "ui/plots/map/MapCells.h"
#include "ui/plots/map/MapPicture.h"

namespace lubberline::ui {

class PaintedStrip;

class MapViewChart : public Chart {
    Q_OBJECT

public:
    explicit MapViewChart(QWidget* parent = nullptr);

    /// Takes the new values over; the repainting follows.
    void setPicture(const MapPicture& picture);
    [[nodiscard]] const MapPicture& picture() const { return m_picture; }
    [[nodiscard]] const MapCells* cells() const { return m_cells.get(); } ///< null without a map
    [[nodiscard]] const std::shared_ptr<const MapCells>& sharedCells() const { return m_cells; }
    [[nodiscard]] const NiceScale& scale() const { return m_bar.scale; } ///< of the colours

    [[nodiscard]] std::vector<RowPlace> rowsOn(const QWidget*) const override { return {}; }
    [[nodiscard]] QString readOutOfRow(int) const override { return {}; }

protected:
    virtual void takePicture() = 0;
    virtual void layoutBody(const QRect& rect) = 0;
    /// `device` is in pixels of the painter's device, `scale` of them are a unit.
    virtual void paintBody(QPainter& painter, const QRectF& device, double scale) = 0;
    /// How much of the body's height lies under the bar's foot: an axis with its labels.
    [[nodiscard]] virtual double footHeight() const { return 0; }

    void styleItems() override;
    void layoutPlots(const QRect& rect) override;
    void paintPlots(QPainter& painter, const QRectF& device) override;

private:
    struct Parts {
        QRectF header, body, bar;
    };
    [[nodiscard]] Parts partsOf(const QRectF& rect, const QFont& font) const;
    void paintHeader(QPainter& painter, const QRectF& rect, const QFont& font) const;

    MapPicture m_picture;
    std::shared_ptr<const MapCells> m_cells;
    ColourBar m_bar;
    PaintedStrip *m_headerStrip, *m_barStrip;
};

} // namespace lubberline::ui
