#include "core/record/Signature.h"

#include <algorithm>

#include "core/base/Contract.h"

namespace lubberline {

namespace {

/// One character of UTF-8 from `at`, which moves on; what is no UTF-8 counts as a character of one byte.
char32_t nextCharacter(const std::string& text, std::size_t& at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at++);
    const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
    if (more == 0 || at + more > text.size())
        return first;
    char32_t character = first & (0x3F >> more);
    for (std::size_t i = 0; i < more; ++i)
        character = (character << 6) | (byte(at++) & 0x3F);
    return character;
}

/// Small letters of Latin, Greek and Cyrillic.
char32_t small(char32_t c)
{
    const auto in = [c](char32_t from, char32_t to) { return c >= from && c <= to; };
    if (in('A', 'Z') || (in(0xC0, 0xDE) && c != 0xD7) || in(0x391, 0x3A9) || in(0x410, 0x42F))
        return c + 0x20;
    if (in(0x400, 0x40F))
        return c + 0x50;
    const bool evenIsLarge = in(0x100, 0x137) || in(0x14A, 0x177), oddIsLarge = in(0x139, 0x148) || in(0x179, 0x17E);
    if ((evenIsLarge && c % 2 == 0) || (oddIsLarge && c % 2 == 1))
        return c + 1;
    return c;
}

/// Letters and figures alone, by words in the order of their letters.
std::vector<std::u32string> wordsOfName(const std::string& name)
{
    std::vector<std::u32string> words(1);
    for (std::size_t at = 0; at < name.size();) {
        const char32_t c = small(nextCharacter(name, at));
        if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c > 0xBF && c < 0x2000) || c > 0x206F)
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty())
        words.pop_back();
    return words;
}

} // namespace

bool freezes(const std::vector<Signature>& signatures, const std::vector<bool>& hold)
{
    LUBBERLINE_EXPECT(signatures.size() == hold.size(), "each signature holds or does not");
    const auto given = [&](SignatureRole role) {
        for (std::size_t i = 0; i < signatures.size(); ++i)
            if (signatures[i].role == role && hold[i])
                return true;
        return false;
    };
    return given(SignatureRole::Performer) && (given(SignatureRole::Inspector) || given(SignatureRole::Authority));
}

bool samePerson(const std::string& one, const std::string& other)
{
    const auto together = [](const std::vector<std::u32string>& words) {
        std::u32string letters;
        for (const auto& word : words)
            letters += word;
        return letters;
    };
    auto first = wordsOfName(one), second = wordsOfName(other);
    if (first.empty() || together(first) == together(second)) // "PL12" and "PL 12"
        return !first.empty();
    std::ranges::sort(first);
    std::ranges::sort(second);
    return first == second; // "Ada Nowak" and "Nowak, Ada"
}

Message whyNotSign(const Signature& signature, const std::vector<Signature>& signatures, const std::vector<bool>& hold,
    const std::string& adjuster, const std::string& inspector)
{
    LUBBERLINE_EXPECT(signatures.size() == hold.size(), "each signature holds or does not");
    const bool performs = signature.role == SignatureRole::Performer;
    for (std::size_t i = 0; i < signatures.size(); ++i) {
        const Signature& other = signatures[i];
        const bool sameSide = performs == (other.role == SignatureRole::Performer);
        if (!hold[i] || sameSide)
            continue;
        if (samePerson(signature.name, other.name) || samePerson(signature.licence, other.licence)
            || (!signature.key.empty() && signature.key == other.key))
            return {performs ? MARKED("core", "%1 has signed as inspector or authority; expected another person as performer")
                             : MARKED("core", "%1 has signed as performer; expected another person who checks the work"),
                other.name};
    }
    if (!performs && samePerson(signature.name, adjuster))
        return {MARKED("core", "%1 adjusted this compass, as the swing says; expected another person who checks the work"), adjuster};
    if (performs && samePerson(signature.name, inspector))
        return {MARKED("core", "%1 inspects this swing, as it says; expected another person as performer"), inspector};
    return {};
}

} // namespace lubberline
