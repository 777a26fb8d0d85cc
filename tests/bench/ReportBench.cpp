// A two-page report PDF against the same text laid out without plots plus the plots drawn alone (limit 2), and its size (300
// KiB).

#include <QApplication>
#include <QBuffer>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTextDocument>

#include <cstdlib>
#include <memory>

#include "core/swing/Observations.h"
#include "tests/bench/BenchFleet.h"
#include "tests/bench/Ratio.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/plots/swing/PlotRendering.h"
#include "ui/report/swing/Report.h"

namespace {

using namespace lubberline;

SwingRecord record()
{
    std::mt19937 random(7);
    SwingRecord record;
    record.swing = bench::noisySwing({}, random, 8);
    record.swing.record = newRecordId();
    record.aircraft.registration = "SP-BEN";
    record.type.name = "Bench";
    record.compass.name = "standby";
    return record;
}

/// The plain text of the report, set by Qt's own text engine, as a page of a PDF.
void layOutText(const QString& html)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    QTextDocument document;
    document.setHtml(html);
    document.print(&writer);
}

void drawPlots(const ui::SwingPicture& picture)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(300);
    QPainter painter(&writer);
    ui::renderPolar(painter, QRectF(0, 0, 1100, 1100), picture);
    ui::renderCurve(painter, QRectF(0, 1200, 2200, 1000), picture);
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    const QTemporaryDir folder;
    ui::ReportInput input;
    input.record = record();
    input.analysis = *analyse(observationsOf(input.record.swing));
    input.madeAtUtc = "2026-11-23T00:00:00Z";
    const QString pdf = folder.filePath("report.pdf"), html = folder.filePath("report.html");
    if (!ui::writeReport(input, html))
        return 1;
    QFile file(html);
    if (!file.open(QIODevice::ReadOnly))
        return 1;
    QString text = QString::fromUtf8(file.readAll());
    text.remove(QRegularExpression("<svg.*?</svg>", QRegularExpression::DotMatchesEverythingOption));
    const auto picture
        = ui::pictureOf(input.record, std::make_shared<Analysis>(input.analysis), {}, nullptr, {}, AngleStyle::DecimalDegrees);

    const auto timing = bench::compare(
        [&] {
            if (!ui::writeReport(input, pdf))
                std::abort();
        },
        [&] {
            layOutText(text);
            drawPlots(picture);
        },
        15);
    const double kib = static_cast<double>(QFileInfo(pdf).size()) / 1024.0;
    bench::row("size of a report (KiB)", kib, 300, "300 KiB", 1.0);
    return bench::report("report with plots", timing, "text and two plots apart", 2.0) && kib < 300 ? 0 : 1;
}
