#include "core/record/DerivedId.h"

#include <array>
#include <charconv>

namespace lubberline {

namespace {

/// Collects fields so that no two lists of fields give the same text: each is preceded by its length.
class Content {
public:
    Content& operator<<(std::string_view field)
    {
        m_text += std::to_string(field.size());
        m_text += ':';
        m_text += field;
        return *this;
    }
    Content& operator<<(std::optional<double> value)
    {
        std::array<char, 32> buffer;
        const char* end = value ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), *value).ptr : buffer.data();
        return *this << std::string_view(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration> Content& operator<<(Enumeration value)
    {
        return *this << std::string_view(std::to_string(static_cast<int>(value)));
    }
    [[nodiscard]] RecordId id() const { return recordIdFor(m_text); }

private:
    std::string m_text;
};

template <class Angle>
std::optional<double> degreesOf(const std::optional<Angle>& angle)
{
    return angle ? std::optional(angle->degrees()) : std::nullopt;
}

void add(Content& content, const Reading& reading)
{
    content << reading.nominal_deg << degreesOf(reading.magnetic) << degreesOf(reading.compass) << degreesOf(reading.trueHeading)
            << reading.pitch_deg << reading.roll_deg << reading.note << (reading.exclusion ? reading.exclusion->reason : std::string());
    for (const auto& [name, value] : reading.extra)
        content << name << value;
    content << "end of reading";
}

/// The place alone: a file that is stamped anew by a later model is the same swing.
void add(Content& content, const FieldStamp& stamp)
{
    content << "field" << std::optional(stamp.place.latitude_deg) << std::optional(stamp.place.longitude_deg)
            << std::optional(stamp.place.height_m);
}

} // namespace

RecordId recordIdOfType(std::string_view name) { return (Content() << "aircraft type" << name).id(); }
RecordId recordIdOfAircraft(std::string_view registration) { return (Content() << "aircraft" << registration).id(); }
RecordId recordIdOfSite(std::string_view name) { return (Content() << "site" << name).id(); }
RecordId recordIdOfLimits(std::string_view name) { return (Content() << "limits profile" << name).id(); }
RecordId recordIdOfCompass(std::string_view registration, std::string_view name)
{
    return (Content() << "compass" << registration << name).id();
}

RecordId recordIdOfSensor(std::string_view registration, std::string_view compass, std::string_view name)
{
    return (Content() << "sensor model" << registration << compass << name).id();
}

RecordId recordIdOfSwing(const Swing& swing, std::string_view registration, std::string_view compass, std::string_view site)
{
    Content content;
    // What is not stated has the identity that it had when it was taken for the usual.
    const SwingKind kind = swing.kind == SwingKind::NotStated ? SwingKind::Check : swing.kind;
    const SwingStage stage = swing.stage == SwingStage::NotStated ? SwingStage::AsFound : swing.stage;
    content << "swing" << registration << compass << site << swing.date.text() << kind << stage << swing.configuration.radio
            << swing.configuration.engines << swing.configuration.electrics << swing.configuration.other << swing.datum.instrument
            << swing.datum.serialNumber << swing.datum.calibrationDue.text() << swing.people.datumReader << swing.people.cockpitReader
            << swing.people.adjuster << swing.people.inspector << swing.variation_deg << swing.procedure << swing.workOrder << swing.reason
            << swing.note;
    if (swing.indexRemoved_deg) // what is not stated leaves the identities as they were before it could be
        content << "index removed" << swing.indexRemoved_deg;
    if (swing.sharedErrors.any())
        content << "shared errors" << textOf(swing.sharedErrors);
    if (swing.field)
        add(content, *swing.field);
    for (const auto& reading : swing.readings)
        add(content, reading);
    return content.id();
}

} // namespace lubberline
