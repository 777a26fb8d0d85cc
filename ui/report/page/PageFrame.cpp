#include "ui/report/page/PageFrame.h"

#include <QFontMetricsF>
#include <QPainter>

#include "ui/report/page/DataHash.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/Page.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

constexpr double kSide = mm(16);
constexpr double kTop = mm(11);
constexpr double kHeaderHeight = mm(9);
constexpr double kBannerHeight = mm(10);
constexpr double kFooterHeight = mm(13);
constexpr double kBottom = mm(9);
constexpr double kFooterLine = mm(3.2);

void paintHeader(QPainter& painter, const PageFrame& frame, const QString& family, QSizeF sheet)
{
    const double left = kSide, right = sheet.width() - kSide, baseline = kTop + mm(5);
    const QFont title = documentFont(family, 13, true);
    const double room = right - left - QFontMetricsF(title).horizontalAdvance(frame.title) - mm(8);
    painter.setPen(Ink::text());
    paintLine(painter, title, {left, baseline}, Qt::AlignLeft, frame.title);
    paintLine(painter, fitted(family, 10, true, room, frame.subject), {right, baseline}, Qt::AlignRight, frame.subject);
    painter.setPen(QPen(Ink::strong(), mm(0.4)));
    painter.drawLine(QPointF(left, kTop + mm(7)), QPointF(right, kTop + mm(7)));
}

void paintBanner(QPainter& painter, const QString& banner, const QString& family, QSizeF sheet)
{
    const QRectF band(kSide, kTop + kHeaderHeight - mm(0.5), sheet.width() - 2 * kSide, kBannerHeight - mm(2));
    painter.setPen(QPen(Ink::alarm(), mm(0.5)));
    painter.setBrush(Ink::alarmTint());
    painter.drawRect(band);
    painter.setPen(Ink::alarm());
    const QFont font = fitted(family, 17, true, band.width() - mm(6), banner);
    paintLine(painter, font, {band.center().x(), band.center().y() + QFontMetricsF(font).capHeight() / 2}, Qt::AlignHCenter, banner);
}

void paintFooter(QPainter& painter, const PageFrame& frame, const QString& family, QSizeF sheet, int page, int pages)
{
    const double left = kSide, right = sheet.width() - kSide;
    const double top = sheet.height() - kBottom - kFooterHeight + mm(2);
    const QFont font = documentFont(family, 6.5);
    painter.setPen(QPen(Ink::strong(), mm(0.2)));
    painter.drawLine(QPointF(left, top), QPointF(right, top));
    painter.setPen(Ink::text());
    double y = top + mm(3.4);
    paintLine(painter, font, {left, y}, Qt::AlignLeft, frame.convention);
    paintLine(painter, documentFont(family, 8, true), {right, y}, Qt::AlignRight, Words::tr("page %1 of %2").arg(page + 1).arg(pages));
    y += kFooterLine;
    if (!frame.recordId.isEmpty()) // of what is no record of a database there is none
        paintLine(painter, font, {left, y}, Qt::AlignLeft, Words::tr("Record %1").arg(frame.recordId));
    paintLine(painter, font, {right, y}, Qt::AlignRight, frame.made);
    y += kFooterLine;
    paintLine(painter, font, {left, y}, Qt::AlignLeft, Words::tr("Data SHA-256 %1").arg(frame.hash));
    if (page + 1 == pages)
        paintLine(painter, documentFont(family, 5.5), {left, y + kFooterLine}, Qt::AlignLeft, frame.credit);
}

} // namespace

QString madeWords(const QString& madeAtUtc)
{
    const QString version = QCoreApplication::applicationVersion();
    const QString program = version.isEmpty() ? QStringLiteral("Lubberline") : QStringLiteral("Lubberline %1").arg(version);
    return madeAtUtc.isEmpty() ? Words::tr("made by %1").arg(program) : Words::tr("made %1 by %2").arg(madeAtUtc, program);
}

PageFrame frameFor(const SwingRecord& record, const QString& title, const QString& madeAtUtc)
{
    PageFrame frame;
    frame.title = title;
    frame.subject = joined({printable(record.aircraft.registration), printable(record.compass.name), printable(record.swing.date)});
    frame.banner = bannerFor(record);
    frame.convention = Words::tr("Deviation = magnetic heading − compass heading; easterly is positive.");
    frame.recordId = record.swing.record.empty() ? dash() : printable(record.swing.record);
    frame.hash = dataHash(record);
    frame.made = madeWords(printable(madeAtUtc.toStdString()));
    return frame;
}

QRectF bodyOf(const PageFrame& frame, QSizeF sheet)
{
    const double top = kTop + kHeaderHeight + (frame.banner.isEmpty() ? 0 : kBannerHeight);
    return {QPointF(kSide, top), QPointF(sheet.width() - kSide, sheet.height() - kBottom - kFooterHeight)};
}

void paintFrame(QPainter& painter, const PageFrame& frame, const QString& family, QSizeF sheet, int page, int pages)
{
    paintHeader(painter, frame, family, sheet);
    if (!frame.banner.isEmpty())
        paintBanner(painter, frame.banner, family, sheet);
    paintFooter(painter, frame, family, sheet, page, pages);
}

} // namespace lubberline::ui
