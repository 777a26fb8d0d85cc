// What nearly every test includes, compiled once for all (tests/CMakeLists.txt). Nobody includes this file.
#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/Precompiled.h"
