#include "db/stores/SwingMarks.h"

#include "db/engine/Statement.h"
#include "db/stores/Signatures.h"
#include "db/stores/SigningStore.h"
#include "db/stores/SwingReadings.h"

namespace lubberline::db {

namespace {

/// About 50 ms of a slow machine.
constexpr int kReadingsOfList = 2000;
constexpr int kReadingsOfRecord = 40; ///< what a record costs besides its readings, in readings

Result<bool> standsNow(Database& database, SwingId id)
{
    auto swing = particularsOf(database, id);
    auto signatures = signaturesOf(database, id);
    if (!swing || !signatures)
        return swing ? signatures.error() : swing.error();
    swing->signatures = std::move(signatures.value());
    SigningStore signing(database);
    const auto states = swing->signatures.empty() ? Result(std::vector<SignatureState>()) : signing.states(id);
    return states ? signing.stands(*swing, *states) : states.error();
}

Result<bool> hasSignature(Database& database, SwingId swing)
{
    Statement statement(database, "SELECT " + somebodySigned() + " FROM swing s WHERE s.id = ?");
    statement << swing;
    return oneOf<bool>(statement, database, MARKED("db", "swing"), [](Statement& row) { return row.flag(0); });
}

} // namespace

SignedMark signedMark(Database& database, SwingId swing, SwingState state)
{
    if (state != SwingState::Signed)
        return SignedMark::No;
    const auto stands = standsNow(database, swing);
    return stands && *stands ? SignedMark::Stands : SignedMark::ByStateAlone;
}

Result<std::vector<SignedMark>> signedMarks(Database& database, const std::vector<SwingRow>& rows)
{
    std::vector<SignedMark> marks;
    int readings = 0;
    for (const SwingRow& row : rows) {
        readings += row.state == SwingState::Signed ? row.readings + kReadingsOfRecord : 0;
        if (row.state != SwingState::Signed || readings <= kReadingsOfList) {
            marks.push_back(signedMark(database, row.id, row.state));
            continue;
        }
        const auto somebody = hasSignature(database, row.id);
        if (!somebody)
            return somebody.error();
        marks.push_back(*somebody ? SignedMark::NotChecked : SignedMark::ByStateAlone);
    }
    return marks;
}

bool StandingSwings::has(SwingId swing)
{
    const auto [found, isNew] = m_known.try_emplace(swing, false);
    if (isNew)
        found->second = signedMark(m_database, swing, SwingState::Signed) == SignedMark::Stands;
    return found->second;
}

Result<RadioState> radioOf(Database& database, SwingId swing)
{
    Statement statement(database, "SELECT radio FROM swing WHERE id = ?");
    statement << swing;
    return oneOf<RadioState>(statement, database, MARKED("db", "swing"), [](Statement& row) { return row.as(0, RadioState::Off); });
}

} // namespace lubberline::db
