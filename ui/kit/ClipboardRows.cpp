#include "ui/kit/ClipboardRows.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QMimeData>
#include <QTextDocument>
#include <QTextTable>

#include <algorithm>

#include "core/base/FileText.h"
#include "core/format/csv/RowSplitter.h"
#include "core/format/csv/TextCell.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct ClipboardWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Clipboard)
};

constexpr std::size_t kMostRows = 10'000;

Error wrongRows(const QString& message) { return {ErrorCode::InvalidInput, said(message)}; }

bool isEmpty(const std::vector<std::string>& row)
{
    return std::all_of(row.begin(), row.end(), [](const std::string& cell) { return trimmed(cell).empty(); });
}

std::string clipboardCell(const std::string& cell)
{
    const bool plain = cell.find_first_of("\t\n\r") == std::string::npos && !cell.starts_with('"');
    return plain ? cell : csvQuoted(cell);
}

/// As the lines of a CSV of a country with decimal commas; a note may have a semicolon, too.
bool hasSemicolons(const QStringList& lines)
{
    qsizetype each = 0;
    bool figures = false;
    for (const QString& line : lines) {
        if (line.trimmed().isEmpty())
            continue;
        const qsizetype here = line.count(u';');
        if (here == 0 || line.contains(u'\t') || (each > 0 && here != each))
            return false;
        each = here;
        const QString first = line.section(u';', 0, 0).trimmed();
        figures |= !first.isEmpty() && (first.front().isDigit() || first.front() == u'-' || first.front() == u'+');
    }
    return figures;
}

/// What HTML names from elsewhere is not fetched.
class BareDocument final : public QTextDocument {
    QVariant loadResource(int, const QUrl&) override { return {}; }
};

CellRows rowsOfHtml(const QString& html)
{
    BareDocument document;
    document.setHtml(html);
    for (auto frame = document.rootFrame()->begin(); !frame.atEnd(); ++frame) {
        const auto* table = qobject_cast<QTextTable*>(frame.currentFrame());
        if (!table)
            continue;
        CellRows rows(static_cast<std::size_t>(table->rows()));
        for (int row = 0; row < table->rows(); ++row)
            for (int column = 0; column < table->columns(); ++column) {
                const QTextTableCell cell = table->cellAt(row, column);
                QTextCursor text = cell.firstCursorPosition();
                text.setPosition(cell.lastCursorPosition().position(), QTextCursor::KeepAnchor);
                const bool begins = cell.row() == row && cell.column() == column; // of a cell over several it is once
                rows[static_cast<std::size_t>(row)].push_back(begins ? text.selectedText().simplified().toStdString() : std::string());
            }
        return rows;
    }
    return {};
}

QString htmlOf(const CellRows& rows)
{
    QString html = QStringLiteral("<table>");
    for (const auto& row : rows) {
        html += QStringLiteral("<tr>");
        for (const auto& cell : row)
            html += QStringLiteral("<td>%1</td>").arg(toText(cell).toHtmlEscaped());
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

} // namespace

QString clipboardRows()
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    if (!data)
        return {};
    if (data->hasHtml() && !data->text().contains(u'\t'))
        if (const CellRows rows = rowsOfHtml(data->html()); !rows.empty())
            return clipboardText(rows);
    return data->text();
}

void putRowsOnClipboard(const QString& text)
{
    auto* data = new QMimeData;
    data->setText(text);
    if (const auto rows = rowsOfClipboard(text))
        data->setHtml(htmlOf(*rows));
    QGuiApplication::clipboard()->setMimeData(data);
}

Result<CellRows> rowsOfClipboard(const QString& text)
{
    QString whole = text;
    whole.replace(QStringLiteral("\r\n"), QStringLiteral("\n")).replace(u'\r', u'\n');
    while (whole.endsWith(u'\n'))
        whole.chop(1);
    CellRows rows;
    const QStringList lines = whole.split(u'\n');
    RowSplitter splitter(hasSemicolons(lines) ? ';' : '\t');
    auto state = RowSplitter::State::Complete;
    for (const QString& line : lines) {
        state = state == RowSplitter::State::Open ? splitter.resume(line.toStdString()) : splitter.begin(line.toStdString());
        if (state == RowSplitter::State::TextAfterQuote)
            return wrongRows(ClipboardWords::tr("row %1 of what is pasted has text behind a closing quote").arg(rows.size() + 1));
        if (state == RowSplitter::State::Open)
            continue;
        rows.push_back(splitter.cells());
        if (rows.size() > kMostRows)
            return wrongRows(ClipboardWords::tr("more than %1 rows are to be pasted; expected a table of readings").arg(kMostRows));
    }
    if (state == RowSplitter::State::Open)
        return wrongRows(ClipboardWords::tr("a quote that begins in row %1 of what is pasted is not closed").arg(rows.size() + 1));
    while (!rows.empty() && isEmpty(rows.back()))
        rows.pop_back();
    std::size_t widest = 0;
    for (const auto& row : rows)
        widest = std::max(widest, row.size());
    for (auto& row : rows)
        row.resize(widest);
    return rows;
}

QString clipboardText(const CellRows& rows)
{
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i)
            text += (i == 0 ? "" : "\t") + clipboardCell(row[i]);
        text += '\n';
    }
    return QString::fromStdString(text);
}

} // namespace lubberline::ui
