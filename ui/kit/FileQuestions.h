#pragma once
/// Asking for files: a page is given the questions, so that a test can answer them.

#include <QString>

#include <functional>

#include "core/base/Progress.h"
#include "core/base/Result.h"

namespace lubberline::ui {

/// What is written by work that takes its time.
struct FileToWrite {
    QString path;
    /// On a worker, with all that it needs: the page that asked may be gone by then. Errors: those of writing; Cancelled
    std::function<Result<void>(const Progress&)> work;
    QString success = {};            ///< said then; empty: "Written: path"
    std::function<void()> then = {}; ///< on the window's thread, once it is written
};

/// As soon as it is asked for: where there is no window.
inline void writeAtOnce(const FileToWrite& file)
{
    if (file.work({}) && file.then)
        file.then();
}

/// The answer is a path; empty: cancelled. `filter` as in QFileDialog: "Sensor model (*.json)".
struct FileQuestions {
    std::function<QString(const QString& title, const QString& filter)> open;
    std::function<QString(const QString& title, const QString& suggestion, const QString& filter)> save;
    /// Of a path that was answered. It says what comes of it.
    std::function<void(const FileToWrite&)> write = writeAtOnce;
};

} // namespace lubberline::ui
