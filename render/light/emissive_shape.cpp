#include "render/light/emissive_shape.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/colour.h"
#include "core/elementary.h"
#include "render/light/scalar_kernels.h"

namespace carom::render {
namespace {

using Kind = EmissiveShapeConstants::Kind;
using scalar::One;

std::optional<Kind> kind_of(const EmissiveShape::Description& shape) {
    switch (shape.kind) {
        case ShapeKind::sphere:
            return shape.is_round ? Kind::sphere : Kind::ellipsoid;
        case ShapeKind::disk:
            return Kind::disk;
        case ShapeKind::frustum:
            return Kind::frustum;
        case ShapeKind::capsule:
        case ShapeKind::rounded_box:
            return Kind::rounded;
        default:
            return std::nullopt;
    }
}

/// By how much the map to the body's axes stretches areas with this unit normal.
double area_scale(const EmissiveShapeConstants& shape, const V3f& normal) {
    const V3f mapped = Affine::normal(normal, shape.unit_from_body);
    return static_cast<double>(shape.volume_scale * mapped.length());
}

/// Mean of area_scale over the normals of a frustum's side, which have this height.
double area_scale_around(const EmissiveShapeConstants& shape, float height) {
    constexpr int kSteps = 64;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const auto angle = scalar::sin_cos_turn<One>((static_cast<float>(i) + 0.5f) / kSteps);
        const float level = std::sqrt(1 - height * height);
        sum += area_scale(shape, V3f(level * angle.cosine, level * angle.sine, height));
    }
    return sum / kSteps;
}

/// Of one part of a surface: its area on the unit shape, and by how much the map stretches it.
struct Part {
    double area = 0;
    double scale = 1;
};

/// Sets what the samples need to know about the parts; returns the area in the body's axes.
double set_parts(std::span<const Part> parts, EmissiveShapeConstants& shape) {
    double total = 0;
    for (const Part& part : parts) {
        total += part.area * part.scale;
    }
    const double facing = shape.is_symmetric ? 2 : 1;
    double sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        sum += parts[i].area * parts[i].scale;
        shape.part_end[i] = static_cast<float>(sum / total);
        shape.part_density[i] = static_cast<float>(facing * parts[i].scale / total);
    }
    for (std::size_t i = parts.size(); i-- > 0;) {  // the last part with an area gets what is left
        shape.part_end[i] = 1;
        if (parts[i].area > 0) {
            break;
        }
    }
    return total;
}

double set_disk(EmissiveShapeConstants& shape) {
    const Part whole{static_cast<double>(kPi), area_scale(shape, V3f(0, 0, 1))};
    return set_parts({&whole, 1}, shape);
}

double set_frustum(EmissiveShapeConstants& shape) {
    const double middle = static_cast<double>(shape.parameters.x);
    const double slope = static_cast<double>(shape.parameters.y);
    shape.is_symmetric = slope == 0;
    const double length = std::sqrt(1 + slope * slope);
    const double pi = static_cast<double>(kPi);
    const double of_caps = area_scale(shape, V3f(0, 0, 1));
    const Part parts[] = {
        {4 * pi * middle * length, area_scale_around(shape, static_cast<float>(-slope / length))},
        {pi * (middle + slope) * (middle + slope), of_caps},
        {pi * (middle - slope) * (middle - slope), of_caps}};
    return set_parts(parts, shape);
}

double set_rounded(EmissiveShapeConstants& shape) {
    shape.is_symmetric = true;
    const double pi = static_cast<double>(kPi);
    // The map of a rounded shape without shear stretches all areas alike.
    const double scale = power(static_cast<double>(shape.volume_scale), 2.0 / 3);
    const double x = static_cast<double>(shape.parameters.x);
    const double y = static_cast<double>(shape.parameters.y);
    const double z = static_cast<double>(shape.parameters.z);
    const Part parts[] = {{4 * pi, scale},     {4 * pi * x, scale}, {4 * pi * y, scale},
                          {4 * pi * z, scale}, {8 * y * z, scale},  {8 * z * x, scale},
                          {8 * x * y, scale}};
    return set_parts(parts, shape);
}

}  // namespace

std::optional<EmissiveShape> EmissiveShape::make(const Description& shape, const V3f& radiance) {
    const std::optional<Kind> kind = kind_of(shape);
    if (!kind) {
        return std::nullopt;
    }
    EmissiveShape result;
    EmissiveShapeConstants& made = result.shape_;
    made.kind = *kind;
    made.radiance = radiance;
    made.unit_from_body = shape.unit_from_body;
    made.body_from_unit = shape.body_from_unit;
    made.volume_scale = std::abs(shape.body_from_unit.linear.determinant());
    made.sphere.centre = shape.body_from_unit.translation;
    made.sphere.radius = shape.radius;
    made.sphere.radiance = radiance;
    made.parameters =
        shape.kind == ShapeKind::capsule ? V3f(0, 0, shape.parameters.x) : shape.parameters;
    double area = 0;
    if (*kind == Kind::sphere || *kind == Kind::ellipsoid) {
        area =
            4 * static_cast<double>(kPi) * power(static_cast<double>(made.volume_scale), 2.0 / 3);
    } else if (*kind == Kind::disk) {
        area = set_disk(made);
    } else if (*kind == Kind::frustum) {
        area = set_frustum(made);
    } else {
        area = set_rounded(made);
    }
    // Seen from all sides a convex body shows a quarter of its area on average (Cauchy), a
    // one-sided flat one half of its front on the side that it faces.
    const float fraction = *kind == Kind::disk ? 0.5f : 0.25f;
    made.importance.centre = shape.body_from_unit.translation;
    made.importance.bounding_radius = shape.bounding_radius;
    made.importance.strength = luminance(radiance) * static_cast<float>(area) * fraction;
    return result;
}

LightBounds EmissiveShape::bounds() const {
    LightBounds bounds;
    const V3f around =
        V3f(1, 1, 1) * (is_round() ? shape_.sphere.radius : shape_.importance.bounding_radius);
    bounds.box = {shape_.importance.centre - around, shape_.importance.centre + around};
    bounds.strength = shape_.importance.strength;
    if (shape_.kind == Kind::disk) {
        bounds.axis = Affine::normal(V3f(0, 0, 1), shape_.unit_from_body).normalized();
        bounds.spread = 0;
        bounds.strength *= 2;  // along its normal it shows all of its area
    }
    return bounds;
}

bool EmissiveShape::is_black() const {
    return !(shape_.importance.strength > 0);
}

}  // namespace carom::render
