#include "ui/window/Transfers.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "core/base/OutputFile.h"
#include "core/format/exchange/Exchange.h"
#include "db/transfer/Transfer.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct TransferWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Transfers)
};

Progress half(const Progress& whole, int which)
{
    return [whole, which](double fraction) { return whole(0.5 * which + 0.5 * fraction); };
}

QString importMessage(const QString& path, const db::Imported& imported)
{
    QString message = TransferWords::tr("%1: swings imported: %2").arg(QFileInfo(path).fileName()).arg(imported.swings);
    if (imported.alreadyThere > 0)
        message += TransferWords::tr(", already there: %1").arg(imported.alreadyThere);
    return message + ".";
}

Result<TransferOutcome> importFile(
    const db::Stores& stores, const QString& path, const CsvParticulars& particulars, const Progress& progress)
{
    auto file = readImportFile(path, particulars, half(progress, 0));
    if (!file)
        return file.error();
    auto own = stores.openForWorker();
    if (!own)
        return own.error();
    const auto imported = db::importFleet((*own)->database(), file->fleet, half(progress, 1));
    if (!imported)
        return imported.error();
    TransferOutcome outcome;
    outcome.message = importMessage(path, *imported);
    for (const auto& warning : file->warnings)
        outcome.warnings += toText(warning);
    for (const auto& warning : imported->warnings)
        outcome.warnings += toText(warning);
    if (imported->swingIds.size() == 1)
        outcome.swing = imported->swingIds.front();
    outcome.fleetChanged = true;
    return outcome;
}

Result<TransferOutcome> exportFile(
    const db::Stores& stores, const std::vector<AircraftId>& aircraft, const QString& path, const Progress& progress)
{
    auto own = stores.openForWorker();
    if (!own)
        return own.error();
    const auto fleet = db::exportFleet((*own)->database(), aircraft, progress);
    if (!fleet)
        return fleet.error();
    if (const auto written = writeWholeFile(path.toStdString(), writeExchange(*fleet)); !written)
        return written.error();
    TransferOutcome outcome;
    outcome.message = TransferWords::tr("%1: swings exported: %2.").arg(path).arg(fleet->swings.size());
    return outcome;
}

} // namespace

Transfer importing(const db::Stores& stores, const QString& path, const CsvParticulars& particulars)
{
    return [&stores, path, particulars](const Progress& progress) { return importFile(stores, path, particulars, progress); };
}

Transfer exporting(const db::Stores& stores, const std::vector<AircraftId>& aircraft, const QString& path)
{
    return [&stores, aircraft, path](const Progress& progress) { return exportFile(stores, aircraft, path, progress); };
}

Transfer writing(const FileToWrite& file)
{
    return [file](const Progress& progress) -> Result<TransferOutcome> {
        if (const auto written = file.work(progress); !written)
            return written.error();
        TransferOutcome outcome;
        outcome.message = file.success.isEmpty() ? TransferWords::tr("Written: %1").arg(file.path) : file.success;
        outcome.then = file.then;
        return outcome;
    };
}

} // namespace lubberline::ui
