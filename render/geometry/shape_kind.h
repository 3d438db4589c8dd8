// The kinds of shapes that objects have.
#pragma once

#include <cstdint>

namespace carom::render {

/// The kind of an object. All kinds except the last are unit shapes under an affine map, which are
/// described in render/acceleration/shape_list.h.
enum class ShapeKind : std::uint8_t {
    sphere,
    box,
    rectangle,
    triangle,
    disk,
    frustum,
    capsule,
    rounded_box,
    plane,
    mesh,
};

}  // namespace carom::render
