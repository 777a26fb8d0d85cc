#pragma once
/// Stores on a real SQLite file of their own, gone with the test; on a drive in memory where the machine has one. Faults are made at
/// the seam below the stores.

#include <QFileInfo>
#include <QTemporaryDir>
#include <QThread>

#include <algorithm>
#include <atomic>
#include <memory>

#include "core/base/Contract.h"
#include "db/schema/Schema.h"
#include "db/stores/Stores.h"
#include "db/transfer/Transfer.h"

namespace lubberline::test {

class TestFolder {
public:
    TestFolder() : m_folder((QFileInfo("/dev/shm").isWritable() ? QString("/dev/shm") : QDir::tempPath()) + "/lubberline-test-XXXXXX") {}
    [[nodiscard]] QString file(const QString& name) const { return m_folder.filePath(name); }

private:
    QTemporaryDir m_folder;
};

/// What a statement asks of tables, counted; and what it is told.
struct Watch {
    std::atomic<bool> refuseWrites{false}; ///< as a full drive does
    std::atomic<int> delay_ms{0};          ///< before each row of a swing is stored
    std::atomic<int> typesAsked{0}, aircraftAsked{0}, swingsAsked{0};
    [[nodiscard]] bool nothingAsked() const { return typesAsked + aircraftAsked + swingsAsked == 0; }
    void forget() { typesAsked = aircraftAsked = swingsAsked = 0; }

    std::optional<Error> operator()(const QString& sql)
    {
        const bool writes = sql.startsWith("INSERT") || sql.startsWith("UPDATE") || sql.startsWith("DELETE");
        if (writes && refuseWrites)
            return Error{ErrorCode::Full, Message::verbatim(std::string("the disk is full"))};
        if (delay_ms > 0 && sql.startsWith("INSERT INTO swing "))
            QThread::msleep(static_cast<unsigned long>(delay_ms));
        typesAsked += sql.contains("FROM aircraft_type t ORDER BY");
        aircraftAsked += sql.contains("FROM aircraft a WHERE a.type_id = ? ORDER BY");
        swingsAsked += sql.contains("FROM swing WHERE compass_id = ? ORDER BY date DESC");
        return {};
    }
};

class TestStores : private TestFolder, public db::Stores {
public:
    TestStores() : db::Stores(open(file("memory.lubberline"), db::OpenMode::ReadWriteCreate))
    {
        database().setFault([watch = m_watch](const QString& sql) { return (*watch)(sql); });
    }

    [[nodiscard]] Watch& watch() { return *m_watch; }
    void setClock(Clock clock) { database().setClock(std::move(clock)); }
    void makeReadOnly() { LUBBERLINE_EXPECT(database().onlyRead().ok(), "a connection stops writing"); }

    /// A new record, or the changed one of this id or record id, whatever it was before.
    Result<AircraftTypeId> save(const AircraftType& type) { return fleet.add(type); }
    Result<CompassId> save(const CompassSystem& compass) { return fleet.add(compass); }
    Result<AircraftId> save(const Aircraft& one) { return fleet.add(one); }
    Result<EventId> save(const Event& event) { return fleet.add(event); }
    Result<LimitsProfileId> save(const LimitsProfile& profile) { return sites.add(profile); }
    Result<RecordId> save(const DatumInstrument& instrument) { return sites.add(instrument); }
    Result<RecordId> save(const DueRule& rule) { return due.add(rule); }
    Result<void> save(const Waiver& waiver) { return due.add(waiver); }
    Result<SiteId> save(const Site& site)
    {
        if (!site.id.valid())
            return sites.add(site);
        const auto changed = sites.change(**sites.site(site.id), site);
        return changed ? Result<SiteId>(site.id) : changed.error();
    }
    Result<SensorModelId> save(const SensorRecord& sensor)
    {
        if (!sensor.id.valid())
            return sensors.add(sensor);
        const auto changed = sensors.change(*sensors.sensor(sensor.id), sensor);
        return changed ? Result<SensorModelId>(sensor.id) : changed.error();
    }

    /// A swing as it is to be from now on, whatever it was.
    Result<void> put(const Swing& swing) { return swings.replace(*swings.swing(swing.id), swing); }

    /// All that is stored, in the order in which it came in.
    [[nodiscard]] Fleet whole()
    {
        Fleet all = db::exportFleet(database(), {}, {}).value();
        const auto byId = [](const auto& a, const auto& b) { return a.id.value < b.id.value; };
        std::sort(all.types.begin(), all.types.end(), byId);
        std::sort(all.aircraft.begin(), all.aircraft.end(), byId);
        std::sort(all.compasses.begin(), all.compasses.end(), byId);
        std::sort(all.sensors.begin(), all.sensors.end(), byId);
        std::sort(all.events.begin(), all.events.end(), byId);
        std::sort(all.sites.begin(), all.sites.end(), byId);
        std::sort(all.swings.begin(), all.swings.end(), byId);
        return all;
    }
    /// The same file as another program has it open.
    [[nodiscard]] std::unique_ptr<db::Stores> another(db::OpenMode mode = db::OpenMode::ReadWriteCreate) const
    {
        return std::make_unique<db::Stores>(open(location(), mode));
    }
    [[nodiscard]] std::unique_ptr<db::Stores> readOnlyOnes() const { return another(db::OpenMode::ReadOnly); }

private:
    static db::Database open(const QString& path, db::OpenMode mode)
    {
        auto database = db::openDatabase(path, mode);
        LUBBERLINE_EXPECT(database.ok(), "a database for a test opens");
        return std::move(database.value());
    }
    std::shared_ptr<Watch> m_watch = std::make_shared<Watch>();
};

} // namespace lubberline::test
