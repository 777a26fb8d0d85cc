#include "ui/report/card/CardPlacard.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "ui/report/card/CardWords.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/Page.h"
#include "ui/report/page/QrCode.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

constexpr double kPadding = mm(2);
constexpr double kHeadHeight = mm(4);
constexpr double kDraftHeight = mm(3.2);  ///< the bar over and under the figures that nobody signed
constexpr double kLimitsHeight = mm(4.4); ///< the bar across all figures of a compass that is out of its limits, above and below
constexpr double kTopHeight = mm(19);     ///< whose card it is and what it holds for
constexpr double kQr = mm(11.4);          ///< beside the first lines of the foot
constexpr double kBannerHeight = mm(4.2);

/// Rows and figures as large as the number of rows allows.
struct RowSize {
    double height = mm(6.6), digits_pt = 15;
};
RowSize rowSizeOf(const CardInput& input)
{
    const int step_deg = input.columns.front().card.options.step_deg;
    if (step_deg <= 10)
        return {mm(4.4), 10};
    if (step_deg <= 15)
        return {mm(5.4), 12.5};
    return input.columns.size() > 1 ? RowSize{mm(6.6), 13} : RowSize{}; // with room for marks
}

std::size_t rowsInHalf(const CardInput& input) { return (input.columns.front().card.rows.size() + 1) / 2; }

double bannerHeight(const CardInput& input) { return cardBanner(input).isEmpty() ? 0 : kBannerHeight; }

bool byCompass(const CardInput& input) { return input.columns.front().card.options.by == CardBy::Compass; }

/// Two columns have a line over them that says what they are.
double headHeight(const CardInput& input) { return kHeadHeight * (input.columns.size() > 1 ? 2 : 1); }

double draftHeight(const CardInput& input)
{
    return std::all_of(input.columns.begin(), input.columns.end(), [](const CardColumn& column) { return column.isSigned(); })
        ? 0
        : kDraftHeight;
}

double limitsHeight(const CardInput& input)
{
    return std::any_of(input.columns.begin(), input.columns.end(), [](const CardColumn& column) { return column.outOfLimits(); })
        ? kLimitsHeight
        : 0;
}

double tableHeight(const CardInput& input)
{
    return 2 * limitsHeight(input) + headHeight(input) + 2 * draftHeight(input)
        + rowSizeOf(input).height * static_cast<double>(rowsInHalf(input));
}

QString compassLine(const CompassSystem& compass)
{
    const QString serial = printable(compass.serialNumber);
    return joined({printable(compass.name).toUpper(), labelled(Words::tr("S/N"), serial.isEmpty() ? QStringLiteral("________") : serial)});
}

/// What all columns say, or each of them.
template <class Say>
QString ofColumns(const CardInput& input, const Say& say)
{
    QStringList all;
    for (const CardColumn& column : input.columns)
        if (const QString text = say(column.record); !all.contains(text))
            all += text;
    return all.join(QStringLiteral(" / "));
}

/// The state in which the card holds; the radio's is left to the columns where there are two.
QString configurationLine(const CardInput& input)
{
    const QString state = ofColumns(input, [&input](const SwingRecord& record) {
        Configuration configuration = record.swing.configuration;
        if (input.columns.size() > 1)
            configuration.radio = RadioState::NotStated;
        const QString words = configurationWords(configuration);
        return words.isEmpty() ? Words::tr("CONFIGURATION NOT STATED") : words.toUpper();
    });
    return joined({state, labelled(Words::tr("OVER 10° WITH"), input.loadsToName.join(QStringLiteral(", ")).toUpper())});
}

/// A line of the foot.
struct FootLine {
    QString text;
    bool bold = false;
};

std::vector<FootLine> footLines(const CardInput& input)
{
    std::vector<FootLine> lines;
    const bool several = input.columns.size() > 1;
    for (const CardColumn& column : input.columns) {
        const auto of = [&](const QString& text) { return several ? QStringLiteral("%1: %2").arg(column.heading, text) : text; };
        lines.push_back({of(recordLine(column))});
        for (const QString& signature : signatureLinesOf(column))
            lines.push_back({signature, !column.isSigned()});
        lines.push_back({qualityLine(column)});
        lines.push_back({largestLine(column)});
        for (const QString& remark : shortRemarks(column))
            lines.push_back({remark, true});
    }
    lines.push_back({Words::tr("Next swing due %1").arg(input.nextDue.isEmpty() ? QStringLiteral("____________") : input.nextDue)});
    if (!input.reprintOf.isEmpty())
        lines.push_back({Words::tr("Reprint of %1").arg(input.reprintOf), true});
    lines.push_back({byCompass(input) ? Words::tr("When the compass reads COMPASS, the magnetic heading is MAGNETIC.")
                                      : Words::tr("Steer this by compass to make good FOR (magnetic).")});
    lines.push_back({Words::tr("Deviation = magnetic − compass, E +")});
    return lines;
}

