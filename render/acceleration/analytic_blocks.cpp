#include "render/acceleration/analytic_blocks.h"

#include <cmath>

namespace carom::render {

void StaticSphereBlock::set(int lane, const SphereSegment& sphere) {
    for (int axis = 0; axis < 3; ++axis) {
        centre[axis].values[lane] = sphere.path.c[0][axis];
    }
    radius2.values[lane] = sphere.radius * sphere.radius;
}

void MovingSphereBlock::set(int lane, const SphereSegment& sphere) {
    for (int k = 0; k < 4; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            path[k][axis].values[lane] = sphere.path.c[k][axis];
        }
    }
    path_start.values[lane] = sphere.path.start;
    start.values[lane] = sphere.start;
    end.values[lane] = sphere.end;
    radius2.values[lane] = sphere.radius * sphere.radius;
}

SphereSegment MovingSphereBlock::sphere(int lane) const {
    SphereSegment result;
    for (int k = 0; k < 4; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
            result.path.c[k][axis] = path[k][axis].values[lane];
        }
    }
    result.path.start = path_start.values[lane];
    result.start = start.values[lane];
    result.end = end.values[lane];
    result.radius = std::sqrt(radius2.values[lane]);
    result.object = static_cast<std::uint32_t>(object.values[lane]);
    return result;
}

void AlignedBoxBlock::set(int lane, const V3f& low, const V3f& high) {
    for (int axis = 0; axis < 3; ++axis) {
        planes[axis][0].values[lane] = low[axis];
        planes[axis][1].values[lane] = high[axis];
    }
}

void MappedBlock::set_map(int lane, const Affine& unit_from_world) {
    for (int axis = 0; axis < 3; ++axis) {
        for (int row = 0; row < 3; ++row) {
            map[row][axis].values[lane] = unit_from_world.linear[row][axis];
        }
        map[3][axis].values[lane] = unit_from_world.translation[axis];
    }
}

Affine MappedBlock::unit_from_world(int lane) const {
    Affine result;
    for (int axis = 0; axis < 3; ++axis) {
        for (int row = 0; row < 3; ++row) {
            result.linear[row][axis] = map[row][axis].values[lane];
        }
        result.translation[axis] = map[3][axis].values[lane];
    }
    return result;
}

void ParameterBlock::set_parameters(int lane, const V3f& shape_parameters) {
    for (int axis = 0; axis < 3; ++axis) {
        parameters[axis].values[lane] = shape_parameters[axis];
    }
}

V3f ParameterBlock::parameters_of(int lane) const {
    return V3f(parameters[0].values[lane], parameters[1].values[lane], parameters[2].values[lane]);
}

}  // namespace carom::render
