// Analytic shapes in blocks of eight, one in each lane of a vector.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/geometry/affine.h"
#include "render/geometry/ray.h"
#include "render/geometry/rigid_motion.h"

namespace carom::render {

inline constexpr int kBlockLanes = 8;

/// A number per lane.
struct alignas(32) FloatLanes {
    float values[kBlockLanes] = {};

    [[nodiscard]] static constexpr FloatLanes all(float value) {
        return {{value, value, value, value, value, value, value, value}};
    }
};

/// The object in each lane; -1 in lanes that are not in use.
struct alignas(32) ObjectLanes {
    std::int32_t values[kBlockLanes] = {-1, -1, -1, -1, -1, -1, -1, -1};
};

/// A sphere during one segment of its path. The time intervals of a sphere's segments adjoin.
struct SphereSegment {
    PathPiece path;
    float start = -kInfinity;  // valid while start <= time < end
    float end = kInfinity;
    float radius = 1;
    std::uint32_t object = 0;

    [[nodiscard]] bool is_static() const {
        return start == -kInfinity && end == kInfinity && path.is_constant();
    }
};

// By default the lanes of a block hold a shape that no ray hits. `set` fills one lane, except for
// its object, which BlockList::add fills.

struct StaticSphereBlock {
    FloatLanes centre[3];
    FloatLanes radius2 = FloatLanes::all(-1);
    ObjectLanes object;

    void set(int lane, const SphereSegment& sphere);
};

struct MovingSphereBlock {
    FloatLanes path[4][3];  // coefficient, axis
    FloatLanes path_start;
    FloatLanes start, end;  // valid while start <= time < end
    FloatLanes radius2 = FloatLanes::all(-1);
    ObjectLanes object;

    void set(int lane, const SphereSegment& sphere);
    [[nodiscard]] SphereSegment sphere(int lane) const;
};

/// Unused lanes are at infinity, a distance that is never a hit.
struct AlignedBoxBlock {
    FloatLanes planes[3][2] = {
        {FloatLanes::all(kInfinity), FloatLanes::all(kInfinity)},
        {FloatLanes::all(kInfinity), FloatLanes::all(kInfinity)},
        {FloatLanes::all(kInfinity), FloatLanes::all(kInfinity)}};  // axis; low, high
    ObjectLanes object;

    void set(int lane, const V3f& low, const V3f& high);
};

/// A unit shape under an affine map. In unused lanes the map sends every point to infinity.
struct MappedBlock {
    // Rows of unit_from_world; the translation is the last one.
    FloatLanes map[4][3] = {
        {},
        {},
        {},
        {FloatLanes::all(kInfinity), FloatLanes::all(kInfinity), FloatLanes::all(kInfinity)}};
    FloatLanes one_sided;  // rectangles and disks: 1 if rays from below, z < 0, pass; otherwise 0
    ObjectLanes object;

    void set_map(int lane, const Affine& unit_from_world);
    [[nodiscard]] Affine unit_from_world(int lane) const;
    /// Does nothing, because the shape has no parameters (shape_list.h).
    void set_parameters(int /*lane*/, const V3f& /*parameters*/) {}
    [[nodiscard]] V3f parameters_of(int /*lane*/) const { return V3f(0); }
};

/// A MappedBlock for unit shapes with parameters (shape_list.h).
struct ParameterBlock : MappedBlock {
    FloatLanes parameters[3];

    void set_parameters(int lane, const V3f& shape_parameters);
    [[nodiscard]] V3f parameters_of(int lane) const;
};

}  // namespace carom::render
