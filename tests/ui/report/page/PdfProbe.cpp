#include "tests/ui/report/page/PdfProbe.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>

#include <qpdf/QPDF.hh>

namespace lubberline::test {

PdfProbe::PdfProbe(const ui::ReportInput& input) : m_path(m_folder.filePath("report.pdf"))
{
    const auto written = ui::writeReport(input, m_path);
    EXPECT_TRUE(written.ok()) << (written.ok() ? "" : describe(written.error()));
}

PdfProbe::PdfProbe(const ui::CardInput& input) : m_path(m_folder.filePath("card.pdf"))
{
    const auto written = ui::writeCard(input, m_path);
    EXPECT_TRUE(written.ok()) << (written.ok() ? "" : describe(written.error()));
}

QByteArray PdfProbe::bytes() const
{
    QFile file(m_path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << m_path.toStdString();
    return file.readAll();
}

QStringList PdfProbe::pages() const
{
    QStringList pages = QString::fromUtf8(outputOf("pdftotext", {"-layout", "-enc", "UTF-8", m_path, "-"})).split('\f');
    if (!pages.isEmpty() && pages.last().trimmed().isEmpty())
        pages.removeLast(); // a form feed ends every page
    return pages;
}

QByteArray PdfProbe::rendered() const { return outputOf("pdftoppm", {"-r", "50", "-gray", m_path}); }

std::map<std::string, int> PdfProbe::suspiciousObjects() const
{
    std::map<std::string, int> found;
    QPDF pdf;
    pdf.processFile(QFile::encodeName(m_path).constData());
    for (QPDFObjectHandle object : pdf.getAllObjects()) {
        QPDFObjectHandle dictionary = object.isStream() ? object.getDict() : object;
        if (!dictionary.isDictionary())
            continue;
        for (const char* key : {"/ca", "/CA"}) {
            QPDFObjectHandle opacity = dictionary.getKey(key);
            if (opacity.isNumber() && opacity.getNumericValue() != 1.0)
                ++found["opacity"];
        }
        QPDFObjectHandle mask = dictionary.getKey("/SMask");
        if (!mask.isNull() && !(mask.isName() && mask.getName() == "/None"))
            ++found["soft mask"];
        if (QPDFObjectHandle group = dictionary.getKey("/S"); group.isName() && group.getName() == "/Transparency")
            ++found["transparency group"];
        if (QPDFObjectHandle kind = dictionary.getKey("/Subtype"); object.isStream() && kind.isName() && kind.getName() == "/Image")
            ++found["image"];
    }
    return found;
}

bool PdfProbe::hasCatalogKey(const std::string& key) const
{
    QPDF pdf;
    pdf.processFile(QFile::encodeName(m_path).constData());
    return pdf.getRoot().hasKey(key);
}

QByteArray outputOf(const QString& program, const QStringList& arguments)
{
    QProcess process;
    process.start(program, arguments);
    EXPECT_TRUE(process.waitForFinished(60000)) << program.toStdString() << ": " << process.errorString().toStdString();
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    return process.readAllStandardOutput();
}

} // namespace lubberline::test
