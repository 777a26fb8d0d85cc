#pragma once
/// The translation context of documents, and what the record's choices are called in them.

#include <QCoreApplication>
#include <QString>

#include "core/record/Fleet.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Documents)
};

[[nodiscard]] QString wordsFor(SwingKind kind);
[[nodiscard]] QString wordsFor(SwingStage stage);
[[nodiscard]] QString wordsFor(SwingState state);
[[nodiscard]] QString wordsFor(RadioState radio); ///< "radio on", "radio off"; empty when not stated
[[nodiscard]] QString wordsFor(CompassKind kind);
[[nodiscard]] QString wordsFor(Compensator compensator); ///< empty when unknown

/// What must be seen on every page: demonstration data, a draft. Empty for none.
[[nodiscard]] QString bannerFor(const SwingRecord& record);

/// "engines running · electrics on · radio on · …"; empty when nothing is stated.
[[nodiscard]] QString configurationWords(const Configuration& configuration);

/// Text of a record in one line without control characters: XML and paper take none.
[[nodiscard]] QString printable(const std::string& text);
[[nodiscard]] inline QString printable(const Message& message) { return printable(translated(message).toStdString()); }

/// What stands where the record says nothing.
[[nodiscard]] QString notStated();

/// The parts that are not empty, joined by a middle dot.
[[nodiscard]] QString joined(const QStringList& parts);
/// "label text", or nothing when there is no text.
[[nodiscard]] QString labelled(const QString& label, const QString& text);

} // namespace lubberline::ui
