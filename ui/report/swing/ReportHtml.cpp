#include "ui/report/swing/ReportHtml.h"

#include <QPainter>

#include "ui/plots/map/MapPlotRendering.h"
#include "ui/plots/swing/PlotRendering.h"
#include "ui/report/page/Html.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

template <class Picture>
QString plotSvg(void (*render)(QPainter&, const QRectF&, const Picture&), const Picture& picture, QSize size_px, const QString& prefix)
{
    return svgOf([&](QPainter& painter, const QRectF& rect) { render(painter, rect, picture); }, size_px, prefix);
}

QString plotsHtml(const SwingPicture& picture)
{
    const QString pair
        = element("div", element("h2", escaped(Words::tr("Deviation, polar"))) + plotSvg(renderPolar, picture, {480, 500}, "polar"))
        + element(
            "div", element("h2", escaped(Words::tr("Spectrum of deviation"))) + plotSvg(renderSpectrum, picture, {480, 500}, "spectrum"));
    const QString curve
        = element("h2", escaped(Words::tr("Deviation and residuals against heading"))) + plotSvg(renderCurve, picture, {980, 520}, "curve");
    return element("div", element("div", pair, "pair") + curve, "plots");
}

QString signaturesHtml(const std::vector<SignatureLine>& signatures)
{
    QString rows;
    for (const SignatureLine& signature : signatures) {
        rows += element("tr",
            element("td", escaped(signature.role)) + element("td", escaped(signature.name)) + element("td", escaped(signature.date))
                + element("td", escaped(signature.sign)));
    }
    const QString head = element("tr",
        element("th", {}, "words") + element("th", escaped(Words::tr("name")), "words") + element("th", escaped(Words::tr("date")), "words")
            + element("th", escaped(Words::tr("signature")), "words"));
    return element("h2", escaped(Words::tr("Signatures"))) + element("table", element("thead", head) + element("tbody", rows), "sign");
}

QString verdictClass(Verdict verdict)
{
    switch (verdict) {
    case Verdict::InLimits: return QStringLiteral("InLimits");
    case Verdict::OutOfLimits: return QStringLiteral("OutOfLimits");
    case Verdict::NotKnown: break;
    }
    return QStringLiteral("NotKnown");
}

QString fieldHtml(const FieldPage& page)
{
    QString html = element("h2", escaped(Words::tr("Earth's field and sensor model"))) + factsHtml(page.field);
    if (!page.combinations.rows.empty())
        html += tableHtml(page.combinations);
    html += listHtml(Words::tr("What it cannot tell"), page.unknown);
    if (!page.sensor.empty())
        html += element("h2", escaped(Words::tr("Sensor model of the compass"))) + factsHtml(page.sensor);
    for (const Table* table : {&page.parameters, &page.smith})
        if (!table->rows.empty())
            html += tableHtml(*table);
    if (page.map)
        html += element("h2", escaped(Words::tr("Deviation over heading and roll, modelled")))
            + element("div", plotSvg(renderMap, *page.map, {980, 520}, "map"), "plots");
    return html;
}

QString jobHtml(const std::vector<Table>& tables)
{
    QString html;
    for (const Table& table : tables)
        html += tableHtml(table);
    return html;
}

QString footerHtml(const ReportContent& content)
{
    QString lines;
    for (const QString& line : {content.frame.convention, Words::tr("Record %1").arg(content.frame.recordId),
             Words::tr("Data SHA-256 %1").arg(content.frame.hash), content.frame.made, content.frame.credit})
        lines += element("div", escaped(line));
    return element("footer", lines);
}

QString bodyHtml(const ReportContent& content)
{
    const QString banner = content.frame.banner.isEmpty() ? QString() : element("div", escaped(content.frame.banner), "banner");
    return element("h1", escaped(content.frame.title)) + element("div", escaped(content.frame.subject)) + banner
        + element("div", element("b", escaped(content.verdictWord)) + escaped(content.verdictSentence),
            "verdict " + verdictClass(content.verdict))
        + factsHtml(content.facts) + tableHtml(content.readings) + tableHtml(content.coefficients) + tableHtml(content.fits)
        + listHtml(Words::tr("What the readings cannot tell"), content.warnings) + plotsHtml(content.picture)
        + element("h2", escaped(Words::tr("Signs and methods"))) + factsHtml(content.method) + jobHtml(content.job)
        + (content.field ? fieldHtml(*content.field) : QString()) + signaturesHtml(content.signatures) + banner + footerHtml(content);
}

} // namespace

QByteArray reportHtml(const ReportContent& content)
{
    return htmlPage(content.frame.title + " · " + content.frame.subject, bodyHtml(content));
}

} // namespace lubberline::ui
