#pragma once
/// An iron bench as rows of text that people type: one row for each placement of a part, one for each conductor of a circuit.

#include <QStringList>

#include <vector>

#include "core/base/Result.h"
#include "core/iron/FerrousPart.h"

namespace lubberline::ui {

enum class PartColumn { Name, Shape, Size, Susceptibility, Remanence, Group, State, Centre, Turn, Coercivity };
inline constexpr int kPartColumns = 10;
enum class ConductorColumn { Circuit, Current, On, Kind, Geometry };
inline constexpr int kConductorColumns = 5;

[[nodiscard]] QStringList partHeads();
[[nodiscard]] QStringList conductorHeads();

struct BenchRows {
    QString sensor; ///< "x y z" [m]
    std::vector<QStringList> parts, conductors;
};

[[nodiscard]] BenchRows rowsOf(const IronBench& bench);
/// Rows of the same part (circuit) stand together: an empty name goes on with the one above.
/// Errors: InvalidInput, naming the row and what was expected.
Result<IronBench> benchOf(const BenchRows& rows);

/// What a new row begins with.
[[nodiscard]] QStringList newPart();
[[nodiscard]] QStringList newConductor();

} // namespace lubberline::ui
