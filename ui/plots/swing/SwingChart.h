#pragma once

#include "ui/plots/base/Chart.h"
#include "ui/plots/swing/SwingPicture.h"

namespace lubberline::ui {

/// A chart of one swing.
class SwingChart : public Chart {
    Q_OBJECT

public:
    using Chart::Chart;
    /// Takes the new values over into the items and repaints once.
    virtual void setPicture(const SwingPicture& picture) = 0;
    virtual void setSelectedRow(int row) = 0;
    [[nodiscard]] QString readOutOfRow(int row) const override;

protected:
    [[nodiscard]] const SwingPicture& picture() const { return m_picture; }
    void keepPicture(const SwingPicture& picture);

private:
    SwingPicture m_picture;
};

} // namespace lubberline::ui
