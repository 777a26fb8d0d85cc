#include "ui/swing/KeyChecks.h"

#include <algorithm>

namespace lubberline::ui {

KeyChecks::KeyChecks(db::Stores& stores, QObject* parent)
    : QObject(parent)
    , m_stores(stores)
    , m_worker([this](const Result<std::vector<KeyVerdict>>& verdicts) {
        if (!m_record)
            return; // cancelled: another record is looked at
        // What could not be asked is not known, and says why.
        const std::vector<KeyVerdict> none(
            m_record->swing.signatures.size(), {KeyState::NotChecked, verdicts ? Message() : verdicts.error().message});
        m_verdicts = verdicts ? *verdicts : none;
        emit checked();
    })
{
}

void KeyChecks::check(const SwingRecord& record)
{
    if (m_record == record)
        return;
    m_record.reset();
    m_verdicts.clear();
    m_worker.cancel();
    const auto& signatures = record.swing.signatures;
    if (std::none_of(signatures.begin(), signatures.end(), [](const Signature& one) { return one.hasKey(); }))
        return;
    m_record = record;
    m_worker.start([&stores = m_stores, id = record.swing.id](const Progress& progress) -> Result<std::vector<KeyVerdict>> {
        auto own = stores.openForWorker();
        return own ? (*own)->signing.verdicts(id, progress) : own.error();
    });
}

} // namespace lubberline::ui
