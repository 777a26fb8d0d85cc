#pragma once
/// A card from one or two swing files (radio on and off).

#include <string>
#include <vector>

#include "ui/report/card/CardDocument.h"

namespace lubberline::app {

struct CardSheet {
    ui::CardInput input; ///< without the time it was made
    std::vector<Message> warnings;
};

/// @param files one or two Swing CSV files of the same compass. Errors: those of reading, analysing and makeCard();
/// Conflict when two files name different aircraft or compasses.
Result<CardSheet> cardFromFiles(const std::vector<std::string>& files, const CardOptions& options);

} // namespace lubberline::app
