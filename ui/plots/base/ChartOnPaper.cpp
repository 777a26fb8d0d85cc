#include "ui/plots/base/ChartOnPaper.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPicture>
#include <QSemaphore>
#include <QThread>

#include <deque>
#include <memory>
#include <mutex>
#include <utility>

namespace lubberline::ui {

namespace {

/// Has the resolution of the paper: charts set their letters by it.
class PaperPicture : public QPicture {
public:
    explicit PaperPicture(int dotsPerInch) : m_dotsPerInch(dotsPerInch) {}

protected:
    int metric(PaintDeviceMetric which) const override
    {
        switch (which) {
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY: return m_dotsPerInch;
        default: return QPicture::metric(which);
        }
    }

private:
    int m_dotsPerInch;
};

struct Wanted {
    std::function<void()> draw;
    QSemaphore drawn;
};

std::mutex g_lock; // of the queue beneath, which workers fill and the window's thread empties
std::deque<std::shared_ptr<Wanted>> g_queue;

void haveDrawn(std::function<void()> draw)
{
    const auto wanted = std::make_shared<Wanted>();
    wanted->draw = std::move(draw);
    {
        const std::scoped_lock hold(g_lock);
        g_queue.push_back(wanted);
    }
    QMetaObject::invokeMethod(QCoreApplication::instance(), drawWanted, Qt::QueuedConnection);
    wanted->drawn.acquire();
}

} // namespace

void drawWanted()
{
    for (;;) {
        std::shared_ptr<Wanted> next;
        {
            const std::scoped_lock hold(g_lock);
            if (g_queue.empty())
                return;
            next = std::move(g_queue.front());
            g_queue.pop_front();
        }
        next->draw();
        next->drawn.release();
    }
}

void drawOnPaper(QPainter& painter, const QRectF& target, const std::function<void(QPainter&, const QRectF&)>& draw)
{
    if (QThread::currentThread() == QCoreApplication::instance()->thread()) {
        draw(painter, target);
        return;
    }
    const QRectF onDevice = painter.combinedTransform().mapRect(target);
    PaperPicture picture(painter.device()->logicalDpiX());
    haveDrawn([&] {
        QPainter recorder(&picture);
        recorder.setRenderHints(painter.renderHints());
        recorder.setFont(painter.font());
        draw(recorder, onDevice);
    });
    painter.save();
    painter.resetTransform();
    // A picture is enlarged by the resolution of what it is played on; this one has been drawn for it.
    const double enlarged = static_cast<double>(painter.device()->logicalDpiX()) / QPicture().logicalDpiX();
    painter.scale(1 / enlarged, 1 / enlarged);
    painter.drawPicture(QPointF(), picture);
    painter.restore();
}

} // namespace lubberline::ui
