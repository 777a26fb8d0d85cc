#include "db/transfer/SignedFleet.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/format/exchange/SignedContent.h"
#include "db/chain/Links.h"

namespace lubberline::db {

void signInNames(Fleet& fleet)
{
    for (Swing& swing : fleet.swings) {
        if (swing.state != SwingState::Signed || !swing.signatures.empty())
            continue;
        const auto job = std::ranges::find(fleet.jobs, swing.id, &JobRecord::swing);
        const SwingRecord record = recordIn(fleet, swing);
        for (const auto& [role, name] :
            {std::pair(SignatureRole::Performer, swing.people.datumReader), std::pair(SignatureRole::Inspector, swing.people.inspector)}) {
            Signature signature{role, name, {}, swing.date.text() + "T16:00:00.000Z", {}, kSignedContents};
            signature.particulars = signedParticulars(record);
            signature.hash = sha256(
                signedContent(record, job == fleet.jobs.end() ? std::nullopt : std::optional(job->job), signature, swing.signatures));
            swing.signatures.push_back(std::move(signature));
        }
    }
}

} // namespace lubberline::db
