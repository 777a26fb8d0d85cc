#include "core/earth/GeographicModel.h"

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace lubberline {

namespace {

namespace fs = std::filesystem;

constexpr char kName[] = "field";
constexpr char kId[] = "LUBBERL1";               // eight characters that stand in both files
constexpr double kReferenceRadius_m = 6371200.0; // of all WMM and IGRF models (WMM2025 report, section 1.2)

/// A folder of our own that is gone when we are done, whatever happens.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::error_code none;
        for (const fs::path& base : {fs::temp_directory_path(none), fs::path("/dev/shm")}) {
            std::string pattern = (base / "lubberline-field-XXXXXX").string();
            if (mkdtemp(pattern.data())) {
                m_path = pattern;
                return;
            }
        }
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        if (made())
            fs::remove_all(m_path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] bool made() const { return !m_path.empty(); }
    [[nodiscard]] const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

template <class Value>
void put(std::ofstream& file, Value value)
{
    file.write(reinterpret_cast<const char*>(&value), sizeof value);
}

/// N, M, then C by columns of order, then S without its column 0; degree 0 holds nothing.
void putSet(std::ofstream& file, const GaussSet& set, int degree)
{
    put<std::int32_t>(file, degree);
    put<std::int32_t>(file, degree);
    for (int m = 0; m <= degree; ++m)
        for (int n = m; n <= degree; ++n)
            put<double>(file, n == 0 ? 0.0 : set[gaussIndex(n, m)].g);
    for (int m = 1; m <= degree; ++m)
        for (int n = m; n <= degree; ++n)
            put<double>(file, set[gaussIndex(n, m)].h);
}

bool writeMetadata(const fs::path& path, const FieldTable& table)
{
    std::ofstream file(path);
    file << "WMMF-1\nName " << kName << "\nDescription " << table.name << "\nReleaseDate 2026-01-01\n";
    file.precision(17);
    file << "Radius " << kReferenceRadius_m << "\nNumModels " << table.main.size() << "\nEpoch " << table.firstEpoch << "\nDeltaEpoch "
         << table.epochStep << "\nMinTime " << table.firstEpoch << "\nMaxTime " << table.lastYear
         << "\nMinHeight -10000\nMaxHeight 600000\nNormalization schmidt\nByteOrder "
         << (std::endian::native == std::endian::little ? "little" : "big") << "\nID " << kId << "\n";
    file.close();
    return file.good();
}

bool writeCoefficients(const fs::path& path, const FieldTable& table)
{
    std::ofstream file(path, std::ios::binary);
    file.write(kId, 8);
    for (const auto& set : table.main)
        putSet(file, set, table.degree);
    putSet(file, table.change, table.changeDegree);
    file.close();
    return file.good();
}

} // namespace

Result<std::shared_ptr<const GeographicLib::MagneticModel>> geographicModel(const FieldTable& table)
{
    const TemporaryFolder folder;
    if (!folder.made())
        return Error{ErrorCode::Io, "no temporary folder can be made for the magnetic model; expected one that may be written (TMPDIR)"};
    const fs::path metadata = folder.path() / (std::string(kName) + ".wmm"), coefficients = metadata.string() + ".cof";
    if (!writeMetadata(metadata, table) || !writeCoefficients(coefficients, table))
        return Error{ErrorCode::Io, "the magnetic model cannot be written for GeographicLib; the disk may be full", folder.path().string()};
    try {
        return std::make_shared<const GeographicLib::MagneticModel>(kName, folder.path().string());
    } catch (const std::exception& failure) {
        return Error{
            ErrorCode::Io, std::string("GeographicLib does not take the magnetic model: ") + failure.what(), folder.path().string()};
    }
}

} // namespace lubberline
