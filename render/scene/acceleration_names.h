// Names of acceleration structures in shots and on the command line.
#pragma once

#include <array>
#include <string_view>

#include "render/scene/render_settings.h"

namespace carom::render {

struct AccelerationName {
    std::string_view name;
    AccelerationKind kind;
};

inline constexpr std::array<AccelerationName, 13> kAccelerationNames{
    {{"hybrid", AccelerationKind::hybrid},
     {"embree", AccelerationKind::embree},
     {"brute_force", AccelerationKind::brute_force},
     {"grid", AccelerationKind::grid},
     {"octree", AccelerationKind::octree},
     {"kdtree", AccelerationKind::kd_tree},
     {"kdtree_median", AccelerationKind::kd_tree_median},
     {"bsp", AccelerationKind::bsp_tree},
     {"rtree", AccelerationKind::r_tree},
     {"rtree_hilbert", AccelerationKind::r_tree_hilbert},
     {"kay_kajiya", AccelerationKind::slabs},
     {"bvh", AccelerationKind::bvh},
     {"wide_bvh", AccelerationKind::wide_bvh}}};

}  // namespace carom::render
