#pragma once
/// The language of the window. English is in the sources; another one is a catalogue that is built in
/// (resources/translations/lubberline_pl.ts). Commands, files, the audit trail and what is signed do not ask it.

#include <QString>
#include <QStringList>

namespace lubberline::ui {

/// LUBBERLINE_LANGUAGE ("pl", "en"), else the one that is preferred, else those of the system, the first before the others: "pl-PL", "de".
[[nodiscard]] QStringList wantedLanguages(const QString& preferred = {});

/// From now on the first of these that is English or has a catalogue; English where none has. The application must be there.
/// @return what is spoken: "en", "pl".
QString speak(const QStringList& languages);

} // namespace lubberline::ui
