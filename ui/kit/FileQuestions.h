#pragma once
/// Asking for files: a page is given the questions, so that a test can answer them.

#include <QString>

#include <functional>

namespace lubberline::ui {

/// The answer is a path; empty: cancelled. `filter` as in QFileDialog: "Sensor model (*.json)".
struct FileQuestions {
    std::function<QString(const QString& title, const QString& filter)> open;
    std::function<QString(const QString& title, const QString& suggestion, const QString& filter)> save;
};

} // namespace lubberline::ui
