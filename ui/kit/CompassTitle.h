#pragma once
/// A compass as titles name it. A page from which something is stored with a compass says so in its title.

#include <QString>

#include "core/base/Result.h"
#include "core/record/Id.h"
#include "db/stores/Stores.h"
#include "ui/kit/Destination.h"

namespace lubberline::ui {

/// "3713 · standby compass"; of the demonstration marked so. Errors: those of the store.
Result<QString> compassTitle(db::Stores& stores, CompassId compass);

/// The title of a page that may be of a compass: with it behind, or alone where it is of none.
Result<QString> titleWith(db::Stores& stores, CompassId compass, const QString& title);

/// The compass that a record is; not valid: it is another kind of record.
[[nodiscard]] CompassId compassIn(const FleetItem& record);

} // namespace lubberline::ui
