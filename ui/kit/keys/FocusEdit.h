#pragma once
/// Cut, copy, paste and select all, as the menu Edit means them: in whatever has the keyboard.

class QWidget;

namespace lubberline::ui {

enum class EditVerb { Cut, Copy, Paste, SelectAll };

/// Lines and texts do as they always do; a table or list that has no way of its own gives its chosen cells as a spreadsheet takes them.
/// What cannot do a thing does nothing.
void editIn(QWidget* focused, EditVerb verb);

} // namespace lubberline::ui
