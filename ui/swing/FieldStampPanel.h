#pragma once

#include <QWidget>

#include <optional>

#include "core/earth/FieldStamp.h"

class QLabel;
class QPushButton;

namespace lubberline::ui {

class SwingEditor;

/// The Earth's field that the swing was computed with, in one line; what differs from today's model or from the swing's site
/// and date, with a button that takes the new values; and a stated variation that cannot be right.
class FieldStampPanel : public QWidget {
    Q_OBJECT

public:
    explicit FieldStampPanel(SwingEditor& editor, QWidget* parent = nullptr);

private:
    void showRecord();
    void take();
    [[nodiscard]] QString difference() const;
    [[nodiscard]] QString doubtfulVariation() const;

    SwingEditor& m_editor;
    std::optional<FieldStamp> m_now; ///< what would be computed now
    QLabel* m_values;
    QLabel* m_difference;
    QPushButton* m_take;
    QLabel* m_variation;
};

} // namespace lubberline::ui
