#include "ui/plots/swing/SwingChart.h"

#include <cmath>

#include "core/base/Contract.h"
#include "ui/plots/swing/PictureText.h"

namespace lubberline::ui {

void SwingChart::keepPicture(const SwingPicture& picture)
{
    LUBBERLINE_EXPECT(std::isfinite(picture.resolution_deg) && picture.resolution_deg >= 0, "a resolution is finite");
    LUBBERLINE_EXPECT(std::isfinite(picture.limit_deg.value_or(0)), "a limit is finite");
    m_picture = picture;
}

QString SwingChart::readOutOfRow(int row) const
{
    for (const PlottedReading& reading : m_picture.readings) {
        if (reading.row == row)
            return readingReadOut(reading, m_picture);
    }
    return {};
}

} // namespace lubberline::ui
