#include "ui/reference/ReferencePage.h"

#include "core/base/OutputFile.h"
#include "core/format/reference/ReferenceJson.h"
#include "core/format/reference/ScenarioJson.h"
#include "ui/kit/Words.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

void ReferencePage::load()
{
    const QString path = m_files.open(tr("A flight and its heading references"), tr("Scenarios (*.json *.csv);;All files (*)"));
    if (path.isEmpty())
        return;
    const auto scenario = readScenarioFile(path.toStdString());
    scenario ? showScenario(*scenario) : emit failed(messageOf(scenario.error()));
}

void ReferencePage::save()
{
    const QString path
        = m_files.save(tr("Save the scenario"), QStringLiteral("scenario.json"), tr("Scenarios (*.json);;Run as a table (*.csv)"));
    if (path.isEmpty())
        return;
    if (!path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive)) {
        if (const auto written = writeWholeFile(path.toStdString(), writeScenarioJson(m_scenario)); !written)
            emit failed(messageOf(written.error()));
    } else if (m_run) {
        if (const auto written = writeWholeFile(path.toStdString(), toCsv(*m_run)); !written)
            emit failed(messageOf(written.error()));
    }
}

void ReferencePage::writeReport()
{
    if (!m_run)
        return;
    const QString path = m_files.save(tr("Report"), QStringLiteral("heading-references.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    ReferenceSheet sheet;
    sheet.title = tr("Heading references in flight");
    sheet.text = message().split(u'\n');
    sheet.text.prepend(
        tr("Latitude %1°, dip %2°, %3 m/s, %4 s; error is read − magnetic; a share is the run with all less the run without it.")
            .arg(plainNumber(m_scenario.latitude_deg, 1), plainNumber(m_scenario.dip_deg, 1), plainNumber(m_scenario.speed_m_s, 1),
                plainNumber(m_scenario.duration_s, 0)));
    auto picture = std::make_shared<TimePicture>(*m_picture);
    picture->at_s = 0;
    for (const auto& [height_mm, drawn] : {std::pair(95.0, timeDrawing(picture)), std::pair(65.0, gainDrawing(m_scenario))})
        sheet.pictures.push_back({height_mm, [drawn](QPainter& painter, const QRectF& rect) { renderDrawn(painter, rect, drawn); }});
    sheet.table = {tr("Manoeuvres"),
        {{tr("from"), {}, QStringLiteral("s")}, {tr("to"), {}, QStringLiteral("s")}, {tr("turn"), {}, QStringLiteral("°/s")},
            {tr("acceleration"), {}, QStringLiteral("m/s²")}, {tr("climb"), {}, QStringLiteral("m/s")}},
        {}};
    for (const Manoeuvre& one : m_scenario.manoeuvres)
        sheet.table.rows.push_back({{plainNumber(one.from_s, 1), plainNumber(one.to_s, 1), signedNumber(one.turnRate_deg_s, 2),
            signedNumber(one.acceleration_m_s2, 2), signedNumber(one.climb_m_s, 1)}});
    m_files.write({path, [sheet, path](const Progress& progress) { return writeReferenceSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
