#pragma once
/// Undoable edits of the readings of one swing.

#include <utility>
#include <vector>

#include "ui/kit/Edit.h"

namespace lubberline::ui {

class ReadingEdit : public Edit {
public:
    ReadingEdit(EditContext& context, SwingId swing, const QString& text) : Edit(context, text), m_swing(swing) {}
    [[nodiscard]] SwingId swing() const override { return context().swings.current(m_swing); }

private:
    SwingId m_swing;
};

/// A cell, or the exclusion, of one reading.
class ChangeReading final : public ReadingEdit {
public:
    ChangeReading(EditContext& context, SwingId swing, Reading before, Reading after, const QString& text);

protected:
    Result<void> apply() override { return store(m_before, m_after); }
    Result<void> revert() override { return store(m_after, m_before); }

private:
    Result<void> store(Reading from, Reading to) const;
    Reading m_before, m_after;
};

/// A reading and its place in the table.
struct PlacedReading {
    int position = 0;
    Reading reading;
};

/// A block: rows that are changed, and others that come behind them.
class PutReadings final : public ReadingEdit {
public:
    using Change = std::pair<Reading, Reading>; ///< before and after
    PutReadings(EditContext& context, SwingId swing, std::vector<Change> changed, std::vector<PlacedReading> added, const QString& text);

protected:
    Result<void> apply() override;
    Result<void> revert() override;

private:
    std::vector<Change> m_changed;
    std::vector<PlacedReading> m_added;
};

/// Rows in or out; positions are those of the table that has the rows, ascending.
class InsertReadings final : public ReadingEdit {
public:
    InsertReadings(EditContext& context, SwingId swing, std::vector<PlacedReading> rows, const QString& text);

protected:
    Result<void> apply() override;
    Result<void> revert() override;

private:
    std::vector<PlacedReading> m_rows;
};

class RemoveReadings final : public ReadingEdit {
public:
    RemoveReadings(EditContext& context, SwingId swing, std::vector<PlacedReading> rows, const QString& text);

protected:
    Result<void> apply() override;
    Result<void> revert() override;

private:
    std::vector<PlacedReading> m_rows;
};

} // namespace lubberline::ui
