// The models held against published values, and the edges of what they are valid for.

#include <gtest/gtest.h>

#include <cmath>

#include "core/earth/FieldModel.h"
#include "tests/core/earth/FieldFiles.h"
#include "tests/core/earth/PublishedFields.h"

namespace lubberline::test {
namespace {

FieldAnswer at(const Result<FieldModel>& model, double year, double latitude_deg, double longitude_deg, double height_km)
{
    EXPECT_TRUE(model) << (model ? "" : model.error().message.english());
    const auto place = makePlace(latitude_deg, longitude_deg, height_km * 1000);
    EXPECT_TRUE(place);
    const auto answer = model->evaluate(*place, year);
    EXPECT_TRUE(answer) << (answer ? "" : answer.error().message.english());
    return answer ? *answer : FieldAnswer{};
}

double inclination_deg(const EarthField& field) { return toDegrees(field.inclination_rad()); }

TEST(FieldModel, wmm2025ReportToItsPrintedDigits)
{
    for (const auto& point : kWmm2025Report) {
        const auto answer = at(wmm2025(), point.year, point.latitude_deg, point.longitude_deg, point.height_km);
        EXPECT_NEAR(answer.field.north_nT, point.X_nT, 0.05001);
        EXPECT_NEAR(answer.field.east_nT, point.Y_nT, 0.05001);
        EXPECT_NEAR(answer.field.down_nT, point.Z_nT, 0.05001);
        EXPECT_NEAR(answer.field.horizontal_nT(), point.H_nT, 0.05001);
        EXPECT_NEAR(answer.field.total_nT(), point.F_nT, 0.05001);
        EXPECT_NEAR(inclination_deg(answer.field), point.I_deg, 0.005001);
        EXPECT_NEAR(answer.field.variation().degrees(), point.D_deg, 0.005001);
        EXPECT_NEAR(answer.rate.north_nT, point.Xrate_nT, 0.05001);
        EXPECT_NEAR(answer.rate.east_nT, point.Yrate_nT, 0.05001);
        EXPECT_NEAR(answer.rate.down_nT, point.Zrate_nT, 0.05001);
        EXPECT_NEAR(answer.horizontalRate_nT, point.Hrate_nT, 0.05001);
        EXPECT_NEAR(answer.totalRate_nT, point.Frate_nT, 0.05001);
        EXPECT_NEAR(answer.inclinationRate_deg, point.Irate_deg, 0.005001);
        EXPECT_NEAR(answer.declinationRate_deg, point.Drate_deg, 0.005001);
    }
}

/// Two independent evaluators agree with these points to 1e-3 nT in X, H and F, 1e-6 in Y, 3e-6 in Z, half a printed unit in D
/// and I.
TEST(FieldModel, wmm2025HundredPoints)
{
    for (const auto& point : kWmm2025Points) {
        const auto answer = at(wmm2025(), point.year, point.latitude_deg, point.longitude_deg, point.height_km);
        EXPECT_NEAR(answer.field.north_nT, point.X_nT, 1e-3);
        EXPECT_NEAR(answer.field.east_nT, point.Y_nT, 1e-6);
        EXPECT_NEAR(answer.field.down_nT, point.Z_nT, 3e-6);
        EXPECT_NEAR(answer.field.horizontal_nT(), point.H_nT, 1e-3);
        EXPECT_NEAR(answer.field.total_nT(), point.F_nT, 1e-3);
        EXPECT_NEAR(wrap180(answer.field.variation().degrees() - point.D_deg), 0.0, 0.005001);
        EXPECT_NEAR(inclination_deg(answer.field), point.I_deg, 0.005001);
        EXPECT_NEAR(answer.declinationRate_deg, point.Drate_deg, 1e-5);
        EXPECT_NEAR(answer.inclinationRate_deg, point.Irate_deg, 1e-5);
    }
}

TEST(FieldModel, igrf14AgainstItsAuthorsProgram)
{
    constexpr double kAxis_km = 6378.137, kFlattening = 1 / 298.257223563;
    const FieldModel model = igrf14();
    for (const auto& point : kIgrf14Points) {
        // Geocentric to geodetic by iteration; then the field is turned from the ellipsoid's vertical to the radius.
        const double geocentric = toRadians(90.0 - point.colatitude_deg);
        const double rho = point.radius_km * std::cos(geocentric), z = point.radius_km * std::sin(geocentric),
                     e2 = kFlattening * (2 - kFlattening);
        double latitude = geocentric, height_km = 0;
        for (int i = 0; i < 50; ++i) {
            const double normal = kAxis_km / std::sqrt(1 - e2 * std::pow(std::sin(latitude), 2));
            latitude = std::atan2(z + e2 * normal * std::sin(latitude), rho);
            height_km = std::abs(latitude) < 0.8 ? rho / std::cos(latitude) - normal : z / std::sin(latitude) - normal * (1 - e2);
        }
        // Up to 1000 km and more: not by makePlace(), which keeps to heights of aircraft.
        const auto answer = model.evaluate({toDegrees(latitude), point.longitude_deg, height_km * 1000}, point.year);
        ASSERT_TRUE(answer) << answer.error().message.english();
        const EarthField& field = answer->field;
        const double turn = latitude - geocentric, north = field.north_nT * std::cos(turn) - field.down_nT * std::sin(turn);
        EXPECT_NEAR(north, point.X_nT, 0.02);
        EXPECT_NEAR(field.east_nT, point.Y_nT, 0.02);
        EXPECT_NEAR(field.down_nT * std::cos(turn) + field.north_nT * std::sin(turn), point.Z_nT, 0.02);
    }
}

TEST(FieldModel, wmm2020FromAFile)
{
    const CoefficientFile file(wmm2020Cof());
    const auto model = readFieldModel(file.path());
    ASSERT_TRUE(model) << model.error().message.english();
    EXPECT_EQ(model->name(), "WMM2020");
    EXPECT_EQ(model->degree(), 12);
    for (const auto& point : kWmm2020Report) {
        const auto answer = at(model, point.year, point.latitude_deg, point.longitude_deg, point.height_km);
        EXPECT_NEAR(answer.field.north_nT, point.X_nT, 0.05001);
        EXPECT_NEAR(answer.field.east_nT, point.Y_nT, 0.05001);
        EXPECT_NEAR(answer.field.down_nT, point.Z_nT, 0.05001);
        EXPECT_NEAR(answer.field.horizontal_nT(), point.H_nT, 0.05001);
        EXPECT_NEAR(answer.field.total_nT(), point.F_nT, 0.05001);
        EXPECT_NEAR(inclination_deg(answer.field), point.I_deg, 0.005001);
        EXPECT_NEAR(answer.field.variation().degrees(), point.D_deg, 0.005001);
    }
}

TEST(FieldModel, ratesAreTheSlopeInTime)
{
    for (const auto& model : {wmm2025(), igrf14()}) {
        const auto before = at(model, 2026.0, 52, 21, 0), after = at(model, 2027.0, 52, 21, 0);
        EXPECT_NEAR(after.field.north_nT - before.field.north_nT, before.rate.north_nT, 1e-6);
        EXPECT_NEAR(after.field.variation().degrees() - before.field.variation().degrees(), before.declinationRate_deg, 1e-3);
    }
}

TEST(FieldModel, yearsAreNamedWhereADateIsOutside)
{
    const auto says = [](const auto& result, const char* words) {
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(result.error().message.english().find(words), std::string::npos) << result.error().message.english();
    };
    const auto warsaw = *makePlace(52.2, 21.0);
    says(wmm2025().evaluate(warsaw, 2024.99), "from 2025 to 2030");
    says(igrf14().evaluate(warsaw, 1899.9), "from 1900 to 2030");
    says(igrf14().evaluate(warsaw, std::nan("")), "from 1900 to 2030");
    says(defaultFieldModel(2030.01), "WMM2025 is valid from 2025 to 2030 and IGRF-14 from 1900 to 2030");
    EXPECT_EQ(defaultFieldModel(2030.0)->name(), "WMM2025");
    EXPECT_EQ(defaultFieldModel(2025.0)->name(), "WMM2025");
    EXPECT_EQ(defaultFieldModel(2005.0)->name(), "IGRF-14");
    EXPECT_TRUE(wmm2025().evaluate(warsaw, 2030.0));
}

TEST(FieldModel, polesAndLongitudes)
{
    EXPECT_TRUE(std::isfinite(at(wmm2025(), 2026, 90, 0, 0).field.total_nT()));
    EXPECT_TRUE(std::isfinite(at(wmm2025(), 2026, -90, 123, 0).field.variation().degrees()));
    const auto a = at(wmm2025(), 2026, 10, 180, 0).field, b = at(wmm2025(), 2026, 10, 540, 0).field,
               c = at(wmm2025(), 2026, 10, -180, 0).field;
    EXPECT_EQ(a, b);
    EXPECT_EQ(a, c);
    EXPECT_FALSE(makePlace(91, 0));
    EXPECT_FALSE(makePlace(std::nan(""), 0));
    EXPECT_FALSE(makePlace(0, std::nan("")));
    EXPECT_FALSE(makePlace(0, 0, 700'000));
}

TEST(FieldModel, cautionAndBlackout)
{
    // WMM2025's north magnetic dip pole of 2025 lies near 85.8° N, 139° E; Resolute lies in the caution zone.
    const FieldModel model = wmm2025();
    const auto pole = *makePlace(85.8, 139.3);
    ASSERT_TRUE(model.evaluate(pole, 2025.0));
    EXPECT_LT(model.evaluate(pole, 2025.0)->field.horizontal_nT(), kBlackoutHorizontal_nT);
    const auto refused = fieldForCompass(model, pole, 2025.0);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Numeric);
    EXPECT_NE(refused.error().message.english().find("blackout"), std::string::npos);
    const auto resolute = fieldForCompass(model, *makePlace(74.7, -94.9), 2026.0);
    ASSERT_TRUE(resolute);
    ASSERT_EQ(resolute->warnings.size(), 1u);
    EXPECT_NE(resolute->warnings[0].english().find("caution"), std::string::npos);
    EXPECT_TRUE(fieldForCompass(model, *makePlace(52.2, 21.0), 2026.0)->warnings.empty());
}

TEST(FieldModel, uncertaintyOfTheReport)
{
    const auto answer = at(wmm2025(), 2026, 52.2, 21.0, 0);
    ASSERT_TRUE(answer.uncertainty);
    EXPECT_EQ(answer.uncertainty->north_nT, 137);
    EXPECT_EQ(answer.uncertainty->horizontal_nT, 133);
    const double H = answer.field.horizontal_nT();
    EXPECT_NEAR(answer.uncertainty->declination_deg, std::sqrt(0.26 * 0.26 + std::pow(5417 / H, 2)), 1e-12);
    EXPECT_FALSE(at(igrf14(), 2005, 52.2, 21.0, 0).uncertainty);
}

TEST(FieldModel, dates)
{
    EXPECT_DOUBLE_EQ(*decimalYear("2026-01-01"), 2026.0);
    EXPECT_DOUBLE_EQ(*decimalYear("2026-11-23"), 2026 + 326.0 / 365);
    EXPECT_DOUBLE_EQ(*decimalYear("2024-12-31"), 2024 + 365.0 / 366);
    EXPECT_DOUBLE_EQ(*decimalYear("2024-02-29"), 2024 + 59.0 / 366);
    EXPECT_DOUBLE_EQ(*decimalYear("2026.5"), 2026.5);
    for (const char* wrong : {"2023-02-29", "2026-13-01", "yesterday", "", "20261123", "26.5"})
        EXPECT_FALSE(decimalYear(wrong)) << wrong;
}

TEST(FieldStamp, keepsModelPlaceDateAndField)
{
    const auto place = *makePlace(52.2, 21.0, 110);
    const auto stamp = stampField(place, "2026-11-23");
    ASSERT_TRUE(stamp);
    EXPECT_EQ(stamp->model, "WMM2025");
    EXPECT_EQ(stamp->place, place);
    EXPECT_EQ(stamp->date, Date("2026-11-23"));
    EXPECT_EQ(stamp->field, wmm2025().evaluate(place, *decimalYear("2026-11-23"))->field);
    EXPECT_EQ(stampField(place, "2005-06-01")->model, "IGRF-14");
    EXPECT_FALSE(stampField(place, "1899-06-01"));
    EXPECT_FALSE(stampField(*makePlace(85.8, 139.3), "2025-06-01"));
}

TEST(MeridianField, dipAndParts)
{
    const auto field = MeridianField::fromDip(18500, toRadians(67));
    EXPECT_NEAR(field.down_nT, 18500 * std::tan(toRadians(67)), 1e-9);
    EXPECT_NEAR(field.inclination_rad(), toRadians(67), 1e-15);
    EXPECT_NEAR(field.total_nT(), 18500 / std::cos(toRadians(67)), 1e-9);
    EXPECT_EQ((MeridianField{0, 0}).inclination_rad(), 0.0);
    EXPECT_DOUBLE_EQ((EarthField{3, -4, 12}).total_nT(), 13.0);
    EXPECT_LT((EarthField{3, -4, 12}).variation().degrees(), 0.0); // west
}

} // namespace
} // namespace lubberline::test
