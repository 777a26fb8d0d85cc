#include "core/deviation/SlipWords.h"

#include "core/base/Number.h"

namespace lubberline {

Message wordFor(Slip slip)
{
    switch (slip) {
    case Slip::SwappedDigits: return MARKED("core", "swapped digits");
    case Slip::Reciprocal: return MARKED("core", "the reciprocal");
    case Slip::FiveDegrees: return MARKED("core", "a 5° slip");
    case Slip::TenDegrees: return MARKED("core", "a 10° slip");
    case Slip::HundredDegrees: return MARKED("core", "a 100° slip");
    case Slip::WrongSign: return MARKED("core", "a deviation applied with the wrong sign");
    case Slip::WrongRow: return MARKED("core", "the wrong row");
    case Slip::Unexplained: break;
    }
    return MARKED("core", "no usual slip");
}

const char* codeOf(Slip slip)
{
    switch (slip) {
    case Slip::SwappedDigits: return "swapped_digits";
    case Slip::Reciprocal: return "reciprocal";
    case Slip::FiveDegrees: return "five_degrees";
    case Slip::TenDegrees: return "ten_degrees";
    case Slip::HundredDegrees: return "hundred_degrees";
    case Slip::WrongSign: return "wrong_sign";
    case Slip::WrongRow: return "wrong_row";
    case Slip::Unexplained: break;
    }
    return "unexplained";
}

std::string keptAsRead(const SlipJudgement& judgement)
{
    if (!judgement.lookAgain() || judgement.candidates.empty())
        return "kept as read";
    const SlipCandidate& likeliest = judgement.candidates.front();
    std::string text = std::string("kept as read: ") + codeOf(likeliest.slip);
    if (likeliest.slip != Slip::Unexplained)
        text += " " + figureText(likeliest.meant_deg, 1);
    return text + " (" + figureText(likeliest.probability, 2) + ")";
}

} // namespace lubberline
