#pragma once
/// The manners of every plot with a chart: keys, context menu, palette, frame of the focus, read-out, copy and export.
/// Zoom by drag (wheel too), pan with the middle button, reset by double click or Home. Colours follow the palette (dark and
/// light); what is exported or printed has a white ground.

#include <QWidget>

#include "core/base/Result.h"

class QKeyEvent;
class QMenu;
class QPainter;

namespace lubberline::ui {

class AsksToSave;

class Chart;
class ChartMouse;

class Plot : public QWidget {
    Q_OBJECT

public:
    explicit Plot(const QString& name, QWidget* parent = nullptr);

    [[nodiscard]] QString name() const { return m_name; } ///< "Polar", "Curve", …: the tab's text and the file name's end
    void restyle();                                       ///< drawn anew: the style of angles is another
    void resetZoom();
    /// Draws the plot as it is, light colours on white, in vector form, into `target` of the painter's own units.
    virtual void render(QPainter& painter, const QRectF& target) const = 0;

    /// The ending says which: .png, .svg or .pdf. Errors: InvalidInput (another ending), Io,
    /// Unsupported (no font). No half-written file is left.
    Result<void> exportTo(const QString& path, QSize size_px = {900, 650}) const;
    /// Asks the window that it stands in, then exportTo(); failures are told by failed(). Where no window asks, nothing happens.
    /// @param suggestion  of the file's name, without its ending; empty: the plot's name.
    void exportInteractively(const QString& suggestion = {});
    void copyToClipboard();
    Q_INVOKABLE void copy() { copyToClipboard(); } ///< for the menu Edit

    [[nodiscard]] QSize sizeHint() const override { return {560, 480}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 200}; }

signals:
    void readOut(const QString& text); ///< what is under the pointer, with units; empty when it leaves
    void failed(const QString& message);
    void leaves(); ///< it is about to be exported or copied as it is: whoever is still computing it finishes that now

protected:
    /// Once, from the constructor: the chart becomes the plot's own.
    void adopt(Chart* chart);
    /// The usual mouse of a chart (zoom by frame, wheel, read-out).
    ChartMouse* watchMouse();
    /// The arrow keys: −1 left, +1 right. Without a meaning they go to the window.
    virtual bool step(int direction);
    /// What was set while the plot was hidden is handed over when it is shown.
    virtual void refresh() {}

    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    [[nodiscard]] AsksToSave* asksToSave() const;
    void followPalette();
    void addLegend(QMenu& menu);

    QString m_name;
    Chart* m_chart = nullptr;
};

} // namespace lubberline::ui
