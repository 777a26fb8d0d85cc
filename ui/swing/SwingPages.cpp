// How the window reaches the page of a swing, and the commands that act on it.

#include "ui/fleet/RecordEdits.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/swing/NominalLayout.h"
#include "ui/swing/PlotTabs.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingFiles.h"
#include "ui/swing/SwingPage.h"
#include "ui/swing/readings/ReadingsModel.h"

namespace lubberline::ui {

namespace {

/// A command that needs a swing has its page in front.
SwingPage& swingPageOf(Page& shown) { return dynamic_cast<SwingPage&>(shown); }

std::function<void(Page&)> onSwing(void (SwingPage::*act)())
{
    return [act](Page& shown) { (swingPageOf(shown).*act)(); };
}

std::function<void(Page&)> onSwing(PageContext& context, void (*act)(PageContext&, SwingPage&))
{
    return [&context, act](Page& shown) { act(context, swingPageOf(shown)); };
}

void removeDraft(PageContext& context, SwingPage& page)
{
    const SwingRecord record = page.editor().record();
    context.undo.push(new MakeSwing(context.edits, record.swing, MakeSwing::Direction::Remove,
        SwingPage::tr("removal of the swing of %1").arg(toText(record.swing.date))));
    if (!page.editor().id().valid())
        context.go({{}, record.compass.id});
}

SwingPage* makePage(PageContext& context)
{
    auto* page = new SwingPage(context.edits, context.undo);
    QObject::connect(
        &page->editor(), &SwingEditor::notStored, &context.window, [&context, page](int row, const Reading& before, const Reading& wanted) {
            LostReading lost{row, wanted, before.id};
            if (before.id.valid())
                lost.before = before;
            context.keep(page->editor().record(), std::move(lost), page->editor().waits());
        });
    QObject::connect(page, &SwingPage::writeCard, &context.window,
        [&context, page](const CardOptions& options) { writeCardFile(context, *page, options); });
    QObject::connect(page, &SwingPage::openSwing, &context.window, [&context](SwingId id) { context.go({{}, id}); });
    QObject::connect(page, &SwingPage::closed, &context.window, [&context, page] {
        if (page->isVisibleTo(page->window()))
            context.goBack(QStringLiteral("aircraft"));
    });
    return page;
}

std::vector<Command> outputs(PageContext& context)
{
    return {
        {MenuId::File, 200, SwingPage::tr("&Report…"), SwingPage::tr("Ctrl+R"), "report", onSwing(context, writeReportFile), needsSwing},
        {MenuId::File, 210, SwingPage::tr("&Print preview of the report…"), {}, "printReport", onSwing(context, previewReport), needsSwing},
        {MenuId::File, 220, SwingPage::tr("Correction &card, every 30°…"), SwingPage::tr("Ctrl+K"), "card30",
            [&context](Page& shown) { writeCardFile(context, swingPageOf(shown), {30}); }, needsSwing},
        {MenuId::File, 230, SwingPage::tr("Correction card, every &45°…"), SwingPage::tr("Ctrl+Shift+K"), "card45",
            [&context](Page& shown) { writeCardFile(context, swingPageOf(shown), {45}); }, needsSwing},
        {MenuId::File, 240, SwingPage::tr("Print preview of the car&d…"), SwingPage::tr("Ctrl+Shift+P"), "printCard",
            onSwing(context, previewCard), needsSwing},
        {MenuId::File, 235, SwingPage::tr("Correction card on the page, in &other steps"), SwingPage::tr("Ctrl+Alt+K"), "showCard",
            onSwing(&SwingPage::openCard), needsSwing},
        {MenuId::File, 250, SwingPage::tr("&Job card to carry out…"), SwingPage::tr("Ctrl+Alt+J"), "jobCard",
            onSwing(context, writeJobCardFile), needsSwing},
        {MenuId::File, 260, SwingPage::tr("Sheet in DD &1613 style…"), {}, "sheet1613", onSwing(context, write1613File), needsSwing},
    };
}

std::vector<Command> readingCommands()
{
    std::vector<Command> commands;
    for (const int points : kLayoutPoints)
        commands.push_back({MenuId::Swing, 300, SwingPage::tr("%1 points, every %2°").arg(points).arg(360.0 / points), {},
            QStringLiteral("layout%1").arg(points), [points](Page& shown) { swingPageOf(shown).layOut(points); }, needsDraft,
            SwingPage::tr("&Lay out nominal headings")});
    commands.push_back({MenuId::Swing, 310, SwingPage::tr("&Accept the nominal heading"), SwingPage::tr("Ctrl+D"), "acceptNominal",
        onSwing(&SwingPage::acceptNominal), needsDraft});
    commands.push_back({MenuId::Swing, 320, SwingPage::tr("&Insert a row above"), SwingPage::tr("Ctrl+Ins"), "insertRow",
        onSwing(&SwingPage::insertRow), needsDraft});
    commands.push_back({MenuId::Swing, 330, SwingPage::tr("&Delete the selected rows"), SwingPage::tr("Ctrl+Del"), "deleteRows",
        onSwing(&SwingPage::deleteRows), needsDraft});
    commands.push_back({MenuId::Swing, 340, SwingPage::tr("&Exclude the reading…"), SwingPage::tr("Ctrl+E"), "exclude",
        onSwing(&SwingPage::toggleExcluded), needsReading});
    return commands;
}

std::vector<Command> stateCommands(PageContext& context)
{
    return {
        {MenuId::Swing, 400, SwingPage::tr("Mark &complete, or open again"), SwingPage::tr("Ctrl+Return"), "complete",
            onSwing(&SwingPage::toggleComplete), needsSwing},
        {MenuId::Swing, 410, SwingPage::tr("&Sign or amend"), SwingPage::tr("Ctrl+Shift+S"), "signSwing", onSwing(&SwingPage::openSigning),
            needsSwing},
        {MenuId::Swing, 420, SwingPage::tr("&Remove this draft swing"), {}, "removeSwing",
            [&context](Page& shown) {
                context.leaveField();
                removeDraft(context, swingPageOf(shown));
            },
            needsDraft},
        {MenuId::Fleet, 160, SwingPage::tr("Go to the &readings"), SwingPage::tr("Ctrl+G"), "focusReadings",
            onSwing(&SwingPage::focusReadings), needsSwing},
        {MenuId::Fleet, 170, SwingPage::tr("Go to the &aircraft of this swing"), SwingPage::tr("Ctrl+U"), "goAircraft",
            [&context](Page& shown) {
                context.go({{}, shown.shown().compass});
            },
            needsSwing},
    };
}

std::vector<Command> plotCommands()
{
    std::vector<Command> commands;
    const QString plots[]
        = {SwingPage::tr("&Polar plot"), SwingPage::tr("&Curve"), SwingPage::tr("&Spectrum"), SwingPage::tr("C&omponents")};
    for (int tab = 0; tab < 4; ++tab)
        commands.push_back({MenuId::View, 100, plots[tab], QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + tab)),
            QStringLiteral("plot%1").arg(tab + 1), [tab](Page& shown) { swingPageOf(shown).plots().setCurrentIndex(tab); }, needsSwing});
    return commands;
}

} // namespace

