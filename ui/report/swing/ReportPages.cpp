#include "ui/report/swing/ReportPages.h"

#include "ui/report/swing/ReportBlocks.h"

namespace lubberline::ui {

ReportPages::ReportPages(ReportContent content, const QString& family, QSizeF sheet)
    : m_content(std::move(content))
    , m_family(family)
    , m_sheet(sheet)
    , m_body(bodyOf(m_content.frame, m_sheet))
    , m_blocks(reportBlocks(m_content, m_family, m_body.size()))
    , m_pages(paginate(m_blocks, m_body.height()))
{
}

void ReportPages::paint(QPainter& painter, int page) const
{
    paintFrame(painter, m_content.frame, m_family, m_sheet, page, count());
    paintBlocks(painter, m_pages[static_cast<std::size_t>(page)], m_body);
}

} // namespace lubberline::ui
