// The survey of a compass base: its table, what it sums up to, and its drawing.

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>

#include <cmath>

#include "core/site/SiteSurvey.h"
#include "core/swing/SwingField.h"
#include "ui/kit/ClipboardRows.h"
#include "ui/kit/OpenCell.h"
#include "ui/kit/TableEntry.h"
#include "ui/kit/Words.h"
#include "ui/sites/PasteTable.h"
#include "ui/sites/SitesPage.h"
#include "ui/sites/SurveyDrawing.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

enum Column { East, North, Height, Declination, Total, kColumns };

/// Cells of a row as a point. Errors: InvalidInput, naming the cell.
Result<SurveyPoint> pointOf(const QStringList& cells)
{
    SurveyPoint point;
    const auto number = [&](int column, bool needed) -> Result<std::optional<double>> {
        if (cells.value(column).trimmed().isEmpty() && !needed)
            return std::optional<double>();
        const auto value = typedNumber(cells.value(column));
        if (!value)
            return Error{
                ErrorCode::InvalidInput, said(SitesPage::tr("'%1' is no number; expected metres, degrees or nT").arg(cells.value(column)))};
        return value;
    };
    const auto east = number(East, true), north = number(North, true), height = number(Height, false),
               declination = number(Declination, false), total = number(Total, false);
    for (const auto* each : {&east, &north, &height, &declination, &total})
        if (!*each)
            return each->error();
    point = {**east, **north, (*height).value_or(0), *declination, *total};
    if (!point.declination_deg && !point.total_nT)
        return Error{ErrorCode::InvalidInput, said(SitesPage::tr("a point of a survey has a declination or a total field"))};
    return point;
}

} // namespace

void SitesPage::buildSurvey()
{
    m_table->setColumnCount(kColumns);
    m_table->setObjectName(QStringLiteral("surveyTable"));
    m_table->setHorizontalHeaderLabels(
        {tr("east (m)"), tr("north (m)"), tr("height (m)"), tr("declination (°, E +)"), tr("total field (nT)")});
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->setToolTip(tr("From the centre of the base. Paste (Ctrl+V) takes columns from a spreadsheet"));
    new EnterAdvances(*m_table);
    connect(m_table, &QTableWidget::cellChanged, this, &SitesPage::takeSurvey, Qt::QueuedConnection);
    connect(m_table, &PasteTable::pasteWanted, this, &SitesPage::paste);
}

void SitesPage::showSurvey()
{
    if (waitsForCell(*m_table, this, &SitesPage::showSurvey))
        return;
    const Site& site = m_fields.record();
    const QSignalBlocker quiet(m_table);
    m_table->setRowCount(static_cast<int>(site.survey.size()) + 1);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const bool there = row < static_cast<int>(site.survey.size());
        const SurveyPoint point = there ? site.survey[static_cast<std::size_t>(row)] : SurveyPoint();
        const QStringList cells = there ? QStringList{optionalFigure(point.east_m), optionalFigure(point.north_m),
                                      optionalFigure(point.height_m), optionalFigure(point.declination_deg), optionalFigure(point.total_nT)}
                                        : QStringList();
        for (int column = 0; column < kColumns; ++column)
            m_table->setItem(row, column, new QTableWidgetItem(cells.value(column)));
    }
    m_drawing->setSurvey(site.survey);
    Swing today;
    today.date = m_today();
    const auto stamp = stampFor(today, site);
    const double horizontal_nT = stamp ? std::hypot(stamp->field.north_nT, stamp->field.east_nT) : 0;
    const auto summary = site.survey.empty() ? Result<SurveySummary>(Error{}) : summarise(site.survey, horizontal_nT);
    QStringList lines;
    if (summary) {
        if (const auto& d = summary->declination_deg)
            lines += tr("Declination %1° to %2°, mean %3°, range %4′ of %5 points.")
                         .arg(d->least, 0, 'f', 3)
                         .arg(d->most, 0, 'f', 3)
                         .arg(d->mean, 0, 'f', 3)
                         .arg(d->range() * 60, 0, 'f', 1)
                         .arg(d->count);
        if (const auto& f = summary->total_nT)
            lines += tr("Total field %1 to %2 nT, mean %3, range %4 nT.")
                         .arg(f->least, 0, 'f', 1)
                         .arg(f->most, 0, 'f', 1)
                         .arg(f->mean, 0, 'f', 1)
                         .arg(f->range(), 0, 'f', 2);
        if (summary->equivalent_deg)
            lines += tr("Half of that range turns a needle by %1° at most.").arg(*summary->equivalent_deg, 0, 'f', 3);
        lines += summary->meets == SiteClass::None ? tr("Meets no class.") : tr("Meets class %1.").arg(static_cast<int>(summary->meets));
        if (summary->declination_deg)
            lines += summary->withinMilitaryRange ? tr("Range within 12′ (MIL-STD-765A, per CNATRAINST 11130.1D).")
                                                  : tr("Range beyond 12′ (MIL-STD-765A, per CNATRAINST 11130.1D).");
    } else if (!site.survey.empty()) {
        lines += messageOf(summary.error());
    }
    m_summary->setText(inAngleStyle(lines.join(QStringLiteral(" "))));
}

/// The survey as the table says it; rows that are empty are left out.
void SitesPage::takeSurvey()
{
    Site after = m_fields.record();
    after.survey.clear();
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < kColumns; ++column)
            cells += m_table->item(row, column) ? m_table->item(row, column)->text() : QString();
        if (cells.join(QString()).trimmed().isEmpty())
            continue;
        const auto point = pointOf(cells);
        if (!point) { // a row that is being typed is stored when it is whole
            m_summary->setText(tr("Row %1 is not stored yet: %2").arg(row + 1).arg(messageOf(point.error())));
            return;
        }
        after.survey.push_back(*point);
    }
    if (!(after == m_fields.record()))
        store(after, tr("survey"));
}

void SitesPage::paste()
{
    Site after = m_fields.record();
    const auto rows = rowsOfClipboard(clipboardRows());
    if (!rows) {
        emit failed(messageOf(rows.error()));
        return;
    }
    for (std::size_t row = 0; row < rows->size(); ++row) {
        QStringList cells;
        for (const auto& cell : (*rows)[row])
            cells += toText(cell);
        const auto point = pointOf(cells);
        if (!point) {
            emit failed(tr("Line %1 of what is pasted: %2").arg(row + 1).arg(messageOf(point.error())));
            return; // all or nothing
        }
        after.survey.push_back(*point);
    }
    const std::size_t before = m_fields.record().survey.size();
    if (rows->empty())
        return;
    store(after, tr("survey"));
    if (before > 0 && m_fields.record() == after)
        say(tr("%1 points were added to the %2 of the survey before. Ctrl+Z takes them out.").arg(rows->size()).arg(before));
}

} // namespace lubberline::ui
