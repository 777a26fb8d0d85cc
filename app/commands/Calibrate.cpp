#include "app/Console.h"
#include "app/LogOptions.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/calibration/ModelHeader.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/results/CalibrationJson.h"
#include "ui/report/forms/CalibrationSheets.h"
#include "ui/report/forms/InflightSheets.h"

namespace lubberline::app {

namespace {

struct CalibrateArguments {
    LogArguments log;
    KnownFieldArguments field;
    std::string method = "ellipsoid";
    double attitudeError_deg = 0;
    Output output;
    bool json = false;
};

void printLines(const char* before, const std::vector<Message>& messages)
{
    for (const auto& message : messages)
        put("%s%s\n", before, message.english().c_str());
}

void printParameters(const std::vector<FittedParameter>& parameters)
{
    put("\n%-24s%14s%16s\n", "", "value", "standard error");
    for (const auto& parameter : parameters) {
        const int decimals = parameter.unit == "1" ? 5 : 1;
        const std::string value = parameter.value ? text("%+.*f", decimals, *parameter.value) : "not told";
        const std::string error = parameter.standard_error ? text("%.*f", decimals, *parameter.standard_error) : "-";
        put("%-24s%14s%16s  %s\n", parameter.name.c_str(), value.c_str(), error.c_str(),
            parameter.unit == "1" ? "" : parameter.unit.c_str());
    }
}

void printTable(const EllipsoidResult& result, const SensorLog& log)
{
    put("%s: %s, %zu used; figures in %s (%s)\n", std::string(nameOf(result.verdict)).c_str(),
        counted(static_cast<std::int64_t>(result.samples), "sample").c_str(), result.used, std::string(log.figureUnit()).c_str(),
        log.unitReason.english().c_str());
    printLines("because ", result.reasons);
    printLines("next: ", result.nextSteps);
    if (!result.fit)
        return;
    put("gate %.3f (good up to %.1f), condition %.1f; noise %.1f, field's size to %.1f rms; directions seen %.0f %%, largest hole %.0f deg\n",
        result.fit->gate, kGateGood, result.fit->condition, result.fit->sigma, result.fit->rms, 100 * result.fit->coverage.share,
        result.fit->coverage.largestGap_deg);
    if (result.verdict != CalibrationVerdict::NotDetermined)
        printParameters(result.fit->parameters);
}

/// The field as it is known; without a dip only its size.
SensorSetup setupOf(const SensorModel& model, const KnownFieldArguments& arguments, const KnownField& known, double size, std::string note)
{
    SensorSetup setup;
    setup.model = model;
    setup.note = std::move(note);
    if (arguments.latitude_deg)
        setup.field = PlaceAndDate{{*arguments.latitude_deg, *arguments.longitude_deg, arguments.altitude_m}, arguments.date};
    else if (known.meridian)
        setup.field = *known.meridian;
    else {
        setup.field = TotalField{size};
        setup.note += "; the dip is not known: what rests on it (smith, simulate, map) needs --dip-deg or a place";
    }
    return setup;
}

int writeModel(const CalibrateArguments& options, const SensorSetup& setup, std::string_view unit)
{
    std::string content;
    if (options.output.kind == ".h") {
        const auto header = writeModelHeader(setup.model, unit, setup.note);
        if (!header)
            return fail(header.error());
        content = *header;
    } else {
        content = writeModelJson(setup);
        if (std::holds_alternative<TotalField>(setup.field))
            warn({MARKED("app", "the dip is not known: smith, simulate and map refuse this model until it or a place is stated")});
    }
    if (const auto written = writeWholeFile(options.output.path, content, {options.log.file}); !written)
        return fail(written.error());
    sayWritten(options.output);
    return kDone;
}

EllipsoidShape shapeOf(const std::string& method)
{
    return method == "sphere" ? EllipsoidShape::Sphere : method == "axes" ? EllipsoidShape::Axes : EllipsoidShape::General;
}

void printTable(const AttitudeResult& result, const SensorLog& log)
{
    put("%s: %s, %zu used; figures in nT (%s)\n", std::string(nameOf(result.verdict)).c_str(),
        counted(static_cast<std::int64_t>(result.samples), "sample").c_str(), result.used, log.unitReason.english().c_str());
    printLines("because ", result.reasons);
    printLines("next: ", result.nextSteps);
    printLines("not told: ", result.notSeparable);
    put("rank %d of %d, condition %.1f; scatter %.1f nT an axis, field's size to %.1f nT rms\n", result.rank, result.parametersAsked,
        result.condition, result.sigma_nT, result.rms_nT);
    if (result.validation)
        put("held out, %d sectors of heading: %.2f deg, dip %.2f deg, %.0f nT rms\n", result.validation->blocks,
            result.validation->heading_deg, result.validation->dip_deg, result.validation->field_nT);
    put("mount, if soft iron is symmetric: roll %+.2f, pitch %+.2f, yaw %+.2f deg\n", toDegrees(result.misalignment.roll_rad),
        toDegrees(result.misalignment.pitch_rad), toDegrees(result.misalignment.yaw_rad));
    if (result.verdict != CalibrationVerdict::NotDetermined)
        printParameters(result.parameters);
}

Error inLog(const Error& error, const CalibrateArguments& options) { return {error.code, error.message, nameOfInput(options.log.file)}; }

/// The report; also of a log that tells nothing, with the reasons.
int writeReport(const CalibrateArguments& options, const ui::CalibrationOutcome& outcome, const SensorLog& log, const KnownField& known,
    const std::optional<SensorSetup>& setup)
{
    std::optional<CompensatedLog> compensated;
    if (setup) {
        CompensationOptions how;
        how.field = known.meridian;
        how.uncertainty = setup->uncertainty;
        if (auto made = compensate(log, setup->model, how))
            compensated = std::move(*made);
    }
    const auto session = makeDrawingSession();
    ui::ReferenceSheet sheet = ui::calibrationSheet(outcome, log, compensated ? &*compensated : nullptr, ui::sourceName(options.log.file));
    sheet.madeAtUtc = nowUtc();
    if (const auto written = ui::writeReferenceSheet(sheet, QString::fromStdString(options.output.path)); !written)
        return fail(written.error());
    sayWritten(options.output);
    return kDone;
}

int notDetermined(const CalibrateArguments& options, const std::vector<Message>& reasons)
{
    return fail(inLog({ErrorCode::Numeric, {MARKED("app", "no model is written, as none is determined: %1"), together(reasons)}}, options));
}

int calibrateAttitude(const CalibrateArguments& options, const SensorLog& log, const KnownField& known)
{
    if (!known.meridian)
        return fail({ErrorCode::InvalidInput,
            MARKED("app", "the method attitude needs the field: --field-nT and --dip-deg, or --lat, --lon and --date")});
    const auto result = fitAttitude(log, {*known.meridian, options.attitudeError_deg, known.variation});
    if (!result)
        return fail(inLog(result.error(), options));
    if (!options.json || !options.output.empty()) {
        warn(log.warnings);
        warn(result->warnings);
    }
    if (options.json && !options.output.toStandardOutput())
        put("%s\n", toJson(*result, log, *known.meridian).c_str());
    else if (!options.output.toStandardOutput())
        printTable(*result, log);
    if (options.output.empty())
        return kDone;
    const bool report = options.output.kind == ".pdf";
    if (result->verdict == CalibrationVerdict::NotDetermined)
        return report ? writeReport(options, ui::outcomeOf(*result), log, known, {}) : notDetermined(options, result->reasons);
    std::string note = text("attitude calibration of %zu of %zu samples: %s, rank %d of %d", result->used, result->samples,
        std::string(nameOf(result->verdict)).c_str(), result->rank, result->parametersAsked);
    if (result->rank < result->parametersAsked)
        note += "; what could not be told is 0, and good for the attitudes and the place of the log only";
    SensorSetup setup = setupOf(result->model, options.field, known, known.meridian->total_nT(), note);
    setup.uncertainty = result->uncertainty;
    if (report)
        return writeReport(options, ui::outcomeOf(*result), log, known, setup);
    return writeModel(options, setup, "nT");
}

int calibrateEllipsoid(const CalibrateArguments& options, const SensorLog& log, const KnownField& known)
{
    const EllipsoidShape shape = shapeOf(options.method);
    const EllipsoidResult result = fitEllipsoid(log, shape, known.total_nT);
    if (!options.json || !options.output.empty()) {
        warn(log.warnings);
        warn(result.warnings);
    }
    if (options.json && !options.output.toStandardOutput())
        put("%s\n", toJson(result, log, shape).c_str());
    else if (!options.output.toStandardOutput())
        printTable(result, log);
    if (options.output.empty())
        return kDone;
    const bool report = options.output.kind == ".pdf";
    if (!result.fit || result.verdict == CalibrationVerdict::NotDetermined)
        return report ? writeReport(options, ui::outcomeOf(result), log, known, {}) : notDetermined(options, result.reasons);
    SensorModel model;
    model.softIron = result.fit->softIron;
    model.hardIron_nT = result.fit->hardIron;
    const std::string note = text("%s calibration of %zu of %zu samples: %s, gate %.2f, noise %.1f %s", std::string(nameOf(shape)).c_str(),
        result.used, result.samples, std::string(nameOf(result.verdict)).c_str(), result.fit->gate, result.fit->sigma,
        std::string(log.figureUnit()).c_str());
    SensorSetup setup = setupOf(model, options.field, known, result.fit->field, note);
    setup.uncertainty = result.fit->uncertainty;
    if (report)
        return writeReport(options, ui::outcomeOf(result), log, known, setup);
    return writeModel(options, setup, log.figureUnit());
}

int calibrateCommand(const CalibrateArguments& options)
{
    const auto known = knownField(options.field);
    if (!known)
        return fail(known.error());
    const auto log = readLog(options.log);
    if (!log)
        return fail(log.error());
    return options.method == "attitude" ? calibrateAttitude(options, *log, *known) : calibrateEllipsoid(options, *log, *known);
}

} // namespace

void addCalibrate(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CalibrateArguments>();
    auto* command
        = app.add_subcommand("calibrate", "a sensor model from a log: hard and soft iron, how sure they are, and what to do for better");
    addLogOptions(*command, invocation, options->log);
    addKnownFieldOptions(*command, options->field);
    command
        ->add_option("--method", options->method,
            "ellipsoid (10 parameters), axes (7), sphere (4): by the field's size; attitude: against heading, pitch and roll")
        ->check(CLI::IsMember({"ellipsoid", "axes", "sphere", "attitude"}))
        ->capture_default_str();
    command->add_option("--attitude-error-deg", options->attitudeError_deg, "with attitude: standard deviation of heading, pitch and roll")
        ->check(CLI::Range(0.0, 15.0));
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output,
        "write the model: Model JSON, or a C header with a self-test; or the report", {".json", ".h", ".pdf"});
    command->callback([options, &invocation] { invocation.action = [options] { return calibrateCommand(*options); }; });
}

} // namespace lubberline::app
