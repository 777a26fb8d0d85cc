#pragma once
/// A reading judged as it is made, in words: what slipped, what was meant, and how likely that is.

#include <QString>

#include <optional>

#include "core/angle/AngleText.h"
#include "core/deviation/SlipCheck.h"
#include "core/record/Fleet.h"
#include "core/swing/Analysis.h"

namespace lubberline::ui {

class SwingEditor;

/// "on 045° the compass reads 052°. Look again: most likely a 10° slip, 042° meant (92 %)", or which readings cannot be told apart;
/// empty where the analysis suspects nothing. `index` counts the analysed readings.
[[nodiscard]] QString suspicionOf(const Analysis& analysis, std::size_t index, AngleStyle style);

/// With the figures of the row, or without them where they stand beside it.
enum class SlipFigures { Named, Beside };

/// One reading of the swing that is shown, against the last swing's curve and all other readings that count. `row` is complete
/// and counts.
[[nodiscard]] SlipJudgement judgeRow(const SwingEditor& editor, int row);

/// The row that is most likely wrong, if any is more likely wrong than right.
[[nodiscard]] std::optional<int> likeliestSlip(const SwingEditor& editor);

/// What the row most likely slipped by, whether the whole swing tells it or the readings until now: it stays until the figure is another
/// or the reading is left out. Empty: nothing.
[[nodiscard]] QString slipOfRow(const SwingEditor& editor, int row, AngleStyle style, SlipFigures figures = SlipFigures::Named);

/// From how far off its nominal a magnetic heading is remarked [deg]: aircraft are turned to within five.
inline constexpr double kFarFromNominal_deg = 10.0;
/// "225° is 45° off its nominal heading 180°: is it this row's?"; empty where it is near, or there is no nominal.
[[nodiscard]] QString farFromNominal(const Reading& reading, AngleStyle style);

/// "on 270° the compass reads 279°; 269° ± 1° is expected. Look again: most likely a 10° slip, 269° meant (92 %)"; empty unless
/// lookAgain().
[[nodiscard]] QString slipSentence(const SlipJudgement& judgement, const Reading& reading, AngleStyle style);

} // namespace lubberline::ui
