#pragma once
/// The colours of documents: opaque, because archive PDFs know no transparency, and told apart on a grey copy.

#include <QColor>

namespace lubberline::ui::Ink {

inline QColor text() { return {0x11, 0x11, 0x11}; }
inline QColor faint() { return {0x70, 0x70, 0x70}; }
inline QColor rule() { return {0xc8, 0xc8, 0xc8}; }
inline QColor strong() { return {0x33, 0x33, 0x33}; }
inline QColor marked() { return {0xff, 0xf0, 0xc8}; } ///< ground of a row to be looked at
inline QColor shaded() { return {0xee, 0xee, 0xee}; }
inline QColor passTint() { return {0xdd, 0xf0, 0xe6}; }
inline QColor failTint() { return {0xfb, 0xdd, 0xd3}; }
inline QColor alarm() { return {0xb0, 0x00, 0x20}; }
inline QColor alarmTint() { return {0xff, 0xf2, 0xf2}; }

} // namespace lubberline::ui::Ink
