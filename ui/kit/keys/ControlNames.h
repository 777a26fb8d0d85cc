#pragma once
/// Names for a screen reader: what sighted people read beside a control or in it.

class QWidget;

namespace lubberline::ui {

/// Every control below `page` that has no name of its own is called by the label before it, else by its placeholder, else by the first line
/// of its tip. What a page names itself stays.
void nameControls(QWidget& page);

} // namespace lubberline::ui
