#include "core/nmea/NmeaLines.h"

namespace lubberline {

void NmeaLines::feed(std::string_view bytes, const Each& each)
{
    for (const char c : bytes) {
        if (c == '\n' || c == '\r') {
            finish(each);
            continue;
        }
        m_givenUp = m_givenUp && c != '$';
        if (m_givenUp)
            continue;
        m_line += c;
        if (m_line.size() > kMaxNmeaLine)
            giveUp(each);
    }
}

void NmeaLines::giveUp(const Each& each)
{
    const std::size_t last = m_line.rfind('$');
    m_givenUp = last == 0 || last == std::string::npos;
    each(std::string_view(m_line).substr(0, m_givenUp ? m_line.size() : last));
    m_line.erase(0, m_givenUp ? m_line.size() : last);
}

void NmeaLines::finish(const Each& each)
{
    if (!m_line.empty())
        each(m_line);
    m_line.clear();
    m_givenUp = false;
}

} // namespace lubberline
