#pragma once
/// What a report says, before it is set on pages or in HTML: the same words and figures for both.

#include <QString>
#include <QStringList>

#include <vector>

#include "core/swing/Analysis.h"
#include "ui/plots/swing/SwingPicture.h"
#include "ui/report/page/PageFrame.h"
#include "ui/report/page/Table.h"
#include "ui/report/swing/FieldPage.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

struct SignatureLine {
    QString role;
    QString name; ///< with the licence; as recorded, may be empty
    QString date; ///< empty: not signed yet
    QString sign; ///< what the signature stands for; empty: to be signed by hand
};

struct ReportContent {
    PageFrame frame;
    Verdict verdict = Verdict::NotKnown;
    QString verdictWord;     ///< PASS, FAIL, NO LIMIT SET
    QString verdictSentence; ///< what was found and what it is held against, with the document
    std::vector<Fact> facts;
    Table readings;
    Table coefficients;
    Table fits;
    QStringList warnings; ///< what the readings cannot tell
    SwingPicture picture;
    std::vector<Fact> method; ///< sign convention and methods in words
    std::vector<SignatureLine> signatures;
    std::vector<Table> job;         ///< of the guided swing and the revision; may be empty
    std::optional<FieldPage> field; ///< none: the swing keeps no field and the compass no sensor model
};

[[nodiscard]] ReportContent contentOf(const ReportInput& input);

/// The parts, each in a source of its own.
[[nodiscard]] std::vector<Fact> factsOf(const SwingRecord& record, bool signaturesStand = true);
[[nodiscard]] Table readingsTable(const ReportInput& input);
[[nodiscard]] Table coefficientsTable(const Analysis& analysis);
[[nodiscard]] Table fitsTable(const Analysis& analysis);
[[nodiscard]] std::vector<Fact> methodWords(const Analysis& analysis);
/// "|deviation| ≤ 10° · document, issue; scope"; empty when the profile sets no limit.
[[nodiscard]] QString limitWords(const LimitsProfile& limits);

} // namespace lubberline::ui
