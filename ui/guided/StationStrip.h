#pragma once
/// The stations of a guided swing as a strip: read, to be read again, skipped, now, to come; each by its shape, not by colour
/// alone.

#include <QWidget>

#include "core/procedure/JobState.h"

namespace lubberline::ui {

class StationStrip : public QWidget {
    Q_OBJECT

public:
    explicit StationStrip(QWidget* parent = nullptr);
    void show(const JobState& state);
    [[nodiscard]] QSize sizeHint() const override { return {400, 44}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QRectF boxOf(std::size_t station) const;
    [[nodiscard]] QString wordsOf(const StationState& station, bool now) const;
    JobState m_state;
};

} // namespace lubberline::ui
