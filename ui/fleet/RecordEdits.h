#pragma once
/// Undoable edits of particulars: an aircraft, a compass, an event, a swing; and a whole draft swing, made or removed.

#include <optional>
#include <utility>
#include <vector>

#include "ui/kit/Edit.h"

namespace lubberline::ui {

/// An aircraft's own particulars, or those of one of its compasses.
template <class Record>
class ChangeRecord final : public Edit {
public:
    ChangeRecord(EditContext& context, AircraftId aircraft, Record before, Record after, const QString& text)
        : Edit(context, text)
        , m_aircraft(aircraft)
        , m_before(std::move(before))
        , m_after(std::move(after))
    {
    }
    [[nodiscard]] AircraftId aircraft() const override { return m_aircraft; }

protected:
    Result<void> apply() override { return store(m_before, m_after); }
    Result<void> revert() override { return store(m_after, m_before); }

private:
    Result<void> store(const Record& known, const Record& record) const { return stores().fleet.change(known, record); }

    AircraftId m_aircraft;
    Record m_before, m_after;
};

/// The particulars of a swing, with the magnetic headings that follow from true ones when its variation changes.
class ChangeSwing final : public Edit {
public:
    ChangeSwing(EditContext& context, Swing before, Swing after, const QString& text);
    [[nodiscard]] SwingId swing() const override { return context().swings.current(m_before.id); }

protected:
    Result<void> apply() override { return store(m_before, m_after); }
    Result<void> revert() override { return store(m_after, m_before); }

private:
    Result<void> store(const Swing& from, const Swing& to) const;
    Swing m_before, m_after;
};

/// A draft is completed. Undone it is opened again, which its audit trail says.
class CompleteSwing final : public Edit {
public:
    CompleteSwing(EditContext& context, SwingId swing, const QString& text) : Edit(context, text), m_swing(swing) {}
    [[nodiscard]] SwingId swing() const override { return context().swings.current(m_swing); }

protected:
    Result<void> apply() override { return stores().signing.complete(swing()); }
    Result<void> revert() override { return stores().signing.reopen(swing(), "completion undone"); }

private:
    SwingId m_swing;
};

/// A draft swing with its readings is made (or removed: the other way round).
class MakeSwing final : public Edit {
public:
    enum class Direction { Make, Remove };
    MakeSwing(EditContext& context, Swing swing, Direction direction, const QString& text);
    /// Not valid while the swing does not exist.
    [[nodiscard]] SwingId swing() const override { return m_exists ? context().swings.current(m_swing.id) : SwingId(); }

protected:
    Result<void> apply() override { return m_direction == Direction::Make ? make() : remove(); }
    Result<void> revert() override { return m_direction == Direction::Make ? remove() : make(); }

private:
    /// The guided swing that a draft was begun with goes with it, and comes back with it.
    struct Guided {
        SwingJob job;
        bool open = false, abandoned = false;
        std::vector<TypedText> typed;
    };
    Result<void> make();
    Result<void> remove();
    [[nodiscard]] Result<std::optional<Guided>> guided(SwingId id) const;
    Result<void> makeGuided(SwingId id) const;
    Swing m_swing;
    std::optional<Guided> m_guided;
    Direction m_direction;
    bool m_exists;
};

} // namespace lubberline::ui
