#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <functional>
#include <memory>

#include "ui/due/DueWork.h"

namespace lubberline::ui {

/// What is due, found anew on a worker whenever something changed that may change it, and when a new day has begun (windows
/// stay open over night, laptops sleep); the newest wish wins.
class DueJob : public QObject {
    Q_OBJECT

public:
    /// @param today ISO 8601, UTC.
    DueJob(db::Stores& stores, std::function<std::string()> today, QObject* parent = nullptr);
    ~DueJob() override; ///< waits: the worker holds a connection

    void start();
    void lookAtDay(); ///< starts when it is another day than it was found for
    [[nodiscard]] const std::shared_ptr<const DueNews>& news() const { return m_news; } ///< null before the first

signals:
    void ready();
    void failed(const QString& message);

private:
    using Answer = std::shared_ptr<Result<DueNews>>;
    void finish();

    db::Stores& m_stores;
    std::function<std::string()> m_today;
    QFutureWatcher<Answer> m_watcher;
    std::shared_ptr<std::atomic<bool>> m_cancelled;
    std::shared_ptr<const DueNews> m_news;
    QTimer m_dayTimer;
    std::string m_day;    ///< that it was found for; empty: not yet
    bool m_again = false; ///< something changed while it ran
};

} // namespace lubberline::ui
