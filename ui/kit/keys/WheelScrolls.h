#pragma once
/// The wheel scrolls pages. Over a choice or a number it would change what is stored, unasked and unseen, where a page runs beneath the pointer.

#include <QObject>

namespace lubberline::ui {

/// For all of the program: choices, numbers and dates change by hand, keys and arrows alone, and the wheel gives them no focus.
class WheelScrolls final : public QObject {
public:
    explicit WheelScrolls(QObject* parent);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;
};

} // namespace lubberline::ui
