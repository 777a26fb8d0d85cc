#pragma once
/// The one way in which files are written: whole, or not at all. "-" is standard output (core/base/WholeFile.h).

#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace lubberline {

/// Whether a file may be written there; nothing is touched. Worth asking before long work.
/// @param inputs  files that the same command or window reads, which the output would destroy: known by what they are and not by
///   their name, so also through a symbolic link, a hard link or another way of writing the path. Those that are not there are passed over.
/// Errors: Io (a folder, device, pipe or socket; the folder is missing, or is none; a file that may not be written),
/// InvalidInput (one of the inputs).
Result<void> checkOutput(const std::string& path, const std::vector<std::string>& inputs = {});

/// Writes beside the file, waits until it is on the drive, and renames it over the file. A file that was there keeps its permissions, and
/// its owner where that is allowed; of a symbolic link the file that it names is replaced, another hard link keeps the old content.
/// When it fails nothing has changed and no file is left beside it.
/// Errors: those of checkOutput(); Io (the folder takes no new file, the drive fails), Full (no space left).
Result<void> writeWholeFile(const std::string& path, std::string_view content, const std::vector<std::string>& inputs = {});

} // namespace lubberline
