#pragma once

#include <QString>

namespace lubberline::ui {

/// A window that can ask where a file is to go. A plot asks the nearest one that it stands in, so that no page has to pass the question on.
class AsksToSave {
public:
    virtual ~AsksToSave() = default;
    /// @param filter  as in QFileDialog: "Image (*.png);;Drawing (*.svg)". @return a path; empty: none was chosen.
    virtual QString askToSave(const QString& title, const QString& suggestion, const QString& filter) = 0;
};

} // namespace lubberline::ui
