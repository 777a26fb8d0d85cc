#pragma once
/// Coefficient files that tests write, whole or damaged.

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "tests/core/earth/Wmm2020.h"

namespace lubberline::test {

/// A file that is gone with this object.
class CoefficientFile {
public:
    explicit CoefficientFile(const std::string& text)
    {
        static int count = 0;
        m_path = std::filesystem::temp_directory_path()
            / ("lubberline-test-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".cof");
        std::ofstream(m_path, std::ios::binary) << text;
    }
    ~CoefficientFile()
    {
        std::error_code ignored;
        std::filesystem::remove(m_path, ignored);
    }
    CoefficientFile(const CoefficientFile&) = delete;
    CoefficientFile& operator=(const CoefficientFile&) = delete;
    [[nodiscard]] std::string path() const { return m_path.string(); }

private:
    std::filesystem::path m_path;
};

inline std::string wmm2020Cof()
{
    std::string text = "    2020.0            WMM-2020        12/10/2019\n";
    char line[128];
    for (const auto& row : kWmm2020) {
        std::snprintf(line, sizeof line, "%3.0f %2.0f %9.1f %9.1f %9.1f %9.1f\n", row[0], row[1], row[2], row[3], row[4], row[5]);
        text += line;
    }
    const std::string nines(48, '9');
    return text + nines + "\n" + nines + "\n";
}

} // namespace lubberline::test
