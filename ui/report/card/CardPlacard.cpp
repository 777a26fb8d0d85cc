#include "ui/report/card/CardPlacard.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "ui/report/page/DataHash.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/Page.h"
#include "ui/report/page/QrCode.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

namespace {

constexpr double kPadding = mm(2);
constexpr double kRowHeight = mm(6.6);
constexpr double kHeadHeight = mm(4);
constexpr double kTopHeight = mm(19); ///< whose card it is and what it holds for
constexpr double kFootHeight = mm(19.4);
constexpr double kQr = mm(11.4); ///< beside the first lines of the foot
constexpr double kBannerHeight = mm(4.2);
constexpr double kDigits_pt = 15;

std::size_t rowsInHalf(const CardInput& input) { return (input.columns.front().card.rows.size() + 1) / 2; }

double bannerHeight(const CardInput& input) { return bannerFor(input.record).isEmpty() ? 0 : kBannerHeight; }

QString compassLine(const CompassSystem& compass)
{
    return joined({printable(compass.name).toUpper(), labelled(Words::tr("S/N"), printable(compass.serialNumber))});
}

/// The state in which the card holds; the radio's is left to the columns where there are two.
QString configurationLine(const CardInput& input)
{
    Configuration configuration = input.record.swing.configuration;
    if (input.columns.size() > 1)
        configuration.radio = RadioState::NotStated;
    const QString words = configurationWords(configuration);
    const QString state = words.isEmpty() ? Words::tr("CONFIGURATION NOT STATED") : words.toUpper();
    return joined({state, labelled(Words::tr("OVER 10° WITH"), input.loadsToName.join(QStringLiteral(", ")).toUpper())});
}

/// Who signed last, or a line to sign on.
QString signedLine(const Swing& swing)
{
    if (swing.signatures.empty())
        return Words::tr("Signed");
    const auto& last = swing.signatures.back();
    return Words::tr("Signed %1").arg(joined({printable(last.name), printable(last.licence), printable(last.timeUtc).left(10)}));
}

QString residualLine(const CardInput& input)
{
    const CardRow* largest = nullptr;
    const CardColumn* in = nullptr;
    for (const CardColumn& column : input.columns) {
        for (const CardRow& row : column.card.rows) {
            if (!largest || std::abs(row.residual.degrees()) > std::abs(largest->residual.degrees())) {
                largest = &row;
                in = &column;
            }
        }
    }
    const QString line = Words::tr("Largest residual %1° on %2")
                             .arg(signedFigure(largest->residual.degrees(), 1), threeDigits(qRound(largest->magnetic.degrees())));
    return input.columns.size() > 1 ? QStringLiteral("%1, %2").arg(line, in->heading) : line;
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
    const SwingRecord& record = input.record;
    const QString date = printable(record.swing.date);
    const QFont dateFont = documentFont(family, 7);
    const double dateWidth = QFontMetricsF(dateFont).horizontalAdvance(date) + mm(2);
    const QString registration = printable(record.aircraft.registration);
    painter.setPen(Ink::text());
    paintLine(painter, dateFont, {room.right(), room.top() + mm(4.2)}, Qt::AlignRight, date);
    SmallLines lines(painter, room.adjusted(0, 0, -dateWidth, 0), family);
    lines.add(registration, 11, mm(4.2), true);
    SmallLines below(painter, QRectF(room.left(), lines.y(), room.width(), room.height()), family);
    below.add(compassLine(record.compass), 6.5, mm(3.4));
    below.add(Words::tr("Swung at %1").arg(record.site ? printable(record.site->name) : Words::tr("a site not stated")), 6, mm(3));
    const double top = below.y() + mm(1);
    paintConfiguration(painter, QRectF(QPointF(room.left(), top), QPointF(room.right(), room.top() + kTopHeight - mm(1.4))),
        configurationLine(input), family);
}

/// One half of the table: FOR, then each STEER.
struct Half {
    QRectF rect;
    std::size_t first = 0, count = 0;
};

/// One size for all headings: the one at which the longest fits.
QFont headingFont(const CardInput& input, const QString& family, double width)
{
    QString longest;
    for (const CardColumn& column : input.columns)
        if (column.heading.size() > longest.size())
            longest = column.heading;
    return fitted(family, 7, true, width, longest);
}

void paintHalfHead(QPainter& painter, const Half& half, const CardInput& input, const QString& family)
{
    const double column = half.rect.width() / static_cast<double>(input.columns.size() + 1);
    const double baseline = half.rect.top() + kHeadHeight - mm(1.1);
    const QFont headings = headingFont(input, family, column - mm(0.8));
    paintLine(painter, documentFont(family, 7, true), {half.rect.left() + column / 2, baseline}, Qt::AlignHCenter, Words::tr("FOR"));
    for (std::size_t i = 0; i < input.columns.size(); ++i) {
        paintLine(painter, headings, {half.rect.left() + column * (static_cast<double>(i) + 1.5), baseline}, Qt::AlignHCenter,
            input.columns[i].heading);
    }
}

void paintHalf(QPainter& painter, const Half& half, const CardInput& input, const QString& family)
{
    const double column = half.rect.width() / static_cast<double>(input.columns.size() + 1);
    const QFont digits = documentFont(family, kDigits_pt, true), lighter = documentFont(family, kDigits_pt);
    const double capHeight = QFontMetricsF(digits).capHeight();
    painter.fillRect(
        QRectF(half.rect.left(), half.rect.top(), column, kHeadHeight + kRowHeight * static_cast<double>(half.count)), Ink::shaded());
    painter.setPen(Ink::text());
    paintHalfHead(painter, half, input, family);
    for (std::size_t i = 0; i < half.count; ++i) {
        const double top = half.rect.top() + kHeadHeight + kRowHeight * static_cast<double>(i);
        const double baseline = top + (kRowHeight + capHeight) / 2;
        painter.setPen(QPen(Ink::strong(), mm(0.15)));
        painter.drawLine(QPointF(half.rect.left(), top), QPointF(half.rect.right(), top));
        painter.setPen(Ink::text());
        const CardRow& row = input.columns.front().card.rows[half.first + i];
        paintLine(
            painter, lighter, {half.rect.left() + column / 2, baseline}, Qt::AlignHCenter, threeDigits(qRound(row.magnetic.degrees())));
        for (std::size_t c = 0; c < input.columns.size(); ++c) {
            paintLine(painter, digits, {half.rect.left() + column * (static_cast<double>(c) + 1.5), baseline}, Qt::AlignHCenter,
                threeDigits(input.columns[c].card.rows[half.first + i].steerRounded_deg()));
        }
    }
}

void paintFigures(QPainter& painter, const QRectF& rect, const CardInput& input, const QString& family)
{
    const std::size_t all = input.columns.front().card.rows.size(), left = rowsInHalf(input);
    const double middle = rect.center().x();
    paintHalf(painter, {QRectF(rect.topLeft(), QPointF(middle, rect.bottom())), 0, left}, input, family);
    paintHalf(painter, {QRectF(QPointF(middle, rect.top()), rect.bottomRight()), left, all - left}, input, family);
    painter.setPen(QPen(Ink::strong(), mm(0.4)));
    painter.drawLine(rect.topLeft(), rect.topRight());
    painter.drawLine(rect.bottomLeft(), rect.bottomRight());
    painter.drawLine(QPointF(middle, rect.top()), QPointF(middle, rect.bottom()));
}

void paintFoot(QPainter& painter, const QRectF& room, const CardInput& input, const QString& family)
{
    painter.setPen(Ink::text());
    const QString record = printable(input.record.swing.record).left(8), data = dataHash(input.record).left(8);
    const auto code = qrOf(printable(input.record.swing.record)); // none where the swing has no record yet
    if (code)
        paintQr(painter, QRectF(room.right() - kQr, room.top() + mm(0.3), kQr, kQr), *code);
    const QRectF beside = room.adjusted(0, 0, code ? -kQr - mm(1) : 0, 0);
    SmallLines lines(painter, beside, family);
    lines.add(residualLine(input), 6, mm(3.2));
    const QString revision = input.record.swing.revision > 1 ? Words::tr(" rev. %1").arg(input.record.swing.revision) : QString();
    lines.add(Words::tr("Record %1%2 · data %3").arg(record.isEmpty() ? dash() : record, revision, data), 6, mm(2.9));
    lines.add(signedLine(input.record.swing), 6,
        input.reprintOf.isEmpty() ? mm(5) : mm(2.7)); // room for a hand, where one is to sign
    painter.setPen(QPen(Ink::strong(), mm(0.15)));
    if (input.record.swing.signatures.empty())
        painter.drawLine(QPointF(room.left() + mm(9), lines.y()), QPointF(beside.right(), lines.y()));
    painter.setPen(Ink::text());
    if (!input.reprintOf.isEmpty())
        lines.add(Words::tr("Reprint of %1").arg(input.reprintOf), 6, mm(2.5), true);
    SmallLines below(painter, QRectF(room.left(), room.top() + kQr, room.width(), room.height()), family);
    below.add(Words::tr("Steer this by compass to make good FOR (magnetic)."), 5.5, mm(3.1));
    below.add(Words::tr("Deviation = magnetic − compass, E +"), 5.5, mm(2.5));
}

} // namespace