PageDescription SwingPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("swing"), [&context] { return makePage(context); }};
    page.help = tr(
        "Type the magnetic heading, Enter, the compass reading, Enter: the next row follows. Angles as 3.25, 3.25W, 3°15'W, 3 15 W; decimal point or comma.\n"
        "In the deviation column, W and E (or a sign) give the compass heading. = or Ctrl+D takes the nominal heading as read. Delete empties a cell.\n"
        "A text that is refused stands beside the stored value; Escape puts that back. A click or Enter on a coefficient opens where it comes from.\n"
        "Cells and blocks are copied, cut and pasted as in a spreadsheet (Ctrl+C, X, V), with or without a first row of headings.\n"
        "Ctrl+Z undoes everything, across swings. Ctrl+E leaves a reading out, with a reason that stays on the record.");
    page.outputs = outputs(context);
    page.print = onSwing(context, previewReport);
    for (const auto& commands : {readingCommands(), stateCommands(context), plotCommands()})
        page.commands.insert(page.commands.end(), commands.begin(), commands.end());
    page.shows = [](const FleetItem& item) { return std::holds_alternative<SwingId>(item); };
    return page;
}

Result<void> SwingPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<SwingId>(&record);
    return showSwing(id ? *id : SwingId());
}

bool SwingPage::isOf(const FleetItem& record) const { return record == FleetItem(m_editor->id()); }

Shown SwingPage::shown() const
{
    if (!m_editor->id().valid())
        return {};
    const SwingRecord& record = m_editor->record();
    return {record.aircraft.id, record.compass.id, record.swing.id, m_editor->editable(), rowSelected()};
}

std::vector<FleetItem> SwingPage::path() const
{
    const SwingRecord& record = m_editor->record();
    return {record.type.id, record.aircraft.id, record.compass.id, record.swing.id};
}

QStringList SwingPage::unstored() const { return Page::unstored() + m_model->rejectedTexts(); }

void SwingPage::takeLook(const Page& before)
{
    if (const auto* page = dynamic_cast<const SwingPage*>(&before))
        setLook(page->look());
}

Plot* SwingPage::plot() const { return m_plots->current(); }

} // namespace lubberline::ui