/// The lines of the foot where they stand, from its top; those beside the QR code are shorter.
struct FootText {
    QString text;
    QFont font;
    QRectF rect;
};
std::vector<FootText> footText(const CardInput& input, const QString& family, double width)
{
    constexpr double kSize_pt = 5.5, kGap = mm(0.35);
    std::vector<FootText> placed;
    double top = mm(0.8);
    for (const FootLine& line : footLines(input)) {
        const double room = top < kQr + mm(1) ? width - kQr - mm(1) : width;
        const QFont font = documentFont(family, kSize_pt, line.bold);
        const double height = wrappedHeight(font, room, line.text);
        placed.push_back({line.text, font, QRectF(0, top, room, height)});
        top += height + kGap;
    }
    return placed;
}

double placardWidth(const CardInput& input) { return input.columns.size() > 1 ? mm(84) : mm(60); }

double footHeight(const CardInput& input, const QString& family)
{
    return std::max(footText(input, family, placardWidth(input) - 2 * kPadding).back().rect.bottom(), kQr) + mm(1.2);
}

/// Lines of small type under each other, each as large as fits.
class SmallLines {
public:
    SmallLines(QPainter& painter, const QRectF& room, const QString& family)
        : m_painter(painter)
        , m_room(room)
        , m_family(family)
        , m_y(room.top())
    {
    }
    void add(const QString& text, double size_pt, double height, bool bold = false)
    {
        m_y += height;
        paintLine(m_painter, fitted(m_family, size_pt, bold, m_room.width(), text), {m_room.left(), m_y}, Qt::AlignLeft, text);
    }
    [[nodiscard]] double y() const { return m_y; }

private:
    QPainter& m_painter;
    QRectF m_room;
    QString m_family;
    double m_y;
};

/// As large as it fits, on several lines if need be; what does not fit at the smallest size stands on the page around the card.
void paintConfiguration(QPainter& painter, const QRectF& rect, QString text, const QString& family)
{
    constexpr double kLargest_pt = 6.5, kSmallest_pt = 4;
    double size_pt = kLargest_pt;
    while (size_pt > kSmallest_pt && wrappedHeight(documentFont(family, size_pt, true), rect.width(), text) > rect.height())
        size_pt -= 0.25;
    const QFont font = documentFont(family, size_pt, true);
    while (text.size() > 1 && wrappedHeight(font, rect.width(), text) > rect.height())
        text = text.left(text.size() - 2).trimmed() + QChar(0x2026);
    paintWrapped(painter, font, rect, text);
}

void paintTop(QPainter& painter, const QRectF& room, const CardInput& input, const QString& family)
{
    const SwingRecord& record = input.record();
    const QString date = ofColumns(input, [](const SwingRecord& one) { return printable(one.swing.date); });
    const QFont dateFont = documentFont(family, 7);
    const double dateWidth = QFontMetricsF(dateFont).horizontalAdvance(date) + mm(2);
    const QString registration = printable(record.aircraft.registration);
    painter.setPen(Ink::text());
    paintLine(painter, dateFont, {room.right(), room.top() + mm(4.2)}, Qt::AlignRight, date);
    SmallLines lines(painter, room.adjusted(0, 0, -dateWidth, 0), family);
    lines.add(registration, 11, mm(4.2), true);
    SmallLines below(painter, QRectF(room.left(), lines.y(), room.width(), room.height()), family);
    below.add(compassLine(record.compass), 6.5, mm(3.4));
    const QString site
        = ofColumns(input, [](const SwingRecord& one) { return one.site ? printable(one.site->name) : Words::tr("a site not stated"); });
    below.add(Words::tr("Swung at %1").arg(site), 6, mm(3));
    const double top = below.y() + mm(1);
    paintConfiguration(painter, QRectF(QPointF(room.left(), top), QPointF(room.right(), room.top() + kTopHeight - mm(1.4))),
        configurationLine(input), family);
}

/// One half of the table: FOR, then each STEER.
struct Half {
    QRectF rect;
    std::size_t first = 0, count = 0;
};

/// What stands over a column of figures.
QString headOf(const CardInput& input, const CardColumn& column)
{
    return input.columns.size() == 1 && byCompass(input) ? Words::tr("MAGNETIC") : column.heading;
}

