// The contacts of two convex solids: enough points for faces to rest on faces.
#pragma once

#include <vector>

#include "sim/spatial/convex_distance.h"

namespace carom::sim {

struct ConvexContact {
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 0, 1};  // unit, from b towards a
    double depth = 0;      // m; negative: a gap
};

/// Up to four contacts with gaps up to `margin`, all with the same normal; `contacts` is emptied
/// first. The normal is that of the closest points of the cores, or a flat side's where one faces
/// it; the points are what is left of one side clipped to the other (as for two boxes in ODE).
void convex_contacts(const PlacedShape& a, const PlacedShape& b, double margin,
                     std::vector<ConvexContact>& contacts);

/// Leaves up to four points that span most of what all do.
void thin_out(std::vector<ConvexContact>& contacts);

}  // namespace carom::sim
