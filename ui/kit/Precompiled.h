// What most sources of the window include, compiled once for all (cmake/LubberlineBuild.cmake). Nobody includes this file.
#include "core/base/Precompiled.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