/// One size for all headings: the one at which the longest fits.
QFont headingFont(const CardInput& input, const QString& family, double width)
{
    QString longest = byCompass(input) ? Words::tr("COMPASS") : QString();
    for (const CardColumn& column : input.columns)
        if (const QString head = headOf(input, column); head.size() > longest.size())
            longest = head;
    return fitted(family, 7, true, width, longest);
}

/// White on black: no copy loses it, and whoever cuts it off cuts the figures.
void paintBar(QPainter& painter, const QRectF& rect, const QString& word, const QString& family)
{
    painter.fillRect(rect.adjusted(mm(0.3), mm(0.15), -mm(0.3), -mm(0.15)), Qt::black);
    painter.setPen(Qt::white);
    const QFont font = fitted(family, rect.height() > kDraftHeight ? 10 : 8, true, rect.width() - mm(1), word);
    paintLine(painter, font, {rect.center().x(), rect.center().y() + QFontMetricsF(font).capHeight() / 2}, Qt::AlignHCenter, word);
    painter.setPen(Ink::text());
}

void paintHalfHead(QPainter& painter, const Half& half, const CardInput& input, const QString& family)
{
    const double column = half.rect.width() / static_cast<double>(input.columns.size() + 1);
    const double baseline = half.rect.top() + headHeight(input) - mm(1.1);
    const QFont headings = headingFont(input, family, column - mm(0.8));
    paintLine(painter, byCompass(input) ? headings : documentFont(family, 7, true), {half.rect.left() + column / 2, baseline},
        Qt::AlignHCenter, byCompass(input) ? Words::tr("COMPASS") : Words::tr("FOR"));
    if (input.columns.size() > 1)
        paintLine(painter, documentFont(family, 7, true), {half.rect.left() + column * 2, half.rect.top() + kHeadHeight - mm(1.1)},
            Qt::AlignHCenter, byCompass(input) ? Words::tr("MAGNETIC") : Words::tr("STEER"));
    for (std::size_t i = 0; i < input.columns.size(); ++i)
        paintLine(painter, headings, {half.rect.left() + column * (static_cast<double>(i) + 1.5), baseline}, Qt::AlignHCenter,
            headOf(input, input.columns[i]));
}

void paintRow(QPainter& painter, const QRectF& rect, const CardInput& input, std::size_t row, const QString& family)
{
    const RowSize size = rowSizeOf(input);
    const double column = rect.width() / static_cast<double>(input.columns.size() + 1);
    const QFont digits = documentFont(family, size.digits_pt, true), lighter = documentFont(family, size.digits_pt);
    const double baseline = rect.top() + (size.height + QFontMetricsF(digits).capHeight()) / 2;
    painter.setPen(QPen(Ink::strong(), mm(0.15)));
    painter.drawLine(rect.topLeft(), rect.topRight());
    painter.setPen(Ink::text());
    const CardRow& first = input.columns.front().card.rows[row];
    paintLine(painter, lighter, {rect.left() + column / 2, baseline}, Qt::AlignHCenter,
        threeDigits(byCompass(input) ? first.steerRounded_deg() : first.magneticRounded_deg()));
    for (std::size_t c = 0; c < input.columns.size(); ++c) {
        const CardRow& here = input.columns[c].card.rows[row];
        const QString figure = threeDigits(byCompass(input) ? here.magneticRounded_deg() : here.steerRounded_deg());
        const double middle = rect.left() + column * (static_cast<double>(c) + 1.5);
        paintLine(painter, digits, {middle, baseline}, Qt::AlignHCenter, figure);
        if (const QString mark = markOf(here, input.columns[c]); !mark.isEmpty())
            paintLine(painter, documentFont(family, size.digits_pt * 0.6, true),
                {middle + QFontMetricsF(digits).horizontalAdvance(figure) / 2 + mm(0.2),
                    baseline - QFontMetricsF(digits).capHeight() * 0.4},
                Qt::AlignLeft, mark);
    }
}

