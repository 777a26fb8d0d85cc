#include "core/record/Id.h"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/random_generator.hpp>
#include <boost/uuid/uuid_io.hpp>

namespace lubberline {

RecordId newRecordId() { return to_string(boost::uuids::random_generator()()); }

RecordId recordIdFor(std::string_view content)
{
    // Any fixed namespace will do, as long as it never changes.
    static const boost::uuids::uuid kNamespace = boost::uuids::name_generator_sha1(boost::uuids::ns::url())("urn:lubberline:record");
    return to_string(boost::uuids::name_generator_sha1(kNamespace)(content.data(), content.size()));
}

bool isRecordId(const std::string& text)
{
    if (text.size() != 36)
        return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool hyphen = i == 8 || i == 13 || i == 18 || i == 23;
        const char c = text[i];
        if (hyphen ? c != '-' : !((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f')))
            return false;
    }
    return true;
}

} // namespace lubberline
