#include "ui/report/swing/ReportBlocks.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <numeric>
#include <utility>

#include "ui/plots/swing/PlotRendering.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/FieldBlocks.h"

namespace lubberline::ui {

namespace {

constexpr double kGap = mm(2.2);
constexpr double kFactSize_pt = 8;
constexpr double kMethodSize_pt = 7;

Block gap(double height)
{
    return {height, [](QPainter&, const QRectF&) {}};
}

QColor tintFor(Verdict verdict)
{
    switch (verdict) {
    case Verdict::InLimits: return Ink::passTint();
    case Verdict::OutOfLimits: return Ink::failTint();
    case Verdict::NotKnown: break;
    }
    return Ink::shaded();
}

/// The word in large type with its reason beside it, in a frame: the word says it on a grey copy too.
Block verdictBlock(const ReportContent& content, const QString& family, double width)
{
    const QFont words = documentFont(family, 8.5);
    const QFont verdict = documentFont(family, 14, true);
    const double left = QFontMetricsF(verdict).horizontalAdvance(content.verdictWord) + mm(8);
    const double textHeight = wrappedHeight(words, width - left - mm(3), content.verdictSentence);
    const double height = std::max(mm(10), textHeight + mm(3));
    return {height, [&content, words, verdict, left, textHeight](QPainter& painter, const QRectF& rect) {
                painter.setPen(QPen(Ink::strong(), mm(0.3)));
                painter.setBrush(tintFor(content.verdict));
                painter.drawRect(rect);
                painter.setPen(Ink::text());
                const double baseline = rect.center().y() + QFontMetricsF(verdict).capHeight() / 2;
                paintLine(painter, verdict, {rect.left() + mm(4), baseline}, Qt::AlignLeft, content.verdictWord);
                paintWrapped(painter, words,
                    QRectF(rect.left() + left, rect.center().y() - textHeight / 2, rect.width() - left - mm(3), textHeight),
                    content.verdictSentence);
            }};
}

std::vector<Block> warningBlocks(const ReportContent& content, const QString& family, double width)
{
    if (content.warnings.isEmpty())
        return {};
    std::vector<Block> blocks{titleBlock(Words::tr("What the readings cannot tell"), family)};
    append(blocks, listBlocks(content.warnings, family, kFactSize_pt, width));
    return blocks;
}

using RenderPlot = void (*)(QPainter&, const QRectF&, const SwingPicture&);

void paintPlot(
    QPainter& painter, const QRectF& rect, const QString& title, const QFont& font, RenderPlot render, const SwingPicture& picture)
{
    const double titleHeight = mm(4.4);
    painter.setPen(Ink::text());
    paintLine(painter, font, {rect.left(), rect.top() + mm(3)}, Qt::AlignLeft, title);
    render(painter, rect.adjusted(0, titleHeight, 0, 0), picture);
}

Block polarAndSpectrum(const ReportContent& content, const QString& family, double height)
{
    const QFont font = documentFont(family, 8.5, true);
    return {height, [&content, font](QPainter& painter, const QRectF& rect) {
                const double half = (rect.width() - mm(4)) / 2;
                paintPlot(painter, QRectF(rect.left(), rect.top(), half, rect.height()), Words::tr("Deviation, polar"), font, renderPolar,
                    content.picture);
                paintPlot(painter, QRectF(rect.right() - half, rect.top(), half, rect.height()), Words::tr("Spectrum of deviation"), font,
                    renderSpectrum, content.picture);
            }};
}

Block curve(const ReportContent& content, const QString& family, double height)
{
    const QFont font = documentFont(family, 8.5, true);
    return {height, [&content, font](QPainter& painter, const QRectF& rect) {
                paintPlot(painter, rect, Words::tr("Deviation and residuals against heading"), font, renderCurve, content.picture);
            }};
}

Block signatureBlock(const ReportContent& content, const QString& family, double width)
{
    const double line = mm(7.6);
    const QFont font = documentFont(family, 8);
    const QFont small = documentFont(family, 6.5);
    const QFont title = documentFont(family, 9.5, true);
    const double height = mm(5.5) + line * static_cast<double>(content.signatures.size());
    return {height, [&content, line, font, small, title, family, width](QPainter& painter, const QRectF& rect) {
                painter.setPen(Ink::text());
                paintLine(painter, title, {rect.left(), rect.top() + mm(4.2)}, Qt::AlignLeft, Words::tr("Signatures"));
                const double nameLeft = rect.left() + mm(30), dateLeft = rect.left() + width * 0.47, signLeft = rect.left() + width * 0.64;
                for (const auto& [at, text] :
                    {std::pair{nameLeft, Words::tr("name")}, {dateLeft, Words::tr("date")}, {signLeft, Words::tr("signature")}})
                    paintLine(painter, small, {at, rect.top() + mm(4.2)}, Qt::AlignLeft, text);
                double y = rect.top() + mm(5.5) + line - mm(1);
                for (const SignatureLine& signature : content.signatures) {
                    painter.setPen(Ink::text());
                    paintLine(painter, font, {rect.left(), y - mm(0.8)}, Qt::AlignLeft, signature.role);
                    paintLine(painter, fitted(family, 8, false, dateLeft - nameLeft - mm(3), signature.name), {nameLeft, y - mm(0.8)},
                        Qt::AlignLeft, signature.name);
                    paintLine(painter, font, {dateLeft, y - mm(0.8)}, Qt::AlignLeft, signature.date);
                    paintLine(painter, fitted(family, 8, false, rect.right() - signLeft, signature.sign), {signLeft, y - mm(0.8)},
                        Qt::AlignLeft, signature.sign);
                    painter.setPen(QPen(Ink::strong(), mm(0.15)));
                    painter.drawLine(QPointF(nameLeft, y), QPointF(dateLeft - mm(2), y));
                    painter.drawLine(QPointF(dateLeft, y), QPointF(signLeft - mm(2), y));
                    painter.drawLine(QPointF(signLeft, y), QPointF(rect.right(), y));
                    y += line;
                }
            }};
}

/// All before the plots.
std::vector<Block> recordBlocks(const ReportContent& content, const QString& family, double width, double row)
{
    std::vector<Block> blocks{verdictBlock(content, family, width), gap(kGap)};
    append(blocks, factBlocks(content.facts, {family, kFactSize_pt, mm(28)}, width));
    for (const Table* table : {&content.readings, &content.coefficients, &content.fits})
        append(blocks, tableBlocks(*table, width, family, row));
    append(blocks, warningBlocks(content, family, width));
    return blocks;
}

/// The rows stand closer where that saves a page: no page for the last few rows alone.
std::vector<Block> recordBlocks(const ReportContent& content, const QString& family, QSizeF body)
{
    auto usual = recordBlocks(content, family, body.width(), kTableRow);
    const auto pages = paginate(usual, body.height()).size();
    if (pages == 1)
        return usual;
    auto dense = recordBlocks(content, family, body.width(), kDenseTableRow);
    return paginate(dense, body.height()).size() < pages ? dense : usual;
}

/// What the last page has left.
double roomBelow(const std::vector<Block>& blocks, double bodyHeight)
{
    const auto pages = paginate(blocks, bodyHeight);
    const PlacedBlock& last = pages.back().back();
    return std::max(0.0, bodyHeight - last.top - last.block->height);
}

std::vector<Block> methodBlocks(const ReportContent& content, const QString& family, double width)
{
    std::vector<Block> blocks{gap(kGap), titleBlock(Words::tr("Signs and methods"), family)};
    append(blocks, factBlocks(content.method, {family, kMethodSize_pt, mm(24)}, width));
    return blocks;
}

/// The curve with its residuals and the polar plot share what the words leave of the page, within what can still be read and
/// what need not be larger.
constexpr double kLeastCurve = mm(74), kMostCurve = mm(96), kLeastPolar = mm(62), kMostPolar = mm(100);

std::vector<Block> plotBlocks(const ReportContent& content, const QString& family, double room)
{
    const double curveHeight = std::clamp((room - kGap) * 0.51, kLeastCurve, kMostCurve);
    return {polarAndSpectrum(content, family, std::clamp(room - kGap - curveHeight, kLeastPolar, kMostPolar)), gap(kGap),
        curve(content, family, curveHeight)};
}

/// The blocks of the methods that fit where the tables end; a title alone, or one line beneath it, is none.
std::size_t fitting(const std::vector<Block>& methods, double room)
{
    constexpr std::size_t kLeast = 4; // gap, title, two lines
    double height = 0;
    std::size_t count = 0;
    while (count < methods.size() && height + methods[count].height <= room)
        height += methods[count++].height;
    return count < kLeast ? 0 : count;
}

/// What the tables leave of their last page is used before another page is begun: for all of the rest, else for the methods, else for the
/// polar plot, else for as much of the methods as fits. The plots have what the words leave of their page.
/// @param field what is said of the Earth's field: it comes last, unless the page before the plots has room for all of it; then it is taken
void appendPlots(std::vector<Block>& blocks, const ReportContent& content, const QString& family, QSizeF body, std::vector<Block>& field)
{
    std::vector<Block> methods = methodBlocks(content, family, body.width());
    std::vector<Block> signatures{gap(kGap), signatureBlock(content, family, body.width())};
    const double below = roomBelow(blocks, body.height()) - mm(0.2), whole = body.height() - mm(0.2);
    const double words = heightOf(methods) + heightOf(signatures);
    if (below >= kLeastPolar + kGap + kLeastCurve + words) {
        append(blocks, plotBlocks(content, family, below - words));
        append(blocks, std::move(methods));
    } else if (below >= kLeastPolar + kGap && below < heightOf(methods)) {
        blocks.push_back(gap(kGap));
        blocks.push_back(polarAndSpectrum(content, family, std::min(below - kGap, kMostPolar)));
        Block large = curve(content, family, std::clamp(whole - words, kLeastCurve, kMostCurve));
        large.newPage = true;
        blocks.push_back(std::move(large));
        append(blocks, std::move(methods));
    } else {
        const auto here = static_cast<std::ptrdiff_t>(fitting(methods, below));
        std::vector<Block> rest(methods.begin() + here, methods.end());
        methods.erase(methods.begin() + here, methods.end());
        const double left = below - heightOf(methods) - kGap;
        append(blocks, std::move(methods));
        if (here > 0 && rest.empty() && !field.empty() && heightOf(field) <= left) {
            field.front().newPage = false;
            blocks.push_back(gap(kGap));
            append(blocks, std::exchange(field, {}));
        }
        const bool begun = here > 0 && !rest.empty(); // the methods go on at the top of the page of the plots
        std::vector<Block> plots = plotBlocks(content, family, whole - heightOf(rest) - heightOf(signatures));
        (begun ? rest : plots).front().newPage = true;
        if (begun) {
            append(blocks, std::move(rest));
            rest.clear();
        }
        append(blocks, std::move(plots));
        append(blocks, std::move(rest));
    }
    append(blocks, std::move(signatures));
}

} // namespace

std::vector<Block> reportBlocks(const ReportContent& content, const QString& family, QSizeF body)
{
    std::vector<Block> blocks = recordBlocks(content, family, body);
    std::vector<Block> field = content.field ? fieldBlocks(*content.field, family, body) : std::vector<Block>();
    appendPlots(blocks, content, family, body, field);
    for (std::size_t i = 0; i < content.job.size(); ++i) {
        auto table = tableBlocks(content.job[i], body.width(), family, kDenseTableRow);
        table.front().newPage = i == 0;
        append(blocks, std::move(table));
    }
    append(blocks, std::move(field));
    return blocks;
}

} // namespace lubberline::ui
