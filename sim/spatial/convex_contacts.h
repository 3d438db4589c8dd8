// Contact points of two convex solids, enough of them for faces to rest on faces.
#pragma once

#include <vector>

#include "sim/motion/contact.h"
#include "sim/spatial/convex_distance.h"

namespace carom::sim {

/// Replaces `contacts` by up to four contacts with gaps up to `margin`, all with the same normal,
/// from b towards a. The normal is that of the closest points of the cores, or that of a flat side
/// that faces it. The points are those of one side clipped to the other, as for two boxes in ODE.
void convex_contacts(const PlacedShape& a, const PlacedShape& b, double margin,
                     std::vector<Contact>& contacts);

/// Reduces the contacts to up to four that span most of their area.
void reduce_contacts(std::vector<Contact>& contacts);

}  // namespace carom::sim
