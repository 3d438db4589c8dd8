#include "render/acceleration/analytic_blocks.h"

#include <algorithm>

namespace carom::render {
namespace {

/// Lays shapes into the lanes of blocks; `empty` fills the lanes that stay unused.
template <class Block, class Shape, class Put>
std::vector<Block> pack(const std::vector<Shape>& shapes, const Block& empty, const Put& put) {
    std::vector<Block> blocks((shapes.size() + kBlockLanes - 1) / kBlockLanes, empty);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        put(blocks[i / kBlockLanes], static_cast<int>(i % kBlockLanes), shapes[i]);
    }
    return blocks;
}

void fill(Lanes& lanes, float value) {
    std::fill_n(lanes.values, kBlockLanes, value);
}

std::int32_t lane_object(std::uint32_t object) {
    return static_cast<std::int32_t>(object);
}

std::vector<StillSphereBlock> pack_still(const std::vector<SphereStretch>& spheres) {
    StillSphereBlock empty;
    fill(empty.radius2, -1);
    return pack(spheres, empty, [](StillSphereBlock& block, int lane, const SphereStretch& s) {
        for (int axis = 0; axis < 3; ++axis) {
            block.centre[axis].values[lane] = s.path.c[0][axis];
        }
        block.radius2.values[lane] = s.radius * s.radius;
        block.object.values[lane] = lane_object(s.object);
    });
}

std::vector<MovingSphereBlock> pack_moving(const std::vector<SphereStretch>& spheres) {
    MovingSphereBlock empty;
    fill(empty.radius2, -1);
    return pack(spheres, empty, [](MovingSphereBlock& block, int lane, const SphereStretch& s) {
        for (int k = 0; k < 4; ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                block.path[k][axis].values[lane] = s.path.c[k][axis];
            }
        }
        block.path_start.values[lane] = s.path.start;
        block.start.values[lane] = s.start;
        block.end.values[lane] = s.end;
        block.radius2.values[lane] = s.radius * s.radius;
        block.object.values[lane] = lane_object(s.object);
    });
}

std::vector<AlignedBoxBlock> pack_boxes(const std::vector<AlignedBox>& boxes) {
    AlignedBoxBlock empty;  // at infinity, which is no distance that a ray reports
    for (int axis = 0; axis < 3; ++axis) {
        fill(empty.planes[axis][0], kInfinity);
        fill(empty.planes[axis][1], kInfinity);
    }
    return pack(boxes, empty, [](AlignedBoxBlock& block, int lane, const AlignedBox& box) {
        for (int axis = 0; axis < 3; ++axis) {
            block.planes[axis][0].values[lane] = box.low[axis];
            block.planes[axis][1].values[lane] = box.high[axis];
        }
        block.object.values[lane] = lane_object(box.object);
    });
}

/// The whole world at (2, 2, 2), beside every unit shape.
MappedBlock empty_mapped() {
    MappedBlock empty;
    for (int axis = 0; axis < 3; ++axis) {
        fill(empty.map[3][axis], 2);
    }
    return empty;
}

void put_mapped(MappedBlock& block, int lane, const MappedShape& shape) {
    for (int row = 0; row < 3; ++row) {
        for (int axis = 0; axis < 3; ++axis) {
            block.map[row][axis].values[lane] = shape.unit_from_world.linear[row][axis];
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        block.map[3][axis].values[lane] = shape.unit_from_world.translation[axis];
    }
    block.one_sided.values[lane] = shape.one_sided ? 1.f : 0.f;
    block.object.values[lane] = lane_object(shape.object);
}

std::vector<MappedBlock> pack_mapped(const std::vector<MappedShape>& shapes) {
    return pack(shapes, empty_mapped(), put_mapped);
}

std::vector<FrustumBlock> pack_frustums(const std::vector<MappedShape>& shapes) {
    FrustumBlock empty;
    empty.mapped = empty_mapped();
    return pack(shapes, empty, [](FrustumBlock& block, int lane, const MappedShape& shape) {
        put_mapped(block.mapped, lane, shape);
        block.middle.values[lane] = shape.profile.middle;
        block.slope.values[lane] = shape.profile.slope;
        block.object.values[lane] = lane_object(shape.object);
    });
}

}  // namespace

AnalyticBlocks make_blocks(const ShapeSet& shapes) {
    const SpheresByMotion spheres = by_motion(in_object_order(shapes.spheres));
    AnalyticBlocks blocks;
    blocks.still_spheres = pack_still(spheres.still);
    blocks.moving_spheres = pack_moving(spheres.moving);
    blocks.boxes = pack_boxes(in_object_order(shapes.boxes));
    blocks.mapped_balls = pack_mapped(in_object_order(shapes.mapped_balls));
    blocks.mapped_boxes = pack_mapped(in_object_order(shapes.mapped_boxes));
    blocks.rectangles = pack_mapped(in_object_order(shapes.rectangles));
    blocks.triangles = pack_mapped(in_object_order(shapes.triangles));
    blocks.disks = pack_mapped(in_object_order(shapes.disks));
    blocks.frustums = pack_frustums(in_object_order(shapes.frustums));
    blocks.planes = pack_mapped(in_object_order(shapes.planes));
    return blocks;
}

}  // namespace carom::render
