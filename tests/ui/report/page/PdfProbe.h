#pragma once
/// What is in a PDF, as other programs see it: poppler's text and pages, qpdf's objects.

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <map>
#include <string>

#include "ui/report/card/CardDocument.h"
#include "ui/report/swing/Report.h"

namespace lubberline::test {

/// A PDF in a folder of its own that goes with it.
class PdfProbe {
public:
    explicit PdfProbe(const ui::ReportInput& input);
    explicit PdfProbe(const ui::CardInput& input);
    explicit PdfProbe(const QString& path) : m_path(path) {}

    [[nodiscard]] QString path() const { return m_path; }
    [[nodiscard]] QByteArray bytes() const;
    /// The text of each page, laid out as it stands there.
    [[nodiscard]] QStringList pages() const;
    [[nodiscard]] QString text() const { return pages().join('\n'); }
    /// Runs of white space as one blank: to look for sentences that are wrapped.
    [[nodiscard]] QString flowingText() const { return text().simplified(); }
    /// The pages as grey pictures, one after the other.
    [[nodiscard]] QByteArray rendered() const;
    /// How many objects of the PDF have a key that is not harmless: transparency, images.
    [[nodiscard]] std::map<std::string, int> suspiciousObjects() const;
    [[nodiscard]] bool hasCatalogKey(const std::string& key) const;

private:
    QTemporaryDir m_folder;
    QString m_path;
};

/// Standard output of a program; a failure of the test when it cannot be run.
QByteArray outputOf(const QString& program, const QStringList& arguments);

} // namespace lubberline::test
