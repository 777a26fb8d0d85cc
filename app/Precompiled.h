// What most commands include, compiled once for all (cmake/LubberlineBuild.cmake). Nobody includes this file.
#include "core/base/Precompiled.h"

#include <CLI/CLI.hpp>
#include <QString>
#include <nlohmann/json.hpp>
