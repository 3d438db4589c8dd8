// The contacts of a convex solid with triangle surfaces.
#pragma once

#include <vector>

#include "sim/spatial/convex_distance.h"
#include "sim/spatial/static_mesh.h"

namespace carom::sim {

/// Up to four contacts of each plane that it touches, with gaps up to `margin`, normals towards the
/// solid. Contacts with edges count only where no flat side's contact is in their place: the
/// inner edges of a surface hold nobody up. `bounds`: of the solid, grown by the margin.
[[nodiscard]] std::vector<SurfaceContact> mesh_contacts(const PlacedShape& solid,
                                                        const StaticMesh& mesh, const Aabb& bounds,
                                                        double margin);

}  // namespace carom::sim
