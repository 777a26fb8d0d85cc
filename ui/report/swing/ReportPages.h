#pragma once
/// A report set on pages: particulars, readings and coefficients first, the plots and the signatures on the page after them.

#include <QSizeF>

#include "ui/report/page/Page.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

class ReportPages {
public:
    /// @param sheet [units of the page], as of sheetSize()
    ReportPages(ReportContent content, const QString& family, QSizeF sheet);
    ReportPages(const ReportPages&) = delete;
    ReportPages& operator=(const ReportPages&) = delete;

    [[nodiscard]] QSizeF sheet() const { return m_sheet; }
    [[nodiscard]] int count() const { return static_cast<int>(m_pages.size()); }
    /// @param page from 0
    void paint(QPainter& painter, int page) const;

private:
    ReportContent m_content;
    QString m_family;
    QSizeF m_sheet;
    QRectF m_body;
    std::vector<Block> m_blocks;                   ///< refer to m_content
    std::vector<std::vector<PlacedBlock>> m_pages; ///< point into m_blocks
};

} // namespace lubberline::ui
