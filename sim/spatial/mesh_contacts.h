// Contacts of a convex solid with triangle surfaces.
#pragma once

#include <vector>

#include "sim/spatial/convex_distance.h"
#include "sim/spatial/static_mesh.h"

namespace carom::sim {

/// Up to four contacts with each plane that the solid touches, with gaps up to `margin` and normals
/// towards the solid. Contacts with edges count only outside of the planes of contacts with flat
/// sides, because the inner edges of a surface support nothing. `bounds`: of the solid, grown by
/// the margin.
[[nodiscard]] std::vector<SurfaceContact> mesh_contacts(const PlacedShape& solid,
                                                        const StaticMesh& mesh, const Aabb& bounds,
                                                        double margin);

}  // namespace carom::sim
