#include "ui/intake/ImportFile.h"

#include <QFile>
#include <QFileInfo>

#include "core/format/csv/SwingCsv.h"
#include "core/format/exchange/Exchange.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

namespace {

void fillIn(std::string& stated, const std::string& given)
{
    if (stated.empty())
        stated = given;
}

Result<ImportFile> readCsv(const QString& path, const CsvParticulars& particulars, const Progress& progress)
{
    auto file = readSwingCsvFile(path.toStdString(), progress);
    if (!file)
        return file.error();
    fillIn(file->aircraft, particulars.aircraft);
    fillIn(file->type, particulars.type);
    fillIn(file->compass, particulars.compass);
    auto fleet = toFleet(*file);
    if (!fleet) {
        Error error = fleet.error();
        error.file = path.toStdString();
        return error;
    }
    return ImportFile{std::move(fleet.value()), std::move(file->warnings)};
}

Result<ImportFile> parseExchange(const Result<std::string>& text, const QString& path)
{
    if (!text)
        return text.error();
    auto fleet = readExchange(*text, path.toStdString());
    if (!fleet)
        return fleet.error();
    return ImportFile{std::move(fleet.value()), {}};
}

Result<std::string> readWhole(const QString& path)
{
    QFile file(path);
    if (QFileInfo(path).isDir() || !file.open(QIODevice::ReadOnly))
        return Error{ErrorCode::Io, {MARKED("ui", "cannot be read: %1; expected an exchange file"), file.errorString().toStdString()},
            path.toStdString()};
    return file.readAll().toStdString();
}

} // namespace

Result<ImportFile> readImportFile(const QString& path, const CsvParticulars& particulars, const Progress& progress)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == "csv" || ending == "txt" || ending == "tsv")
        return readCsv(path, particulars, progress);
    if (ending == "json")
        return parseExchange(readWhole(path), path);
    if (ending == "pdf")
        return parseExchange(exchangeInReport(path), path);
    return Error{ErrorCode::InvalidInput,
        MARKED("ui", "cannot be imported: expected a name that ends in .csv (swing), .json (exchange) or .pdf (report)"),
        path.toStdString()};
}

} // namespace lubberline::ui
