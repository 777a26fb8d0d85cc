#include "ui/swing/readings/ReadingText.h"

#include <QCoreApplication>

#include <cmath>

#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct ReadingTextTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Readings)
};

std::optional<double> headingIn(const Reading& reading, ReadingColumn column)
{
    switch (column) {
    case ReadingColumn::Nominal: return reading.nominal_deg;
    case ReadingColumn::Magnetic: return reading.magnetic ? std::optional(reading.magnetic->degrees()) : std::nullopt;
    case ReadingColumn::Compass: return reading.compass ? std::optional(reading.compass->degrees()) : std::nullopt;
    default: return std::nullopt;
    }
}

std::optional<double> deviation_deg(const Reading& reading)
{
    if (!reading.complete())
        return std::nullopt;
    return deviationOf(*reading.magnetic, *reading.compass).degrees();
}

/// The shortest decimal text without the noise of binary fractions.
QString exactText(double value) { return QString::number(value, 'g', 10); }

Error wrong(const QString& message) { return {ErrorCode::InvalidInput, said(message)}; }

void setHeading(Reading& reading, ReadingColumn column, std::optional<double> heading_deg)
{
    if (column == ReadingColumn::Nominal)
        reading.nominal_deg = heading_deg;
    else if (column == ReadingColumn::Compass)
        reading.compass = heading_deg ? std::optional(CompassHeading::fromDegrees(*heading_deg)) : std::nullopt;
    else {
        reading.magnetic = heading_deg ? std::optional(MagneticHeading::fromDegrees(*heading_deg)) : std::nullopt;
        reading.trueHeading.reset(); // it said where the magnetic heading came from
    }
}

Result<void> applyTrueHeading(Reading& reading, double heading_deg, std::optional<double> variation_deg)
{
    if (!variation_deg)
        return wrong(ReadingTextTexts::tr("a true heading needs the variation: state it in the particulars of the swing first"));
    reading.trueHeading = TrueHeading::fromDegrees(heading_deg);
    reading.magnetic = toMagnetic(*reading.trueHeading, Variation::fromDegrees(*variation_deg));
    return {};
}

Result<void> applyHeading(Reading& reading, ReadingColumn column, const QString& text, std::optional<double> variation_deg)
{
    if (text.isEmpty()) {
        setHeading(reading, column, std::nullopt);
        return {};
    }
    if (column == ReadingColumn::Magnetic && text == "=") {
        if (!reading.nominal_deg)
            return wrong(ReadingTextTexts::tr("this row has no nominal heading to accept; type the magnetic heading"));
        setHeading(reading, column, reading.nominal_deg);
        return {};
    }
    const auto heading = parseWrittenHeading(text.toStdString());
    if (!heading)
        return heading.error();
    if (column == ReadingColumn::Magnetic && heading->north == North::True)
        return applyTrueHeading(reading, heading->heading_deg, variation_deg);
    const North meant = column == ReadingColumn::Compass ? North::Compass : North::Magnetic;
    const auto heading_deg = parseHeading_deg(text.toStdString(), meant);
    if (!heading_deg)
        return heading_deg.error();
    setHeading(reading, column, *heading_deg);
    return {};
}

Result<void> applyDeviation(Reading& reading, const QString& text)
{
    if (text.isEmpty()) {
        reading.compass.reset();
        return {};
    }
    const auto typed_deg = parseSignedAngle_deg(text.toStdString());
    if (!typed_deg)
        return typed_deg.error();
    if (!reading.magnetic)
        return wrong(ReadingTextTexts::tr("type the magnetic heading first: compass = magnetic − deviation"));
    reading.compass = toCompass(*reading.magnetic, Deviation::fromDegrees(*typed_deg));
    return {};
}

bool fitsOneDecimal(const std::optional<double>& angle_deg)
{
    return !angle_deg || std::abs(*angle_deg * 10.0 - std::round(*angle_deg * 10.0)) < 1e-6;
}

} // namespace

std::optional<double> cellValue_deg(const Reading& reading, ReadingColumn column)
{
    return column == ReadingColumn::Deviation ? deviation_deg(reading) : headingIn(reading, column);
}

QString cellText(const Reading& reading, ReadingColumn column, AngleStyle style, int decimals)
{
    if (column == ReadingColumn::Note)
        return toText(reading.note);
    if (column == ReadingColumn::Deviation) {
        const auto angle_deg = deviation_deg(reading);
        return angle_deg ? toText(formatSignedAngle(*angle_deg, style, decimals)) : QString();
    }
    const auto heading_deg = headingIn(reading, column);
    return heading_deg ? toText(formatHeading(*heading_deg, style, decimals)) : QString();
}

QString editText(const Reading& reading, ReadingColumn column, AngleStyle style)
{
    if (style == AngleStyle::DegreesMinutes || column == ReadingColumn::Note)
        return cellText(reading, column, style, 2);
    const auto value = cellValue_deg(reading, column);
    return value ? exactText(*value) : QString();
}

Result<void> applyTyped(Reading& reading, ReadingColumn column, const QString& text, std::optional<double> variation_deg)
{
    const QString typed = text.trimmed();
    switch (column) {
    case ReadingColumn::Nominal:
    case ReadingColumn::Magnetic:
    case ReadingColumn::Compass: return applyHeading(reading, column, typed, variation_deg);
    case ReadingColumn::Deviation: return applyDeviation(reading, typed);
    case ReadingColumn::Note: reading.note = typed.toStdString(); return {};
    case ReadingColumn::Residual:
    case ReadingColumn::State: break;
    }
    return wrong(ReadingTextTexts::tr("this column is computed; type into magnetic, compass or deviation"));
}

QString editName(ReadingColumn column)
{
    switch (column) {
    case ReadingColumn::Nominal: return ReadingTextTexts::tr("nominal heading");
    case ReadingColumn::Magnetic: return ReadingTextTexts::tr("magnetic heading");
    case ReadingColumn::Compass: return ReadingTextTexts::tr("compass reading");
    case ReadingColumn::Deviation: return ReadingTextTexts::tr("deviation");
    case ReadingColumn::Note: return ReadingTextTexts::tr("note");
    case ReadingColumn::Residual:
    case ReadingColumn::State: break;
    }
    return {};
}

int decimalsFor(const std::vector<Reading>& readings)
{
    for (const Reading& reading : readings)
        for (const auto column : {ReadingColumn::Nominal, ReadingColumn::Magnetic, ReadingColumn::Compass})
            if (!fitsOneDecimal(headingIn(reading, column)))
                return 2;
    return 1;
}

} // namespace lubberline::ui
