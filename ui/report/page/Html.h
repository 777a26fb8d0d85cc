#pragma once
/// Parts of a document as one self-contained XHTML file: the plots are inline SVG, nothing is fetched.

#include <QByteArray>
#include <QSize>
#include <QString>

#include <functional>
#include <vector>

#include "ui/report/page/Table.h"

class QPainter;
class QRectF;

namespace lubberline::ui {

[[nodiscard]] QString escaped(const QString& text); ///< angles in the style of the window, as everywhere in a document
[[nodiscard]] QString element(const QString& name, const QString& inner, const QString& cssClass = {});
[[nodiscard]] QString factsHtml(const std::vector<Fact>& facts);
[[nodiscard]] QString tableHtml(const Table& table);
/// Empty where there are no lines.
[[nodiscard]] QString listHtml(const QString& title, const QStringList& lines);
/// One plot as an element; names inside it get a prefix, because the plots share one document.
[[nodiscard]] QString svgOf(const std::function<void(QPainter&, const QRectF&)>& paint, QSize size_px, const QString& prefix);
[[nodiscard]] QByteArray htmlPage(const QString& title, const QString& body);

} // namespace lubberline::ui
