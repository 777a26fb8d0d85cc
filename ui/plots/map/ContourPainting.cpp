#include "ui/plots/map/ContourPainting.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QTransform>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lubberline::ui {

namespace {

constexpr double kPerLabel = 420;  ///< of line, about
constexpr double kSpace = 3;       ///< between a label and the ends of its line
constexpr double kStraight = 0.93; ///< chord by arc: the line under a label bends no more than this

struct Gap {
    double from, to; ///< lengths along the line
};

std::vector<double> lengthsAlong(const QPolygonF& line)
{
    std::vector<double> lengths{0};
    for (qsizetype i = 1; i < line.size(); ++i)
        lengths.push_back(lengths.back() + std::hypot(line[i].x() - line[i - 1].x(), line[i].y() - line[i - 1].y()));
    return lengths;
}

QPointF pointAt(const QPolygonF& line, const std::vector<double>& lengths, double length)
{
    const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
    const auto i = next - lengths.begin();
    const double step = lengths[i] - lengths[i - 1];
    const double part = step > 0 ? std::clamp((length - lengths[i - 1]) / step, 0.0, 1.0) : 0.0;
    return line[i - 1] + part * (line[i] - line[i - 1]);
}

/// Liang and Barsky: the part [from, to] of a segment inside a rectangle.
bool clipSegment(QPointF a, QPointF b, const QRectF& clip, double& from, double& to)
{
    const QPointF d = b - a;
    const std::array<double, 4> p{-d.x(), d.x(), -d.y(), d.y()};
    const std::array<double, 4> q{a.x() - clip.left(), clip.right() - a.x(), a.y() - clip.top(), clip.bottom() - a.y()};
    for (std::size_t i = 0; i < 4; ++i) {
        if (p[i] == 0 && q[i] < 0)
            return false;
        if (p[i] < 0)
            from = std::max(from, q[i] / p[i]);
        else if (p[i] > 0)
            to = std::min(to, q[i] / p[i]);
    }
    return from < to;
}

/// Collects segments into polylines as long as they hang together.
class Pieces {
public:
    void add(QPointF a, QPointF b)
    {
        if (m_pieces.empty() || m_pieces.back().last() != a)
            m_pieces.push_back({a});
        m_pieces.back().append(b);
    }
    [[nodiscard]] std::vector<QPolygonF> take() { return std::move(m_pieces); }

private:
    std::vector<QPolygonF> m_pieces;
};

void addClipped(Pieces& pieces, QPointF a, QPointF b, double from, double to, const QRectF& clip)
{
    if (!clipSegment(a, b, clip, from, to))
        return;
    const QPointF d = b - a;
    pieces.add(from == 0 ? a : a + from * d, to == 1 ? b : a + to * d); // whole ends stay equal, so that pieces hang together
}

std::vector<QPolygonF> piecesOf(const QPolygonF& line, const std::vector<double>& lengths, const std::vector<Gap>& gaps, const QRectF& clip)
{
    if (gaps.empty() && clip.contains(line.boundingRect()))
        return {line};
    Pieces pieces;
    for (qsizetype i = 1; i < line.size(); ++i) {
        const double start = lengths[i - 1], step = lengths[i] - start;
        double from = 0;
        for (const Gap& gap : gaps) {
            const double before = step > 0 ? (gap.from - start) / step : 0, after = step > 0 ? (gap.to - start) / step : 0;
            if (after <= from || before >= 1)
                continue;
            if (before > from)
                addClipped(pieces, line[i - 1], line[i], from, before, clip);
            from = std::max(from, after);
        }
        if (from < 1)
            addClipped(pieces, line[i - 1], line[i], from, 1, clip);
    }
    return pieces.take();
}

/// Finds room for the labels of one line after the other.
class Labels {
public:
    Labels(const QRectF& clip, const QFont& font, std::vector<QRectF>& taken) : m_clip(clip), m_metrics(font), m_taken(taken) {}

