#include "ui/kit/ClipboardRows.h"

#include <QCoreApplication>

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

} // namespace

Result<CellRows> rowsOfClipboard(const QString& text)
{
    QString whole = text;
    whole.replace(QStringLiteral("\r\n"), QStringLiteral("\n")).replace(u'\r', u'\n');
    while (whole.endsWith(u'\n'))
        whole.chop(1);
    CellRows rows;
    RowSplitter splitter('\t');
    auto state = RowSplitter::State::Complete;
    for (const QString& line : whole.split(u'\n')) {
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
