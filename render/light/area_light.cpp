#include "render/light/area_light.h"

#include <cmath>

#include "core/colour.h"
#include "core/perpendicular.h"
#include "render/geometry/constants.h"
#include "render/light/shade_inside.h"

namespace carom::render {
namespace {

/// Half the edges of a flat surface, or the radii of a disk, and its normal.
struct FlatAxes {
    Vec3 u, v, normal;
};

void set_flat(AreaLight& surface, ShapeKind kind, const FlatAxes& axes, const Vec3& c,
              double beam) {
    const auto& [u, v, n] = axes;
    surface.world_from_unit =
        Mat44(u.x, u.y, u.z, 0, v.x, v.y, v.z, 0, n.x, n.y, n.z, 0, c.x, c.y, c.z, 1);
    AreaLightConstants& made = surface.constants;
    made.kind = kind;
    made.is_one_sided = true;
    made.edge_u = V3f(u);
    made.edge_v = V3f(v);
    made.normal = V3f(n);
    made.beam = static_cast<float>(beam);
}

void set_area(AreaLightConstants& light, float area) {
    light.area = area;
    light.intensity = luminance(light.radiance) * area * (0.5f * light.beam + 1);
}

// A light has a surface if there is such a function for its kind; centre, radiance and falloff are
// set already.
void set_surface(AreaLight& surface, const RectangleLight& light) {
    set_flat(surface, ShapeKind::rectangle, {light.edge_u, light.edge_v, light.normal},
             light.centre, light.beam);
    AreaLightConstants& made = surface.constants;
    made.radius = (made.edge_u + made.edge_v).length();
    set_area(made, 4.0f * made.edge_u.length() * made.edge_v.length());
}

void set_disk(AreaLight& surface, const Vec3& centre, const Vec3& normal, double radius,
              double beam) {
    const Vec3 u = perpendicular(normal) * radius;
    set_flat(surface, ShapeKind::disk, {u, normal.cross(u), normal}, centre, beam);
    AreaLightConstants& made = surface.constants;
    made.radius = static_cast<float>(radius);
    set_area(made, kPi * made.radius * made.radius);
}

void set_surface(AreaLight& surface, const DiskLight& light) {
    set_disk(surface, light.centre, light.normal, light.radius, light.beam);
}

void set_surface(AreaLight& surface, const ShadeLight& light) {
    const ShadeInside inside = shade_inside(light);
    surface.constants.shade = inside.constants;
    surface.constants.radiance = V3f(inside.mean_radiance);
    set_disk(surface, light.centre, light.normal, light.shape.radius, 0);
}

void set_surface(AreaLight& surface, const SphereLight& light) {
    surface.world_from_unit.setScale(Vec3(light.radius));
    for (int axis = 0; axis < 3; ++axis) {
        surface.world_from_unit[3][axis] = light.centre[axis];
    }
    AreaLightConstants& made = surface.constants;
    made.kind = ShapeKind::sphere;
    made.is_round = true;
    made.radius = static_cast<float>(light.radius);
    made.intensity = luminance(made.radiance) * kPi * made.radius * made.radius;
}

}  // namespace

LightBounds bounds_of(const AreaLightConstants& light) {
    LightBounds bounds;
    V3f around = V3f(1, 1, 1) * light.radius;
    if (light.is_one_sided) {
        const auto extent = [&](int axis) {
            return std::abs(light.edge_u[axis]) + std::abs(light.edge_v[axis]);
        };
        around = V3f(extent(0), extent(1), extent(2));
        bounds.axis = light.normal;
        bounds.spread = 0;
    }
    bounds.box = {light.centre - around, light.centre + around};
    bounds.strength = light.intensity;
    return bounds;
}

std::optional<AreaLight> area_light_of(const LightDescription& description) {
    const auto surface_of = [](const auto& light) -> std::optional<AreaLight> {
        AreaLight surface;
        if constexpr (requires { set_surface(surface, light); }) {
            surface.constants.centre = V3f(light.centre);
            surface.constants.radiance = V3f(light.radiance);
            if constexpr (requires { light.falloff; }) {
                surface.constants.has_falloff = light.falloff == Falloff::inverse_square;
            }
            set_surface(surface, light);
            return surface;
        }
        return std::nullopt;
    };
    return std::visit(surface_of, description.light);
}

}  // namespace carom::render