    std::vector<Gap> place(const ContourStroke& stroke, const std::vector<double>& lengths)
    {
        std::vector<Gap> gaps;
        const double whole = lengths.back(), width = m_metrics.horizontalAdvance(stroke.label) + 2 * kSpace;
        if (stroke.label.isEmpty() || whole < 3 * width)
            return gaps;
        const int count = std::max(1, static_cast<int>(std::lround(whole / kPerLabel)));
        for (int i = 0; i < count; ++i) {
            for (const double offset : {0.0, -0.12, 0.12, -0.24, 0.24, -0.36, 0.36}) {
                const double middle = (i + 0.5 + offset) * whole / count;
                const Gap gap{middle - width / 2, middle + width / 2};
                if (gap.from < 0 || gap.to > whole || !tryAt(stroke, lengths, gap))
                    continue;
                gaps.push_back(gap);
                break;
            }
        }
        return gaps;
    }

    [[nodiscard]] const std::vector<ContourLabel>& placed() const { return m_placed; }

private:
    bool tryAt(const ContourStroke& stroke, const std::vector<double>& lengths, const Gap& gap)
    {
        const QPointF from = pointAt(stroke.line, lengths, gap.from), to = pointAt(stroke.line, lengths, gap.to);
        const QPointF chord = to - from;
        if (std::hypot(chord.x(), chord.y()) < kStraight * (gap.to - gap.from))
            return false;
        double turned_deg = std::atan2(chord.y(), chord.x()) * 180 / M_PI;
        if (turned_deg > 90 || turned_deg <= -90)
            turned_deg += turned_deg > 0 ? -180 : 180; // upright
        const QPointF at = (from + to) / 2;
        QRectF flat(0, 0, gap.to - gap.from, m_metrics.height());
        flat.moveCenter({0, 0});
        const QRectF box = QTransform().translate(at.x(), at.y()).rotate(turned_deg).mapRect(flat);
        const auto overlaps = [&box](const QRectF& other) { return other.intersects(box); };
        if (!m_clip.contains(box) || std::any_of(m_taken.begin(), m_taken.end(), overlaps))
            return false;
        m_taken.push_back(box);
        m_placed.push_back({stroke.label, at, turned_deg, box});
        return true;
    }

    QRectF m_clip;
    QFontMetricsF m_metrics;
    std::vector<QRectF>& m_taken;
    std::vector<ContourLabel> m_placed;
};

void drawLabel(QPainter& painter, const ContourLabel& label, const QFontMetricsF& metrics)
{
    painter.save();
    painter.translate(label.at);
    painter.rotate(label.turned_deg);
    painter.drawText(QPointF(-metrics.horizontalAdvance(label.text) / 2, (metrics.ascent() - metrics.descent()) / 2), label.text);
    painter.restore();
}

} // namespace

std::vector<QPolygonF> clippedLine(const QPolygonF& line, const QRectF& clip) { return piecesOf(line, lengthsAlong(line), {}, clip); }

std::vector<ContourLabel> paintContours(
    QPainter& painter, const std::vector<ContourStroke>& strokes, const QRectF& clip, const QFont& font, std::vector<QRectF>& taken)
{
    Labels labels(clip, font, taken);
    painter.setFont(font);
    painter.setBrush(Qt::NoBrush);
    for (const ContourStroke& stroke : strokes) {
        if (stroke.line.size() < 2)
            continue;
        const std::size_t before = labels.placed().size();
        const std::vector<double> lengths = lengthsAlong(stroke.line);
        const std::vector<Gap> gaps = labels.place(stroke, lengths);
        painter.setPen(stroke.pen);
        for (const QPolygonF& piece : piecesOf(stroke.line, lengths, gaps, clip))
            painter.drawPolyline(piece);
        for (std::size_t i = before; i < labels.placed().size(); ++i)
            drawLabel(painter, labels.placed()[i], QFontMetricsF(font));
    }
    return labels.placed();
}

} // namespace lubberline::ui
