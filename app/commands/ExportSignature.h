#pragma once

#include <string>

#include "db/stores/Stores.h"

namespace lubberline::app {

/// Writes what the signatures of a swing stand for: FILE.txt, FILE.txt.asc and FILE.txt.key.asc where a key made it; of several
/// FILE-1-performer.txt, FILE-2-inspector.txt and so on. @return the exit status.
int exportSignatures(db::Stores& stores, const std::string& record, const std::string& role, const std::string& path);

} // namespace lubberline::app
