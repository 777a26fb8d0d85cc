#include "ui/kit/Worker.h"

#include <QCoreApplication>

#include "ui/plots/base/ChartOnPaper.h"

namespace lubberline::ui {

WorkerThread::WorkerThread(std::function<void(int percent)> progressed) : m_progressed(std::move(progressed))
{
    m_pool.setMaxThreadCount(1);
}

WorkerThread::~WorkerThread()
{
    cancel();
    m_pool.clear();
    wait();
}

void WorkerThread::cancel()
{
    if (m_run)
        m_run->cancelled = true;
}

/// A document that is painted there may wait for a chart that is drawn here.
void WorkerThread::wait()
{
    constexpr int kBetween_ms = 5;
    while (!m_pool.waitForDone(kBetween_ms))
        drawWanted();
}

void WorkerThread::finish()
{
    wait();
    QCoreApplication::sendPostedEvents(&m_home, QEvent::MetaCall);
}

void WorkerThread::begin(std::function<Delivery(const Progress&)> job)
{
    cancel();
    m_pool.clear(); // what was replaced before it began
    const auto run = std::make_shared<Run>();
    m_run = run;
    m_pool.start([this, run, job = std::move(job)] {
        const Delivery delivery = job([this, &run](double fraction) { return report(run, fraction); });
        QMetaObject::invokeMethod(
            &m_home,
            [this, run, delivery] {
                if (run != m_run)
                    return;
                m_run.reset();
                delivery(); // may delete this
            },
            Qt::QueuedConnection);
    });
}

bool WorkerThread::report(const std::shared_ptr<Run>& run, double fraction)
{
    const int percent = static_cast<int>(fraction * 100.0);
    if (m_progressed && run->percent.exchange(percent) != percent)
        QMetaObject::invokeMethod(
            &m_home,
            [this, run, percent] {
                if (run == m_run)
                    m_progressed(percent);
            },
            Qt::QueuedConnection);
    return !run->cancelled;
}

} // namespace lubberline::ui
