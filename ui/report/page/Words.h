#pragma once
/// The translation context of documents, and sentences that several have.

#include <QCoreApplication>
#include <QString>

#include "core/record/Fleet.h"
#include "ui/report/page/SignedAs.h"
#include "ui/text/ChoiceWords.h"

namespace lubberline::ui {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Documents)
};

/// What must be seen on every page: demonstration data, a draft. Empty for none.
[[nodiscard]] QString bannerFor(const SwingRecord& record);

/// "engines running · electrics on · radio on · …"; empty when nothing is stated.
[[nodiscard]] QString configurationWords(const Configuration& configuration);

/// Text of a record in one line without control characters: XML and paper take none.
[[nodiscard]] QString printable(const std::string& text);
[[nodiscard]] inline QString printable(Date day) { return printable(day.text()); }
[[nodiscard]] inline QString printable(const Message& message) { return printable(translated(message).toStdString()); }

/// What stands where the record says nothing.
[[nodiscard]] QString notStated();

/// The parts that are not empty, joined by a middle dot.
[[nodiscard]] QString joined(const QStringList& parts);
/// "label text", or nothing when there is no text.
[[nodiscard]] QString labelled(const QString& label, const QString& text);

} // namespace lubberline::ui
