#pragma once
/// The history of one compass of a population: its coefficients over the years, its curves as a film, and when its limit will be reached.

#include <QWidget>

#include <memory>

#include "ui/fleet/PopulationNews.h"
#include "ui/plots/fleet/FleetDrawing.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QTimer;

namespace lubberline::ui {

class PaintedPlot;

class HistoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit HistoryPanel(QWidget* parent = nullptr);

    /// @param first  the compass that is shown first, where it is among them; not valid: the first to swing.
    void show(std::shared_ptr<const PopulationNews> news, CompassId first);
    void showCompass(std::int32_t compass); ///< of FleetSwings::compasses

private:
    void build();
    void step();
    void paintDates(QPainter& painter, const QRectF& rect, const FleetLook& look) const;
    [[nodiscard]] const RankedCompass* ranked() const; ///< null: it was not ranked

    std::shared_ptr<const PopulationNews> m_news;
    HistoryDrawing m_history;
    std::int32_t m_shown = -1;
    QComboBox* m_choice;
    QSlider* m_film;
    QPushButton* m_play;
    QTimer* m_timer;
    PaintedPlot *m_coefficients, *m_curves, *m_dates;
    QLabel* m_words;
};

} // namespace lubberline::ui