QString threeDigits(int heading_deg) { return QStringLiteral("%1").arg(heading_deg % 360, 3, 10, QChar('0')); }

QSizeF placardSize(const CardInput& input)
{
    const double width = input.columns.size() > 1 ? mm(84) : mm(60);
    return {width, bannerHeight(input) + kTopHeight + kHeadHeight + kRowHeight * static_cast<double>(rowsInHalf(input)) + kFootHeight};
}

void paintPlacard(QPainter& painter, const QRectF& rect, const CardInput& input, const QString& family)
{
    const QRectF room = rect.adjusted(kPadding, 0, -kPadding, 0);
    const QString banner = bannerFor(input.record);
    double y = rect.top();
    if (!banner.isEmpty()) {
        painter.setPen(Ink::alarm());
        y += kBannerHeight;
        paintLine(painter, fitted(family, 9, true, room.width(), banner), {room.center().x(), y - mm(0.4)}, Qt::AlignHCenter, banner);
    }
    paintTop(painter, QRectF(room.left(), y + mm(0.8), room.width(), kTopHeight), input, family);
    y += kTopHeight;
    const double tableHeight = kHeadHeight + kRowHeight * static_cast<double>(rowsInHalf(input));
    paintFigures(painter, QRectF(room.left(), y, room.width(), tableHeight), input, family);
    paintFoot(painter, QRectF(room.left(), y + tableHeight, room.width(), kFootHeight), input, family);
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
