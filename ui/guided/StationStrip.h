#pragma once
/// The stations of a guided swing as a strip: read, to be read again, skipped, now, to come; each by its shape, not by colour
/// alone. A skipped one is gone to by a click; the arrows choose one, Enter or F2 goes to it.

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

signals:
    void chosen(const QString& words); ///< what is known of it
    void wanted(int station);          ///< it is to be read again, or after all

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool event(QEvent* event) override;

private:
    void choose(int station);
    [[nodiscard]] QRectF boxOf(std::size_t station) const;
    [[nodiscard]] QString wordsOf(const StationState& station, bool now) const;
    JobState m_state;
    int m_chosen = -1;
};

} // namespace lubberline::ui
