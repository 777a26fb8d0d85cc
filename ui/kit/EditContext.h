#pragma once
/// What undoable edits share: the storage that they call, whom they tell of a failure, and which record is which after one was
/// removed and put back under a new id.

#include <functional>
#include <unordered_map>

#include "db/stores/Stores.h"

namespace lubberline::ui {

/// A record that is restored gets a new id from stores; earlier commands of the stack still hold the old one.
template <class Key>
class Renumbered {
public:
    void replace(Key before, Key after)
    {
        m_after.erase(after); // a database may give an id a second time: it is alive again
        if (before != after)
            m_after[before] = after;
    }
    [[nodiscard]] Key current(Key id) const
    {
        for (auto found = m_after.find(id); found != m_after.end(); found = m_after.find(id))
            id = found->second;
        return id;
    }

private:
    std::unordered_map<Key, Key> m_after;
};

struct EditContext {
    db::Stores& stores;
    std::function<void(const Error&)> failed;
    Renumbered<ReadingId> readings = {};
    Renumbered<SwingId> swings = {};
};

} // namespace lubberline::ui
