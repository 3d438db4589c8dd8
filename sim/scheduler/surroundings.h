// Everything that does not move.
#pragma once

#include <optional>
#include <string>

#include "sim/billiards/table.h"
#include "sim/world.h"

namespace carom::sim {

/// A level surface that balls slide and roll on.
enum class Ground { none, cloth, pocket_floor, floor };

struct Surroundings {
    explicit Surroundings(const WorldDescription& world);

    Vec3 gravity;
    /// Gravity pulls straight down at this rate; 0 if it does not, and nothing rolls in closed
    /// form.
    double downward_gravity = 0;
    ContactLaw law;
    bool has_cloth = false;
    bool has_cushions = false;
    Vec2 cloth_half_extent{0, 0};  // the cloth lies under |x|, |y| up to these
    double nose_height = 0;
    billiards::TableGeometry table;
    std::optional<double> floor_height;

    [[nodiscard]] bool is_over_cloth(const Vec3& centre) const;
    /// The pocket whose hole lies below `centre`, or -1.
    [[nodiscard]] int pocket_below(const Vec3& centre) const;
};

}  // namespace carom::sim
