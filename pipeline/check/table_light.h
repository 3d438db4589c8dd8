// How brightly a table is lit.
#pragma once

#include <array>
#include <string>

#include "pipeline/shot/shot.h"

namespace carom::pipeline {

/// Illuminance, lx, of horizontal surfaces at nine points of a table: the middle of the bed, and
/// the middles and the corners of the rails' tops (of a table without rails: the edges of the bed),
/// each row along x, the first one at the largest y.
struct TableLight {
    std::array<std::array<double, 3>, 3> lux{};

    [[nodiscard]] double least() const;
    [[nodiscard]] double greatest() const;
};

/// Measured by path tracing with small white disks that lie at the points, about half a percent
/// off: with lamps, surroundings, and what the scene reflects and hides, but without all that
/// moves. 1 W/m^2 counts as 179 lx (render/light/light_power.h). Throws Error if the shot has no
/// table, or if a file of the scene cannot be read.
[[nodiscard]] TableLight light_on_table(const Shot& shot);

/// Three lines of three numbers, and a line with the least, the greatest and their ratio.
[[nodiscard]] std::string text_of(const TableLight& light);

}  // namespace carom::pipeline
