#pragma once
/// The one result of a stored swing, and what it is computed from: its readings, the guided swing that it came from, what its compass's last
/// swing and the aircraft of its type let expect.

#include <optional>

#include "core/record/Fleet.h"
#include "core/swing/SwingPlaces.h"
#include "core/swing/SwingResult.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class ResultStore {
public:
    explicit ResultStore(Database& database) : m_database(database) {}

    /// What the result of a stored swing is computed from, with what its compass's last swing or its siblings let expect (for slips); answerTo() it on a worker where
    /// there are many readings.
    Result<SwingQuestion> questionOf(const SwingRecord& record);
    Result<SwingQuestion> questionOf(SwingId swing);
    /// How a compass that no swing before tells of is expected to deviate by its siblings: other aircraft of its type with the same compass.
    /// None: a swing before tells it, or too few siblings do.
    Result<std::optional<ExpectedCurve>> siblingsOf(const SwingRecord& record);
    /// The same question with what siblingsOf() said when it was asked: it reads hundreds of swings, which no keystroke waits for.
    Result<SwingQuestion> questionOf(const SwingRecord& record, const std::optional<ExpectedCurve>& siblings);
    /// The one result of a stored swing (core/swing/SwingResult.h), with the divisions of the guided swing that it came from.
    /// Errors: those of resultOf(); Corrupt when that guided swing does not read: without it the result would look surer than it is.
    Result<Analysis> resultOf(const SwingRecord& record);
    Result<Analysis> resultOf(SwingId swing);
    /// Likewise: its coefficients with their errors, in its field. Errors: those of swingAtPlace() besides.
    Result<SwingAtPlace> placeOf(const SwingRecord& record);

    /// How many changes of readings the kept results of a swing are behind: 0 but for a log in which somebody types.
    Result<int> behind(SwingId swing);
    /// Keeps the result that was computed of a log for the lists of swings, unless its readings were changed since it was `behind`.
    /// @param changed the reading that was changed, as those who listen are told
    Result<void> keep(const SwingRecord& record, const Analysis& analysis, int behind, ReadingId changed);
    /// Computes what is kept of a swing that is behind.
    Result<void> catchUp(SwingId swing);

private:
    Database& m_database;
};

} // namespace lubberline::db
