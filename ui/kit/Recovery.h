#pragma once
/// What could not be stored (a full or vanished drive) is kept in a file elsewhere, a line each, and offered at the next start.

#include <QString>
#include <QStringList>

#include <vector>

#include "core/format/exchange/LostJson.h"
#include "db/stores/Stores.h"

namespace lubberline::ui {

class Recovery {
public:
    /// @param paths files in the order of preference; the first that takes a line keeps it. None: nothing is kept.
    explicit Recovery(QStringList paths = {}) : m_paths(std::move(paths)) {}

    /// Errors: Io, when no place takes it.
    Result<void> keep(const LostEntry& entry) const;
    /// Those that belong to a database, oldest first; lines that do not read are left where they are.
    [[nodiscard]] std::vector<LostEntry> entriesFor(const QString& database) const;
    /// Stores them where they belong. A step that is there already, or a reading that equals its row, is done. What could not
    /// be put in stays; what was is taken off the files. @return how many were put in, and why others were not.
    struct Restored {
        int done = 0;
        QStringList failures;
    };
    Restored restore(db::Stores& stores) const;
    void forget(const QString& database) const;

private:
    void rewrite(const std::vector<LostEntry>& gone) const;
    QStringList m_paths;
};

} // namespace lubberline::ui
