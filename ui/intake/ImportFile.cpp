#include "ui/intake/ImportFile.h"

#include <QFile>
#include <QFileInfo>

#include <sstream>

#include "core/base/FileText.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/exchange/Exchange.h"
#include "core/format/json/JsonDocument.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

namespace {

void fillIn(std::string& stated, const std::string& given)
{
    if (stated.empty())
        stated = given;
}

Result<ImportFile> fleetOf(Result<SwingFile> file, const std::string& name, const CsvParticulars& particulars)
{
    if (!file)
        return file.error();
    fillIn(file->aircraft, particulars.aircraft);
    fillIn(file->type, particulars.type);
    fillIn(file->compass, particulars.compass);
    auto fleet = toFleet(*file);
    if (!fleet) {
        Error error = fleet.error();
        error.file = name;
        return error;
    }
    return ImportFile{std::move(fleet.value()), std::move(file->warnings)};
}

Result<ImportFile> parseExchange(const Result<std::string>& text, const std::string& name)
{
    if (!text)
        return text.error();
    auto fleet = readExchange(*text, name);
    if (!fleet)
        return fleet.error();
    return ImportFile{std::move(fleet.value()), {}};
}

/// It has no name, so its content tells what it is.
Result<ImportFile> readStandardInput(const std::string& path, const CsvParticulars& particulars, const Progress& progress)
{
    const auto text = readWholeFile(path, MARKED("ui", "a swing (CSV), an exchange file (JSON) or a report (PDF)"), kMostJsonBytes);
    if (!text)
        return text.error();
    const std::string name = nameOfInput(path);
    if (isPdf(*text))
        return parseExchange(exchangeInPdf(*text, QString::fromStdString(name)), name);
    std::string_view content = *text;
    if (content.starts_with(kByteOrderMark))
        content.remove_prefix(kByteOrderMark.size());
    if (const auto first = content.find_first_not_of(" \t\r\n"); first != std::string_view::npos && content[first] == '{')
        return parseExchange(text, name);
    std::istringstream stream(*text);
    return fleetOf(readSwingCsv(stream, name, progress), name, particulars);
}

} // namespace

Result<ImportFile> readImportFile(const QString& path, const CsvParticulars& particulars, const Progress& progress)
{
    const std::string name = path.toStdString();
    if (isStandardStream(name))
        return readStandardInput(name, particulars, progress);
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == "csv" || ending == "txt" || ending == "tsv")
        return fleetOf(readSwingCsvFile(name, progress), name, particulars);
    if (ending == "json")
        return parseExchange(readWholeFile(name, MARKED("ui", "an exchange file"), kMostJsonBytes), name);
    if (ending == "pdf")
        return parseExchange(exchangeInReport(path), name);
    return Error{ErrorCode::InvalidInput,
        MARKED("ui", "cannot be imported: expected a name that ends in .csv (swing), .json (exchange) or .pdf (report)"), name};
}

} // namespace lubberline::ui
