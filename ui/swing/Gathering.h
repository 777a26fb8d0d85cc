#pragma once
/// What a document of a swing is made of is put together on a worker: the results of a log and the keys of signatures take their time. The
/// button that cancels it is seen while it works.

#include <QPushButton>
#include <QTimer>

#include <functional>

#include "db/stores/Stores.h"
#include "ui/kit/Worker.h"

namespace lubberline::ui {

class Gathering : public QPushButton {
    Q_OBJECT

public:
    explicit Gathering(db::Stores& stores, QWidget* parent = nullptr);

    /// @param gather on the worker, with stores of its own. @param use what it gave, on the window's thread, unless it was cancelled or
    ///   another document is wanted by then.
    template <class Input>
    void start(std::function<Result<Input>(db::Stores& stores, const Progress& progress)> gather, std::function<void(Result<Input>)> use)
    {
        begin([gather = std::move(gather), use = std::move(use)](db::Stores& stores, const Progress& progress) -> Then {
            auto input = std::make_shared<Result<Input>>(gather(stores, progress));
            return [input, use] { use(std::move(*input)); };
        });
    }
    /// Waits for it, and uses it before it returns.
    void finish() { m_worker.finish(); }

signals:
    void failed(const QString& message);
    void cancelled();

private:
    using Then = std::function<void()>;
    void begin(std::function<Then(db::Stores&, const Progress&)> gather);
    void deliver(Result<Then> gathered);

    db::Stores& m_stores;
    QTimer m_patience; ///< what is there at once shows no button
    Worker<Then> m_worker;
};

} // namespace lubberline::ui
