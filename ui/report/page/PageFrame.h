#pragma once
/// What stands on every page of a document: title, whose it is, banner, sign convention, record id, data hash, page n of m.

#include <QRectF>
#include <QString>

#include "core/record/Fleet.h"

class QPainter;

namespace lubberline::ui {

struct PageFrame {
    QString title;      ///< "Compass swing report"
    QString subject;    ///< "SP-XYZ · standby compass · 2026-11-20"
    QString banner;     ///< demonstration data, draft: large; may be empty
    QString convention; ///< of signs
    QString recordId;   ///< may be empty
    QString hash, made;
    QString credit; ///< small on the last page; may be empty
};

/// "made 2026-11-27T07:58:12Z by Lubberline 0.1.0"; without a time, by what.
[[nodiscard]] QString madeWords(const QString& madeAtUtc);
[[nodiscard]] PageFrame frameFor(const SwingRecord& record, const QString& title, const QString& madeAtUtc);

/// The room between header and footer. [units of the page]
[[nodiscard]] QRectF bodyOf(const PageFrame& frame, QSizeF sheet);

/// @param page from 0
void paintFrame(QPainter& painter, const PageFrame& frame, const QString& family, QSizeF sheet, int page, int pages);

} // namespace lubberline::ui
