// What nearly every test of the window includes, compiled once for all (tests/CMakeLists.txt). Nobody includes this file.
#include <Eigen/Dense>
#include <QApplication>
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QtTest>

#include "ui/kit/Precompiled.h"
