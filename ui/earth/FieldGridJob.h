#pragma once

#include <QFutureWatcher>
#include <QObject>

#include <atomic>
#include <memory>
#include <optional>

#include "core/earth/FieldGrid.h"

namespace lubberline::ui {

/// Grids of the Earth's field computed on a worker thread: the newest wish wins, an older one is given up.
class FieldGridJob : public QObject {
    Q_OBJECT

public:
    explicit FieldGridJob(QObject* parent = nullptr);
    /// Gives up; does not wait, as the worker holds nothing of this object.
    ~FieldGridJob() override;

    void start(const FieldModel& model, double year, FieldElement element);
    [[nodiscard]] bool running() const { return m_watcher.isRunning(); }

signals:
    void ready(std::shared_ptr<const lubberline::FieldGrid> grid);
    void failed(const QString& message);

private:
    using Answer = std::shared_ptr<const Result<FieldGrid>>;
    void giveUp();
    void finish();

    QFutureWatcher<Answer> m_watcher;
    std::shared_ptr<std::atomic<bool>> m_cancelled; ///< of the newest work
};

} // namespace lubberline::ui
