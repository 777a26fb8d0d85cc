#pragma once
/// Who wants to know what has changed in a database: pages, the tree, the list of what is due. A store notes what it changed inside
/// its transaction; it is told when the outermost transaction is committed, once for each record, and not at all when it is not.

#include <QObject>

#include <variant>
#include <vector>

#include "core/record/Id.h"

namespace lubberline::db {

namespace change {

struct Fleet { ///< what the tree shows: types, aircraft, compasses, swings, their states
    friend bool operator==(Fleet, Fleet) = default;
};
struct OfAircraft { ///< its particulars, compasses or events
    AircraftId id;
    friend bool operator==(OfAircraft, OfAircraft) = default;
};
struct OfSwing { ///< its particulars or readings
    SwingId id;
    ReadingId only = {}; ///< valid: nothing of it but the figures of this reading
    friend bool operator==(OfSwing, OfSwing) = default;
};
struct Sensors { ///< sensor models or coil benches of a compass
    CompassId of;
    friend bool operator==(Sensors, Sensors) = default;
};
struct Sites { ///< compass bases, instruments or limits profiles
    friend bool operator==(Sites, Sites) = default;
};
struct Due { ///< rules, events, waivers or signatures: what is due may be other
    friend bool operator==(Due, Due) = default;
};
struct Electrical { ///< electrical swings of a compass
    CompassId of;
    friend bool operator==(Electrical, Electrical) = default;
};

} // namespace change

using Change
    = std::variant<change::Fleet, change::OfAircraft, change::OfSwing, change::Sensors, change::Sites, change::Due, change::Electrical>;

class Changes : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// For stores only, inside their transaction.
    void note(const Change& change);
    /// For Transaction only: the outermost has ended.
    void ended(bool committed);
    /// Another connection has stored much (an import on a worker).
    void announceFleet() { emit fleetChanged(); }
    /// Another window or a command has stored something: nobody knows what.
    void announceAll()
    {
        emit fleetChanged();
        emit sitesChanged();
        emit dueChanged();
    }

signals:
    void fleetChanged();
    void aircraftChanged(lubberline::AircraftId id);
    void swingChanged(lubberline::SwingId id, lubberline::ReadingId only); ///< as in change::OfSwing
    void sensorsChanged(lubberline::CompassId id);
    void sitesChanged();
    void dueChanged();
    void electricalChanged(lubberline::CompassId id);

private:
    void tell(const Change& change);
    std::vector<Change> m_noted; ///< in order, each record once
};

} // namespace lubberline::db
