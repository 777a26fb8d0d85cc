// What goes out of the page: a model into a file or among those of a compass, and the report.

#include <QFileInfo>
#include <QPushButton>

#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/base/OutputFile.h"
#include "core/calibration/ModelHeader.h"
#include "core/format/exchange/ModelJson.h"
#include "ui/calibration/CalibrationPage.h"
#include "ui/kit/Words.h"
#include "ui/report/forms/CalibrationSheets.h"

namespace lubberline::ui {

/// Its uncertainties and verdict stand in the note, in English whatever the window's language.
void CalibrationPage::store()
{
    if (!m_run || !m_run->model || !m_compass.valid())
        return;
    SensorRecord sensor;
    sensor.compass = m_compass;
    sensor.name = QFileInfo(m_path).completeBaseName().toStdString();
    sensor.origin = ModelOrigin::Loaded;
    sensor.model = *m_run->model;
    sensor.uncertainty = m_run->uncertainty;
    sensor.note = "calibrated from " + QFileInfo(m_path).fileName().toStdString() + ": " + std::string(nameOf(m_run->verdict()));
    const auto& parameters = m_run->ellipsoid ? m_run->ellipsoid->fit->parameters : m_run->attitude->parameters;
    for (const FittedParameter& parameter : parameters)
        if (parameter.standard_error)
            sensor.note += "; " + parameter.name + " \u00B1 "
                + lubberline::figureText(*parameter.standard_error, parameter.unit == "1" ? 5 : 1)
                + (parameter.unit == "1" ? "" : " " + parameter.unit);
    m_store->setEnabled(false); // once
    emit storeModel(sensor);
}

Result<std::string> CalibrationPage::modelText(const QString& path) const
{
    SensorSetup setup;
    setup.model = *m_run->model;
    setup.uncertainty = m_run->uncertainty;
    // In files: the same in every language.
    setup.note = "calibrated from " + QFileInfo(m_path).fileName().toStdString() + ": " + std::string(nameOf(m_run->verdict()));
    if (path.endsWith(QStringLiteral(".h"), Qt::CaseInsensitive))
        return writeModelHeader(setup.model, m_run->part->figureUnit(), setup.note);
    const auto chosen = wish();
    if (!chosen)
        return chosen.error();
    if (const auto dip_deg = chosen->dip_deg) {
        setup.field = MeridianField{m_run->field_nT * std::cos(toRadians(*dip_deg)), m_run->field_nT * std::sin(toRadians(*dip_deg))};
    } else {
        setup.field = TotalField{m_run->field_nT};
        setup.note += "; the dip is not known: what rests on it needs it entered";
    }
    return writeModelJson(setup);
}

void CalibrationPage::save()
{
    if (!m_run || !m_run->model)
        return;
    const QString path = m_questions.save(tr("Save the sensor model"), QFileInfo(m_path).completeBaseName() + QStringLiteral("-model.json"),
        tr("Sensor model (*.json);;C header with a self-test (*.h)"));
    if (path.isEmpty())
        return;
    const auto text = modelText(path);
    const auto written = text ? writeWholeFile(path.toStdString(), *text, {m_path.toStdString()}) : Result<void>(text.error());
    if (!written)
        emit failed(messageOf(written.error()));
}

void CalibrationPage::writeReport()
{
    if (!m_run) {
        refuse(tr("Nothing to write yet: open a log"));
        return;
    }
    const QString path = m_questions.save(
        tr("Write the report"), QFileInfo(m_path).completeBaseName() + QStringLiteral("-calibration.pdf"), tr("PDF (*.pdf)"));
    if (path.isEmpty())
        return;
    ReferenceSheet sheet = calibrationSheet(m_run->ellipsoid ? outcomeOf(*m_run->ellipsoid) : outcomeOf(*m_run->attitude), *m_run->part,
        m_run->compensated ? &*m_run->compensated : nullptr, QFileInfo(m_path).fileName());
    sheet.madeAtUtc = toText(m_stores.clock().nowUtc());
    m_questions.write({path, [sheet, path](const Progress& progress) { return writeReferenceSheet(sheet, path, progress); }});
}

} // namespace lubberline::ui
