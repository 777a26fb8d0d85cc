#pragma once
/// Pages in units of 1/100 mm from the corner of the sheet, the same for every device; text in them, and content that flows
/// from page to page. Angles in words are written as the window shows them (see AngleWords.h), whoever made the words.

#include <QRectF>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"

class QFont;
class QPagedPaintDevice;
class QPainter;

namespace lubberline::ui {

constexpr double mm(double millimetres) { return millimetres * 100.0; }

/// The whole sheet of the device.
[[nodiscard]] QSizeF sheetSize(const QPagedPaintDevice& device);

/// Paints `pages` sheets. The painter comes with the page's units set.
/// Errors: Io when the device takes no painting; Cancelled.
Result<void> paintSheets(
    QPagedPaintDevice& device, int pages, const std::function<void(QPainter&, int page)>& paintPage, const Progress& progress = {});

/// A single line from its baseline: `at` is left, centre or right of it by `alignment`.
void paintLine(QPainter& painter, const QFont& font, QPointF at, Qt::Alignment alignment, const QString& text);

/// Text wrapped into a width, in words where they fit and within them where they do not.
[[nodiscard]] QStringList wrappedLines(const QFont& font, double width, const QString& text);
[[nodiscard]] double wrappedHeight(const QFont& font, double width, const QString& text);
void paintWrapped(QPainter& painter, const QFont& font, const QRectF& rect, const QString& text);

/// The largest size up to `size_pt` at which a line fits a width, for names of any length. @return the font
[[nodiscard]] QFont fitted(const QString& family, double size_pt, bool bold, double width, const QString& text);

/// A piece of a page that is not broken.
struct Block {
    double height = 0;
    std::function<void(QPainter& painter, const QRectF& rect)> paint;
    bool keepWithNext = false;                      ///< as a heading is kept with what it heads
    bool newPage = false;                           ///< begins a page
    std::shared_ptr<const Block> repeatedHead = {}; ///< painted again when a page begins with this block
};

/// @return the height of all of them, one beneath the other
[[nodiscard]] double heightOf(const std::vector<Block>& blocks);
void append(std::vector<Block>& blocks, std::vector<Block> more);

struct PlacedBlock {
    const Block* block = nullptr; ///< one of the blocks or a repeated head of one
    double top = 0;               ///< from the top of the page's body
};

/// What stands on each page. A block that is higher than a page gets one of its own.
[[nodiscard]] std::vector<std::vector<PlacedBlock>> paginate(const std::vector<Block>& blocks, double bodyHeight);
void paintBlocks(QPainter& painter, const std::vector<PlacedBlock>& blocks, const QRectF& body);

} // namespace lubberline::ui
