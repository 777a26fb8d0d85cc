#pragma once
/// A card from one or two swing files (radio on and off).

#include <string>
#include <vector>

#include "core/swing/Analysis.h"
#include "ui/report/card/CardDocument.h"

namespace lubberline::app {

struct CardSheet {
    ui::CardInput input;            ///< without the time it was made
    std::vector<Analysis> analyses; ///< of each column, to tell what is between its rows
    std::vector<Message> warnings;
};

/// @param files one or two Swing CSV files of the same compass. Errors: those of reading, analysing and makeCard(); Conflict when two
/// files are one file or the same swing, name different aircraft or compasses (or only one names them), or cannot be told apart on the
/// card: both with the radio on, both off, or of one date where the radio is not stated.
Result<CardSheet> cardFromFiles(const std::vector<std::string>& files, const CardOptions& options);

} // namespace lubberline::app
