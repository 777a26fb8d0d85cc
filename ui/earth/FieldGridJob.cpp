#include "ui/earth/FieldGridJob.h"

#include <QtConcurrent/QtConcurrentRun>

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr double kStep_deg = 2.0;

} // namespace

FieldGridJob::FieldGridJob(QObject* parent) : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &FieldGridJob::finish);
}

FieldGridJob::~FieldGridJob()
{
    m_watcher.disconnect(this);
    giveUp();
}

void FieldGridJob::giveUp()
{
    if (m_cancelled)
        m_cancelled->store(true);
}

void FieldGridJob::start(const FieldModel& model, double year, FieldElement element)
{
    giveUp();
    auto cancelled = std::make_shared<std::atomic<bool>>(false);
    m_cancelled = cancelled;
    m_watcher.setFuture(QtConcurrent::run([model, year, element, cancelled]() -> Answer {
        return std::make_shared<const Result<FieldGrid>>(
            fieldGrid(model, year, element, kStep_deg, [&cancelled](double) { return !cancelled->load(); }));
    }));
}

void FieldGridJob::finish()
{
    const Answer answer = m_watcher.result();
    if (*answer)
        emit ready(std::shared_ptr<const FieldGrid>(answer, &answer->value()));
    else if (answer->error().code != ErrorCode::Cancelled)
        emit failed(messageOf(answer->error()));
}

} // namespace lubberline::ui
