#pragma once
/// A database in memory with the stores that a swing goes through, from its first step to its signatures.

#include <gmock/gmock.h>

#include "db/engine/Statement.h"
#include "db/stores/DueStore.h"
#include "db/stores/ElectricalStore.h"
#include "db/stores/JobStore.h"
#include "db/stores/ResultStore.h"
#include "db/stores/SigningStore.h"
#include "db/stores/SiteStore.h"
#include "db/transfer/Maintenance.h"
#include "db/transfer/Transfer.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

inline Swing worksheetSwing(const Stored& stored)
{
    Swing swing = swingOf(stored);
    swing.readings = worksheetReadings();
    return swing;
}

inline SwingJob smallJob()
{
    SwingJob job;
    job.plan.kind = ProcedureKind::CheckOnly;
    job.checklist = {"tools"};
    job.datum.name = "B-16";
    job.events = {{"2026-11-23T09:00:00Z", job::Ticked{"tools"}}};
    return job;
}

inline JobEvent prepared() { return {"2026-11-23T09:01:00Z", job::Prepared{}}; }
inline JobEvent taken(int station)
{
    return {
        "2026-11-23T09:02:00Z", job::ReadingTaken{station, {{45.0 * station}, {}, {45.0 * station}}, 45.0 * station, 45.0 * station, {}}};
}

class SwingStores : public testing::Test {
protected:
    SwingId draft()
    {
        Swing swing = swingOf(m_stored);
        swing.readings.clear();
        return *save(m_swings, swing);
    }
    SwingId guided()
    {
        const SwingId id = draft();
        EXPECT_TRUE(m_jobs.add(id, smallJob(), false));
        return id;
    }
    SwingId completed()
    {
        const SwingId id = *save(m_swings, worksheetSwing(m_stored));
        EXPECT_TRUE(m_signing.complete(id));
        return id;
    }

    db::Database m_database = inMemory();
    Stored m_stored = store(m_database);
    db::SwingStore m_swings{m_database};
    db::FleetStore m_fleet{m_database};
    db::JobStore m_jobs{m_database};
    db::ResultStore m_results{m_database};
    db::SigningStore m_signing{m_database};
};

} // namespace lubberline::test