void paintHalf(QPainter& painter, const Half& half, const CardInput& input, const QString& family)
{
    const double column = half.rect.width() / static_cast<double>(input.columns.size() + 1), row = rowSizeOf(input).height;
    painter.fillRect(QRectF(half.rect.left(), half.rect.top(), column, half.rect.height()), Ink::shaded());
    painter.setPen(Ink::text());
    paintHalfHead(painter, half, input, family);
    const double top = half.rect.top() + headHeight(input) + draftHeight(input);
    for (std::size_t i = 0; i < half.count; ++i)
        paintRow(
            painter, QRectF(half.rect.left(), top + row * static_cast<double>(i), half.rect.width(), row), input, half.first + i, family);
    for (std::size_t c = 0; c < input.columns.size(); ++c) {
        if (input.columns[c].isSigned())
            continue;
        const double left = half.rect.left() + column * static_cast<double>(c + 1);
        const QString mark = unsignedMark(input.columns[c]);
        paintBar(painter, QRectF(left, top - kDraftHeight, column, kDraftHeight), mark, family);
        paintBar(painter, QRectF(left, half.rect.bottom() - kDraftHeight, column, kDraftHeight), mark, family);
    }
}

/// Across the whole card, above and below its figures.
QRectF paintLimits(QPainter& painter, const QRectF& rect, const CardInput& input, const QString& family)
{
    const double height = limitsHeight(input);
    if (height == 0)
        return rect;
    const QString word = Words::tr("OUT OF LIMITS");
    for (const double top : {rect.top(), rect.bottom() - height})
        paintBar(painter, QRectF(rect.left(), top, rect.width(), height), word, family);
    return rect.adjusted(0, height, 0, -height);
}

void paintFigures(QPainter& painter, const QRectF& all, const CardInput& input, const QString& family)
{
    const QRectF rect = paintLimits(painter, all, input, family);
    const std::size_t count = input.columns.front().card.rows.size(), left = rowsInHalf(input);
    const double middle = rect.center().x();
    paintHalf(painter, {QRectF(rect.topLeft(), QPointF(middle, rect.bottom())), 0, left}, input, family);
    paintHalf(painter, {QRectF(QPointF(middle, rect.top()), rect.bottomRight()), left, count - left}, input, family);
    painter.setPen(QPen(Ink::strong(), mm(0.4)));
    painter.drawLine(rect.topLeft(), rect.topRight());
    painter.drawLine(rect.bottomLeft(), rect.bottomRight());
    painter.drawLine(QPointF(middle, rect.top()), QPointF(middle, rect.bottom()));
}

void paintFoot(QPainter& painter, const QRectF& room, const CardInput& input, const QString& family)
{
    painter.setPen(Ink::text());
    if (const auto code = qrOf(printable(input.record().swing.record))) // none where the swing has no record yet
        paintQr(painter, QRectF(room.right() - kQr, room.top() + mm(0.3), kQr, kQr), *code);
    for (const FootText& line : footText(input, family, room.width()))
        paintWrapped(painter, line.font, line.rect.translated(room.topLeft()), line.text);
}

} // namespace

QSizeF placardSize(const CardInput& input, const QString& family)
{
    return {placardWidth(input), bannerHeight(input) + kTopHeight + tableHeight(input) + footHeight(input, family)};
}

void paintPlacard(QPainter& painter, const QRectF& rect, const CardInput& input, const QString& family)
{
    const QRectF room = rect.adjusted(kPadding, 0, -kPadding, 0);
    const QString banner = cardBanner(input);
    double y = rect.top();
    if (!banner.isEmpty()) {
        painter.setPen(Ink::alarm());
        y += kBannerHeight;
        paintLine(painter, fitted(family, 9, true, room.width(), banner), {room.center().x(), y - mm(0.4)}, Qt::AlignHCenter, banner);
    }
    paintTop(painter, QRectF(room.left(), y + mm(0.8), room.width(), kTopHeight), input, family);
    y += kTopHeight;
    paintFigures(painter, QRectF(room.left(), y, room.width(), tableHeight(input)), input, family);
    paintFoot(painter, QRectF(room.left(), y + tableHeight(input), room.width(), footHeight(input, family)), input, family);
}

void paintCropMarks(QPainter& painter, const QRectF& rect)
{
    const double clear = mm(1), length = mm(5);
    painter.setPen(QPen(Qt::black, mm(0.1)));
    for (const double x : {rect.left(), rect.right()}) {
        painter.drawLine(QPointF(x, rect.top() - clear), QPointF(x, rect.top() - clear - length));
        painter.drawLine(QPointF(x, rect.bottom() + clear), QPointF(x, rect.bottom() + clear + length));
    }
    for (const double y : {rect.top(), rect.bottom()}) {
        painter.drawLine(QPointF(rect.left() - clear, y), QPointF(rect.left() - clear - length, y));
        painter.drawLine(QPointF(rect.right() + clear, y), QPointF(rect.right() + clear + length, y));
    }
}

} // namespace lubberline::ui
