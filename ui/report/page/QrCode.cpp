#include "ui/report/page/QrCode.h"

#include <QPainter>

#include <memory>

#include <qrencode.h>

#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kQuiet = 4; // modules, ISO/IEC 18004

} // namespace

Result<QrMatrix> qrOf(const QString& text)
{
    const std::unique_ptr<QRcode, void (*)(QRcode*)> code(QRcode_encodeString8bit(text.toUtf8().constData(), 0, QR_ECLEVEL_M), QRcode_free);
    if (!code)
        return Error{ErrorCode::InvalidInput,
            said(Words::tr("a QR code cannot hold '%1'; expected some text, up to about 2,000 characters").arg(text.left(40)))};
    QrMatrix matrix;
    matrix.width = code->width;
    for (int i = 0; i < code->width * code->width; ++i)
        matrix.dark.push_back(code->data[i] & 1); // the lowest bit is the colour
    return matrix;
}

void paintQr(QPainter& painter, const QRectF& rect, const QrMatrix& matrix)
{
    const double module = std::min(rect.width(), rect.height()) / (matrix.width + 2 * kQuiet);
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::black);
    for (int row = 0; row < matrix.width; ++row)
        for (int column = 0; column < matrix.width;) {
            const auto dark = [&](int at) { return at < matrix.width && matrix.dark[static_cast<std::size_t>(row * matrix.width + at)]; };
            int end = column;
            while (dark(end))
                ++end;
            if (end > column) // one bar for neighbours: no hairlines between them
                painter.drawRect(QRectF(rect.left() + (column + kQuiet) * module, rect.top() + (row + kQuiet) * module,
                    (end - column) * module, module * 1.02));
            column = end + 1;
        }
    painter.restore();
}

} // namespace lubberline::ui
