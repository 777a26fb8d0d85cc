#pragma once
/// What the keys of a swing's signatures are worth, asked of gpg on a worker: a tenth of a second for each, and a minute for one that hangs.

#include <QObject>

#include <optional>
#include <vector>

#include "db/stores/Stores.h"
#include "ui/kit/Worker.h"

namespace lubberline::ui {

class KeyChecks : public QObject {
    Q_OBJECT

public:
    explicit KeyChecks(db::Stores& stores, QObject* parent = nullptr);
    /// Asks again only where the record is another one, or has changed; where no signature has a key there is nothing to ask.
    void check(const SwingRecord& record);
    [[nodiscard]] const std::vector<KeyVerdict>& verdicts() const { return m_verdicts; } ///< none: not known yet

signals:
    void checked();

private:
    db::Stores& m_stores;
    std::optional<SwingRecord> m_record;
    std::vector<KeyVerdict> m_verdicts;
    Worker<std::vector<KeyVerdict>> m_worker;
};

} // namespace lubberline::ui
