// Analytic shapes as Embree's user geometry. For the .cpp files of this folder only.
#pragma once

#include <vector>

#include "render/acceleration/analytic_kernels.h"
#include "render/acceleration/embree_handles.h"
#include "render/acceleration/shape_bounds.h"
#include "render/acceleration/shapes.h"

namespace carom::render {

/// A query's own data behind Embree's context, which must come first.
struct QueryContext {
    RTCIntersectContext embree;
    const Ray* ray = nullptr;          // safe
    Candidate nearest{-1, kNoObject};  // the last hit of a user shape
};

/// One primitive: where it is in the blocks, and its bounds.
struct UserShape {
    enum class Kind {
        still_sphere,
        moving_sphere,
        box,
        mapped_ball,
        mapped_box,
        rectangle,
        triangle,
        disk,
        frustum,
        moving
    };
    Kind kind = Kind::box;
    std::uint32_t index = 0;  // block * lanes + lane; of `moving`: in ShapeSet::moving
    std::uint32_t object = 0;
    MovingBounds bounds;
};

struct UserShapes {
    const AnalyticKernels* kernels = nullptr;
    AnalyticBlocks blocks;
    std::vector<MovingShape> moving;
    std::vector<UserShape> shapes;  // all but infinite planes
};

[[nodiscard]] UserShapes make_user_shapes(const ShapeSet& shapes);

/// One geometry over all of them, committed; `shapes` outlives it and is not moved.
[[nodiscard]] GeometryHandle make_user_geometry(const EmbreeDevice& device,
                                                const UserShapes& shapes);

}  // namespace carom::render
