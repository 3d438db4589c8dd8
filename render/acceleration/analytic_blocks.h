// Analytic shapes, eight to a block, one in each lane of a vector.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/acceleration/shapes.h"

namespace carom::render {

inline constexpr int kBlockLanes = 8;

/// A number per lane. Unused lanes hold a shape that no ray meets and the object -1.
struct alignas(32) Lanes {
    float values[kBlockLanes] = {};
};
struct alignas(32) ObjectLanes {
    std::int32_t values[kBlockLanes] = {-1, -1, -1, -1, -1, -1, -1, -1};
};

struct StillSphereBlock {
    Lanes centre[3];
    Lanes radius2;
    ObjectLanes object;
};

struct MovingSphereBlock {
    Lanes path[4][3];  // coefficient, axis
    Lanes path_start;
    Lanes start, end;  // in force while start <= time < end
    Lanes radius2;
    ObjectLanes object;
};

struct AlignedBoxBlock {
    Lanes planes[3][2];  // axis; low, high
    ObjectLanes object;
};

struct MappedBlock {
    Lanes map[4][3];  // rows of unit_from_world, the translation last
    Lanes one_sided;  // 1 or 0
    ObjectLanes object;
};

struct FrustumBlock {
    MappedBlock mapped;
    Lanes middle, slope;
    ObjectLanes object;
};

/// All analytic shapes that stand still or are plain spheres, each kind in order of object.
struct AnalyticBlocks {
    std::vector<StillSphereBlock> still_spheres;
    std::vector<MovingSphereBlock> moving_spheres;
    std::vector<AlignedBoxBlock> boxes;
    std::vector<MappedBlock> mapped_balls;
    std::vector<MappedBlock> mapped_boxes;
    std::vector<MappedBlock> rectangles;
    std::vector<MappedBlock> triangles;
    std::vector<MappedBlock> disks;
    std::vector<FrustumBlock> frustums;
    std::vector<MappedBlock> planes;
};

[[nodiscard]] AnalyticBlocks make_blocks(const ShapeSet& shapes);

}  // namespace carom::render
