#pragma once
/// What could not be stored (a full or vanished drive, a long import elsewhere) is kept in a file elsewhere, a line each, and offered at
/// the next start. It never replaces what has been stored since.

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

    /// Of a reading or step of this database. @return it with the moment and the database's identity. Errors: Io, when no place takes it.
    Result<LostEntry> keep(db::Stores& stores, LostEntry entry) const;
    /// Those that belong to the database, however it is named, oldest first, and are not stored by now; lines that do not read are
    /// left where they are.
    [[nodiscard]] std::vector<LostEntry> entriesFor(db::Stores& stores) const;
    /// Files that are not used, and why: each in a sentence.
    [[nodiscard]] QStringList refusals() const;

    struct Restored {
        int done = 0;
        bool locked = false;  ///< another program is writing: nothing was tried any further
        QStringList failures; ///< why others were not
        QStringList clashes;  ///< what was kept and what has been stored since, side by side
    };
    /// Stores them where they belong. A step that is there already, or a reading that says so already, is done. What could not be put in
    /// stays, and so does what something else has been stored for since; what was put in is taken off the files.
    Restored restore(db::Stores& stores, const std::vector<LostEntry>& entries) const;
    /// The lines of other databases, and those that do not read, stay.
    void forget(const std::vector<LostEntry>& entries) const;

private:
    QStringList m_paths;
};

} // namespace lubberline::ui
