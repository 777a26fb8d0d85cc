#pragma once
/// The underlined letters of menus and pages: each once in a menu, and once on a page, whatever the language has made of them.

#include <QStringList>

class QMenu;
class QWidget;

namespace lubberline::ui {

/// The texts with each letter underlined in one of them only, and none that is in `taken`. One that keeps its letter stays as it is; a
/// later one that wants a letter which is gone gets the first of its own that is free, or none. "&&" stays a sign.
[[nodiscard]] QStringList distinctMnemonics(const QStringList& texts, const QString& taken = {});
/// Its letter in upper case; null: it has none.
[[nodiscard]] QChar mnemonicOf(const QString& text);

void makeMnemonicsDistinct(QMenu& menu); ///< of the entries that are seen, and of its submenus
/// Labels with a partner, buttons, boxes and tabs that are seen on the page; letters of the menu bar, and of what stands around
/// the page in its window, are not theirs.
void makeMnemonicsDistinct(QWidget& page, const QWidget& window);

} // namespace lubberline::ui
