#pragma once
/// The texts of the help that are of no page.

#include <QString>
#include <QStringList>

#include <utility>
#include <vector>

namespace lubberline::ui {

struct LicenceTable {
    QString title;
    std::vector<QStringList> rows;
};

[[nodiscard]] QString beginText();
[[nodiscard]] QString derivationText();
[[nodiscard]] QString licenceText();
[[nodiscard]] QString problemText();
[[nodiscard]] std::vector<std::pair<QString, QString>> glossary();       ///< term and meaning, in the order of the language
[[nodiscard]] std::vector<std::pair<QString, QString>> keysEverywhere(); ///< keys that are in no menu
[[nodiscard]] std::vector<LicenceTable> licences();
/// Of a page that no command of its own names; empty: one does.
[[nodiscard]] QString pageName(const QString& id);

} // namespace lubberline::ui
