#include "ui/swing/Gathering.h"

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kPatience_ms = 300;

} // namespace

Gathering::Gathering(db::Stores& stores, QWidget* parent)
    : QPushButton(tr("Putting the document together: cancel"), parent)
    , m_stores(stores)
    , m_worker([this](Result<Then> gathered) { deliver(std::move(gathered)); })
{
    setObjectName(QStringLiteral("cancelDocument"));
    hide();
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience_ms);
    connect(&m_patience, &QTimer::timeout, this, &QWidget::show);
    connect(this, &QPushButton::clicked, this, [this] { m_worker.cancel(); });
}

void Gathering::begin(std::function<Then(db::Stores&, const Progress&)> gather)
{
    m_patience.start();
    m_worker.start([&stores = m_stores, gather = std::move(gather)](const Progress& progress) -> Result<Then> {
        auto own = stores.openForWorker();
        if (!own)
            return own.error();
        auto then = gather(**own, progress);
        if (!progress(1))
            return Error{ErrorCode::Cancelled, {}};
        return then;
    });
}

void Gathering::deliver(Result<Then> gathered)
{
    m_patience.stop();
    hide();
    if (gathered)
        (*gathered)();
    else if (gathered.error().code == ErrorCode::Cancelled)
        emit cancelled();
    else
        emit failed(messageOf(gathered.error()));
}

} // namespace lubberline::ui
