// A point of contact of two bodies, and the impulse that acts there.
#pragma once

#include "core/vectors.h"

namespace carom::sim {

/// A point at which two bodies touch, or nearly do.
struct Contact {
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, from the second body towards the first
    double depth = 0;      // m; negative: a gap
};

struct ImpulsePair {
    double normal = 0;      // N s
    double tangential = 0;  // N s
};

}  // namespace carom::sim
