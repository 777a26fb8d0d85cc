// How the window reaches the electrical swings of a compass.

#include "ui/electrical/ElectricalPage.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/report/forms/ElectricalSheet.h"

namespace lubberline::ui {

namespace {

void writeRecordFile(PageContext& context, const ElectricalSwing& swing, const CompassSystem& compass)
{
    const auto aircraft = context.stores.fleet.aircraft(compass.aircraft);
    if (!aircraft) {
        context.fail(messageOf(aircraft.error()));
        return;
    }
    const QString stem = ElectricalPage::tr("%1 electrical swing %2").arg(toText(aircraft->registration), toText(swing.date));
    const QString path = context.files.save(
        ElectricalPage::tr("Write the record of the electrical swing"), stem + ".pdf", ElectricalPage::tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    const ElectricalSheet sheet{swing, *aircraft, compass, toText(context.stores.clock().nowUtc())};
    context.files.write({path, [sheet, path](const Progress&) { return writeElectricalSheet(sheet, path); },
        ElectricalPage::tr("Record written: %1").arg(path)});
}

} // namespace

PageDescription ElectricalPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("electrical"), [&context] {
            auto* electrical = new ElectricalPage(context.edits, context.undo, context.today());
            connect(electrical, &ElectricalPage::makeSwing, &context.window, [&context](const Swing& swing) { context.makeSwing(swing); });
            connect(electrical, &ElectricalPage::writeRecord, &context.window,
                [&context](const ElectricalSwing& swing, const CompassSystem& compass) { writeRecordFile(context, swing, compass); });
            return electrical;
        }};
    page.commands = {{MenuId::Swing, 210, tr("&Electrical swings of this compass"), tr("Ctrl+Shift+L"), "electricalSwings",
        [&context](Page& shown) {
            context.go({"electrical", shown.shown().compass});
        },
        needsCompass}};
    page.help = tr(
        "The data sheet of an electrical swing: type what the compass indicates at each selected heading; the errors, what to turn and the verdict follow. "
        "Errors on this sheet are indicated − selected, the negative of the deviation elsewhere in the program.");
    page.outputs = {{MenuId::File, 200, tr("Write the &record…"), {}, "electricalSheet",
        [](Page& shown) { dynamic_cast<ElectricalPage&>(shown).write(); }}};
    return page;
}

Result<void> ElectricalPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<CompassId>(&record);
    return showCompass(id ? *id : CompassId());
}

Plot* ElectricalPage::plot() const { return m_plot; }

} // namespace lubberline::ui
