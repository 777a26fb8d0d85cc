#pragma once
/// Forms, choices and tables of a page take the room that there is: nothing of them is cut where it is narrow.

class QLineEdit;
class QWidget;

namespace lubberline::ui {

/// What every page and panel is given when its controls are made: names for a screen reader (see ControlNames.h), the focus that is seen, and the fit.
void finishControls(QWidget& page);

/// As wide as what stands in it while it is empty.
void showHint(QLineEdit& line);

/// Below `page`: rows of forms put a field beneath its label where both are too long, choices are as wide as their words
/// and say in a tip what is longer than any page, columns of tables fit (see TableFit.h). What comes later is to be given here again; it does no harm twice.
void fitControls(QWidget& page);

} // namespace lubberline::ui
