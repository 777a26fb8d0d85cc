#include "ui/reference/ReferencePage.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

#include "core/angle/Angle.h"
#include "core/reference/LevellingLoop.h"
#include "ui/kit/Words.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/reference/Painted.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

namespace {

constexpr double kShownSteps = 4000; ///< more are not seen, and a slider is to follow the hand
constexpr std::size_t kFilmFrames = 600;

} // namespace

void ReferencePage::run()
{
    Scenario shown = m_scenario;
    shown.step_s = std::max(shown.step_s, shown.duration_s / kShownSteps);
    m_worker.start([shown](const Progress& progress) { return runScenario(shown, progress); });
}

void ReferencePage::take(Result<ReferenceRun> run)
{
    if (!run) {
        if (run.error().code != ErrorCode::Cancelled)
            refuse(messageOf(run.error()));
        return;
    }
    const double at_s = m_picture->at_s;
    m_run = std::move(run.value());
    *m_picture = pictureOf(*m_run);
    m_picture->at_s = std::min(at_s, m_run->time_s.back());
    QStringList sentences;
    for (const Message& warning : m_run->warnings)
        sentences.append(toText(warning));
    if (m_scenario.vertical) {
        const LoopCharacter loop = characterOf(*m_scenario.vertical);
        sentences.prepend(tr(
            "Levelling: natural period %1 s, damping %2, largest gain %3; standoff to rates and drift %4° (Coriolis, in the curve, is not in it).")
                              .arg(plainNumber(2 * kPi / loop.natural_rad_s, 0), plainNumber(loop.damping, 2),
                                  plainNumber(loop.largestGain, 2), plainNumber(toDegrees(m_run->standoff_rad.value_or(0)), 3)));
    }
    if (m_run->slavingStandoff_rad)
        sentences.append(tr("Slaving leaves %1° of the drift.").arg(signedNumber(toDegrees(*m_run->slavingStandoff_rad), 3)));
    say(sentences.join(QStringLiteral("\n")));
    showPictures();
}

void ReferencePage::showPictures()
{
    m_time->setPicture(timeDrawing(m_picture));
    m_gain->setPicture(gainDrawing(m_scenario));
    m_dials->setPaint([this](QPainter& painter, const QRectF& rect, const PlotColours& colours) {
        if (!m_run)
            return;
        const auto later = std::upper_bound(m_run->time_s.begin(), m_run->time_s.end(), m_picture->at_s);
        const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(later - m_run->time_s.begin() - 1, 0));
        paintDials(painter, rect, toDegrees(m_run->heading_rad[i]), toDegrees(m_run->headingError_rad[i]), m_run->tilt[i], colours);
    });
}

void ReferencePage::showFrame()
{
    if (!m_run)
        return;
    m_picture->at_s += m_run->time_s.back() / double(kFilmFrames);
    if (m_picture->at_s >= m_run->time_s.back()) {
        m_picture->at_s = m_run->time_s.back();
        m_film->setChecked(false);
    }
    m_time->redraw();
    m_dials->update();
}

} // namespace lubberline::ui
