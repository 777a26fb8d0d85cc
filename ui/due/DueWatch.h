#pragma once

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>

#include "ui/due/DueWork.h"
#include "ui/kit/Worker.h"

namespace lubberline::ui {

/// What is due, found anew on a worker whenever something changed that may change it, and when a new day has begun (windows
/// stay open over night, laptops sleep); the newest wish wins. What the fleet's history expects takes longer: it follows when
/// nothing has changed for a while, and until then what was expected before stands.
class DueWatch : public QObject {
    Q_OBJECT

public:
    /// @param today UTC.
    DueWatch(db::Stores& stores, std::function<Date()> today, QObject* parent = nullptr);

    void start();
    void lookAtDay(); ///< starts when it is another day than it was found for
    [[nodiscard]] const std::shared_ptr<const DueNews>& news() const { return m_news; } ///< null before the first

signals:
    void ready(); ///< twice: with what was expected before, then with what is expected now (DueNews::forecastsAreNew)
    void failed(const QString& message);

private:
    void forecast();
    void take(Result<DueNews> news);

    db::Stores& m_stores;
    std::function<Date()> m_today;
    std::shared_ptr<const DueNews> m_news;
    QTimer m_dayTimer, m_quietTimer;
    Date m_day; ///< that it was found for; empty: not yet
    Worker<DueNews> m_worker;
};

} // namespace lubberline::ui
