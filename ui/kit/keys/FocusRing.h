#pragma once
/// Tables, lists, trees and texts show that they have the keyboard, also where no cell is current or nothing is in them: styles do not.

class QWidget;

namespace lubberline::ui {

/// Below `page`. What comes later is to be given here again; it does no harm twice.
void ringFocusedViews(QWidget& page);

} // namespace lubberline::ui
