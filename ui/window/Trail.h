#pragma once
/// The places that were shown, in their order: what Back and Forward go along.

#include <optional>
#include <vector>

#include "ui/kit/Destination.h"

namespace lubberline::ui {

class Trail {
public:
    /// Shown now. What was ahead of it is forgotten; the same place again is no step.
    void visit(Destination place)
    {
        place.focus = false;
        if (const auto* here = current(); here && here->page == place.page && here->record == place.record)
            return;
        m_places.resize(m_places.empty() ? 0 : m_at + 1);
        m_places.push_back(std::move(place));
        if (m_places.size() > kMost)
            m_places.erase(m_places.begin());
        m_at = m_places.size() - 1;
    }
    [[nodiscard]] const Destination* current() const { return m_places.empty() ? nullptr : &m_places[m_at]; }
    [[nodiscard]] bool canGo(int step) const { return step < 0 ? m_at > 0 : m_at + 1 < m_places.size(); }
    /// @param step −1: back, +1: forward. None: there is nothing.
    std::optional<Destination> go(int step)
    {
        if (!canGo(step))
            return {};
        m_at = step < 0 ? m_at - 1 : m_at + 1;
        return m_places[m_at];
    }
    /// The place that was gone to is no more: the one before it is current again.
    void drop(int step)
    {
        m_places.erase(m_places.begin() + static_cast<std::ptrdiff_t>(m_at));
        if (step > 0)
            --m_at;
    }

private:
    static constexpr std::size_t kMost = 100;
    std::vector<Destination> m_places;
    std::size_t m_at = 0;
};

} // namespace lubberline::ui
