#pragma once
/// A sheet of sentences, pictures and a table, in the hand of our other documents: heading references, checks, compasses compared.

#include <QPainter>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "ui/report/page/Table.h"

namespace lubberline::ui {

struct ReferenceSheet {
    QString title, subject; ///< the subject may be empty
    QStringList text;       ///< a paragraph each
    struct Picture {
        double height_mm = 80;
        std::function<void(QPainter& painter, const QRectF& rect)> paint; ///< in pixels of 96 an inch
    };
    std::vector<Picture> pictures;
    Table table;             ///< without rows: none
    bool signatures = false; ///< lines for performer and inspector
    QString madeAtUtc = {};
};

/// Errors: InvalidInput (an ending other than .pdf), Io, Unsupported (no font).
Result<void> writeReferenceSheet(const ReferenceSheet& sheet, const QString& path, const Progress& progress = {});

} // namespace lubberline::ui
