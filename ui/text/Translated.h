#pragma once
/// What core and db say (core/base/Message.h), in the reader's language.

#include <QString>

#include "core/base/Result.h"

namespace lubberline::ui {

[[nodiscard]] QString translated(const Message& message);
/// "FILE:LINE: what is wrong and what was expected".
[[nodiscard]] QString messageOf(const Error& error);
/// A text of the window, which is in the reader's language already, for an Error of the window.
[[nodiscard]] Message said(const QString& text);

} // namespace lubberline::ui
