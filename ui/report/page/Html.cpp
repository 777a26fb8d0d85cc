#include "ui/report/page/Html.h"

#include <QBuffer>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgGenerator>

#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr char kStyle[] = R"(
body { font: 14px/1.4 "DejaVu Sans", sans-serif; color: #111; background: #fff; max-width: 1000px; margin: 1.5em auto; padding: 0 1em; }
h1 { font-size: 1.5em; margin-bottom: 0; } h2 { font-size: 1.1em; margin: 1.4em 0 .4em; }
.banner { border: 3px solid #b00020; background: #fff2f2; color: #b00020; font-size: 1.8em; font-weight: bold; text-align: center; padding: .2em; margin: .5em 0; }
.verdict { border: 1px solid #333; padding: .5em 1em; margin: .8em 0; } .verdict b { font-size: 1.4em; margin-right: 1em; }
.InLimits { background: #ddf0e6; } .OutOfLimits { background: #fbddd3; } .NotKnown { background: #eee; }
dl { display: grid; grid-template-columns: 9em 1fr; margin: 0; } dt { font-weight: bold; } dd { margin: 0; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th { font-weight: normal; font-size: .85em; vertical-align: bottom; border-bottom: 2px solid #333; }
td { border-bottom: 1px solid #c8c8c8; } td, th { padding: .15em .5em; text-align: right; white-space: pre-line; }
td.words, th.words { text-align: left; } tr.faint { color: #777; } tr.marked { background: #fff0c8; font-weight: bold; }
.plots svg { width: 100%; height: auto; } .pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1em; }
.sign td { height: 2.4em; border-bottom: 1px solid #333; text-align: left; vertical-align: bottom; }
footer { font-size: .8em; border-top: 1px solid #333; margin-top: 1.5em; padding-top: .5em; overflow-wrap: anywhere; }
)";

} // namespace

QString escaped(const QString& text) { return inAngleStyle(text).toHtmlEscaped(); }

QString element(const QString& name, const QString& inner, const QString& cssClass)
{
    const QString open = cssClass.isEmpty() ? name : QStringLiteral("%1 class=\"%2\"").arg(name, cssClass);
    return QStringLiteral("<") + open + '>' + inner + QStringLiteral("</") + name + QStringLiteral(">\n");
}

QString factsHtml(const std::vector<Fact>& facts)
{
    QString inner;
    for (const Fact& fact : facts)
        inner += element("dt", escaped(fact.name)) + element("dd", escaped(fact.value));
    return element("dl", inner);
}

namespace {

QString cssFor(const TableColumn& column) { return column.align == TableColumn::Align::Left ? QStringLiteral("words") : QString(); }

QString cssFor(TableRow::Look look)
{
    switch (look) {
    case TableRow::Look::Plain: return {};
    case TableRow::Look::Faint: return QStringLiteral("faint");
    case TableRow::Look::Marked: return QStringLiteral("marked");
    }
    return {};
}

} // namespace

QString tableHtml(const Table& given)
{
    const Table table = inAngleStyle(given);
    QString head, rows;
    for (const TableColumn& column : table.columns) {
        QStringList lines{column.head, column.argument, column.unit};
        lines.removeAll(QString());
        head += element("th", escaped(lines.join('\n')), cssFor(column));
    }
    for (const TableRow& row : table.rows) {
        QString cells;
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            cells += element("td", escaped(row.cells.value(static_cast<qsizetype>(i))), cssFor(table.columns[i]));
        rows += element("tr", cells, cssFor(row.look));
    }
    return element("h2", escaped(table.title)) + element("table", element("thead", element("tr", head)) + element("tbody", rows));
}

QString listHtml(const QString& title, const QStringList& lines)
{
    QString items;
    for (const QString& line : lines)
        items += element("li", escaped(line));
    return lines.isEmpty() ? QString() : element("h2", escaped(title)) + element("ul", items);
}

QString svgOf(const std::function<void(QPainter&, const QRectF&)>& paint, QSize size_px, const QString& prefix)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(96);
    generator.setSize(size_px);
    generator.setViewBox(QRect(QPoint(), size_px));
    {
        QPainter painter(&generator);
        paint(painter, QRectF(QPointF(), size_px));
    }
    QString svg = QString::fromUtf8(buffer.data());
    svg.remove(0, svg.indexOf(QStringLiteral("<svg")));
    svg.replace(QRegularExpression(QStringLiteral("\\bid=\"")), QStringLiteral("id=\"%1-").arg(prefix));
    svg.replace(QStringLiteral("url(#"), QStringLiteral("url(#%1-").arg(prefix));
    svg.replace(QStringLiteral("href=\"#"), QStringLiteral("href=\"#%1-").arg(prefix));
    return svg;
}

QByteArray htmlPage(const QString& title, const QString& body)
{
    const QString head
        = QStringLiteral("<meta charset=\"utf-8\"/>\n") + element("title", escaped(title)) + element("style", QString::fromLatin1(kStyle));
    const QString html = QStringLiteral("<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n")
        + element("head", head) + element("body", body) + QStringLiteral("</html>\n");
    return html.toUtf8();
}

} // namespace lubberline::ui
