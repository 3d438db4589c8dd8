// Lights as plain data, with what can be wrong with them. `fields_of` lists the fields of each in
// the order in which they are hashed (core/fields.h). `kKind` is the key that names the kind in
// shots.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/fields.h"
#include "core/vectors.h"

namespace carom::render {

/// How the light of a lamp decreases with distance. `none` is for looks that physics does not
/// allow: the irradiance that a lamp causes does not depend on the distance. A lamp with a surface
/// gives every surface that faces it the irradiance pi x radiance, any other lamp its strength in
/// W/m^2. Cameras and specular reflections see the lamp with its radiance.
enum class Falloff { inverse_square, none };

/// The key at fault and what is wrong; null: nothing is.
struct LightProblem {
    const char* field = nullptr;
    const char* what = nullptr;
};

/// The problem of a light apart from its brightness.
template <class Light>
[[nodiscard]] LightProblem problem_of(const Light& /*light*/) {
    return {};
}

/// The problem of the directional profile of a flat light.
[[nodiscard]] inline LightProblem problem_of_beam(double beam) {
    return beam >= 0 && beam <= 100 ? LightProblem{}
                                    : LightProblem{"beam", "the exponent is not from 0 to 100"};
}

/// One-sided: radiates from the side of its normal, from which the camera and reflections see it.
struct RectangleLight {
    static constexpr std::string_view kKind = "rectangle";
    Vec3 centre{0, 0, 1};
    Vec3 edge_u{0.5, 0, 0};  // half edges, orthogonal; the light spans centre +- edge_u +- edge_v
    Vec3 edge_v{0, 0.5, 0};
    Vec3 normal{0, 0, -1};  // unit, orthogonal to both
    /// W/(m^2 sr), of a matt light of the same power: with a `beam` n the radiance at an angle from
    /// the normal is (n + 2) / 2 x cosine^n times this.
    Vec3 radiance{1, 1, 1};
    Falloff falloff = Falloff::inverse_square;
    double beam = 0;  // 0: matt, as bright from all sides; [0, 100]
};
constexpr auto fields_of(Describes<RectangleLight>) {
    using T = RectangleLight;
    return fields<T>(field("centre", &T::centre), field("edge_u", &T::edge_u),
                     field("edge_v", &T::edge_v), field("normal", &T::normal),
                     field("radiance", &T::radiance), field("falloff", &T::falloff),
                     field("beam", &T::beam));
}
[[nodiscard]] inline LightProblem problem_of(const RectangleLight& light) {
    constexpr double kLargestSkew = 1e-6;  // cosine between two sides
    const double area = light.edge_u.length() * light.edge_v.length();
    if (!(area > 0 && std::isfinite(area))) {
        return {"rectangle", "the rectangle has no area"};
    }
    const Vec3 u = light.edge_u.normalized();
    const Vec3 v = light.edge_v.normalized();
    const double skew =
        std::max({std::abs(u.dot(v)), std::abs(u.dot(light.normal)), std::abs(v.dot(light.normal)),
                  std::abs(light.normal.length() - 1)});
    if (!(skew < kLargestSkew)) {
        return {"rectangle",
                "edges and normal of the rectangle are not at right angles to each other"};
    }
    return problem_of_beam(light.beam);
}

/// One-sided, as a rectangle.
struct DiskLight {
    static constexpr std::string_view kKind = "disk";
    Vec3 centre{0, 0, 1};
    double radius = 0.1;     // m, > 0
    Vec3 normal{0, 0, -1};   // unit
    Vec3 radiance{1, 1, 1};  // W/(m^2 sr), as that of a rectangle
    Falloff falloff = Falloff::inverse_square;
    double beam = 0;  // as that of a rectangle
};
constexpr auto fields_of(Describes<DiskLight>) {
    using T = DiskLight;
    return fields<T>(field("centre", &T::centre), field("radius", &T::radius),
                     field("normal", &T::normal), field("radiance", &T::radiance),
                     field("falloff", &T::falloff), field("beam", &T::beam));
}
[[nodiscard]] inline LightProblem problem_of(const DiskLight& light) {
    if (!(light.radius > 0 && std::isfinite(light.radius))) {
        return {"disk", "the radius is not above 0"};
    }
    return problem_of_beam(light.beam);
}

/// The inside of a lamp's shade: a convex body of revolution, open at z = 0. The square of its
/// radius is a mixture of a cone's and a paraboloid's, so that rays meet it by a quadratic
/// equation.
struct ShadeShape {
    double radius = 0.2;  // of the opening, m, > 0
    double top_radius = 0.06;
    double height = 0.2;  // m, > 0
    double bulge = 0;     // from a cone, 0, to a bell, 1

    /// The coefficients of 1, z and z^2 of the square of the radius at a height.
    [[nodiscard]] Vec3 squares() const {
        const double slope = (top_radius - radius) / height;
        const double of_bell = slope * (top_radius + radius);
        return {radius * radius, (1 - bulge) * 2 * radius * slope + bulge * of_bell,
                (1 - bulge) * slope * slope};
    }
    [[nodiscard]] double radius_at(double z) const {
        const Vec3 c = squares();
        return std::sqrt(std::max(0.0, c.x + z * (c.y + z * c.z)));
    }
};
constexpr auto fields_of(Describes<ShadeShape>) {
    using T = ShadeShape;
    return fields<T>(field("radius", &T::radius), field("top_radius", &T::top_radius),
                     field("height", &T::height), field("bulge", &T::bulge));
}

/// A lamp in an opaque shade, as its opening shows it: an opal disk in a ceiling inside, and a wall
/// that the disk lights. The ceiling and the wall are matt, and brighter by the light that they
/// send each other. The outside is an object of its own.
struct ShadeLight {
    static constexpr std::string_view kKind = "shade";
    Vec3 centre{0, 0, 1};   // of the opening
    Vec3 normal{0, 0, -1};  // unit, out of the opening
    ShadeShape shape;
    double disk_radius = 0.15;   // m, of the opal disk; at most that of the shade at its depth
    double depth = 0.03;         // m, of the ceiling with the disk from the opening; (0, height]
    Vec3 albedo{0.8, 0.8, 0.8};  // of the inside; [0, 0.99]
    Vec3 radiance{1, 1, 1};      // of the disk, W/(m^2 sr)
};
constexpr auto fields_of(Describes<ShadeLight>) {
    using T = ShadeLight;
    return fields<T>(field("centre", &T::centre), field("normal", &T::normal),
                     field("shape", &T::shape), field("disk_radius", &T::disk_radius),
                     field("depth", &T::depth), field("albedo", &T::albedo),
                     field("radiance", &T::radiance));
}
[[nodiscard]] inline LightProblem problem_of(const ShadeLight& light) {
    const ShadeShape& shape = light.shape;
    const bool has_size = shape.radius > 0 && shape.height > 0 && shape.top_radius >= 0 &&
                          std::isfinite(shape.radius + shape.height + shape.top_radius);
    if (!has_size) {
        return {"shade", "the radius or the height is not above 0"};
    }
    if (!(shape.bulge >= 0 && shape.bulge <= 1)) {
        return {"bulge", "the bulge is not from 0 to 1"};
    }
    if (!(light.depth > 0 && light.depth <= shape.height)) {
        return {"depth", "the disk does not lie between the opening and the top of the shade"};
    }
    if (!(light.disk_radius > 0 &&
          light.disk_radius <= shape.radius_at(light.depth) * (1 + 1e-9))) {
        return {"disk", "the disk does not fit into the shade at its depth"};
    }
    const auto is_albedo = [](double x) { return x >= 0 && x <= 0.99; };
    const bool reflects_less =
        is_albedo(light.albedo.x) && is_albedo(light.albedo.y) && is_albedo(light.albedo.z);
    return reflects_less ? LightProblem{}
                         : LightProblem{"albedo", "the inside's albedo is not from 0 to 0.99"};
}

struct SphereLight {
    static constexpr std::string_view kKind = "sphere";
    Vec3 centre{0, 0, 1};
    double radius = 0.05;  // m, > 0
    Vec3 radiance{1, 1, 1};
    Falloff falloff = Falloff::inverse_square;
};
constexpr auto fields_of(Describes<SphereLight>) {
    using T = SphereLight;
    return fields<T>(field("centre", &T::centre), field("radius", &T::radius),
                     field("radiance", &T::radiance), field("falloff", &T::falloff));
}
[[nodiscard]] inline LightProblem problem_of(const SphereLight& light) {
    const bool has_size = light.radius > 0 && std::isfinite(light.radius);
    return has_size ? LightProblem{} : LightProblem{"sphere", "the radius is not above 0"};
}

/// The clear sky of Preetham, Shirley and Smits 1999 (render/light/sky.h), without the sun itself.
struct Sky {
    Vec3 sun{1, 0, 1};           // direction to the sun, above the horizon
    double turbidity = 3;        // [2, 10]: 2 very clear, 3 clear, 6 hazy
    Vec3 ground{0.2, 0.2, 0.2};  // albedo of everything below the horizon
};
constexpr auto fields_of(Describes<Sky>) {
    return fields<Sky>(field("sun", &Sky::sun), field("turbidity", &Sky::turbidity),
                       field("ground", &Sky::ground));
}

/// Light from infinitely far away in all directions: constant, an equirectangular image (Z up, its
/// centre column towards +x rotated by `rotation` about z) or a sky.
struct EnvironmentLight {
    static constexpr std::string_view kKind = "environment";
    Vec3 radiance{1, 1, 1};  // multiplies the image or sky
    std::string image;       // absolute path; empty: constant, or a sky
    double rotation = 0;     // rad, counter-clockwise seen from above
    std::optional<Sky> sky{};
};
constexpr auto fields_of(Describes<EnvironmentLight>) {
    using T = EnvironmentLight;
    return fields<T>(field("radiance", &T::radiance), file_field("image", &T::image),
                     field("rotation", &T::rotation), field("sky", &T::sky));
}
[[nodiscard]] inline LightProblem problem_of(const EnvironmentLight& light) {
    return std::isfinite(light.rotation) ? LightProblem{}
                                         : LightProblem{"rotation", "the rotation is not a number"};
}

/// Radiates from one point in all directions. It is invisible, also in reflections.
struct PointLight {
    static constexpr std::string_view kKind = "point";
    Vec3 position{0, 0, 1};
    Vec3 intensity{1, 1, 1};  // W/sr; W/m^2 without falloff
    Falloff falloff = Falloff::inverse_square;
};
constexpr auto fields_of(Describes<PointLight>) {
    using T = PointLight;
    return fields<T>(field("position", &T::position), field("intensity", &T::intensity),
                     field("falloff", &T::falloff));
}

/// A point light within a cone: full intensity within the inner angle, none outside the outer one,
/// and a smooth transition between.
struct SpotLight {
    static constexpr std::string_view kKind = "spot";
    Vec3 position{0, 0, 1};
    Vec3 direction{0, 0, -1};  // of the axis
    Vec3 intensity{1, 1, 1};   // W/sr; W/m^2 without falloff
    double inner_angle = 0.3;  // rad, from the axis, [0, outer_angle]
    double outer_angle = 0.4;  // rad, (0, pi]
    Falloff falloff = Falloff::inverse_square;
};
constexpr auto fields_of(Describes<SpotLight>) {
    using T = SpotLight;
    return fields<T>(field("position", &T::position), field("direction", &T::direction),
                     field("intensity", &T::intensity), field("inner_angle", &T::inner_angle),
                     field("outer_angle", &T::outer_angle), field("falloff", &T::falloff));
}
[[nodiscard]] inline LightProblem problem_of(const SpotLight& light) {
    if (!(light.direction.length() > 1e-9)) {
        return {"facing", "the axis has no length"};
    }
    const bool opens = light.inner_angle >= 0 && light.inner_angle <= light.outer_angle &&
                       light.outer_angle > 0 && light.outer_angle <= std::numbers::pi;
    return opens ? LightProblem{}
                 : LightProblem{"angle", "the angles are not 0 <= inner <= outer <= 180 degrees"};
}

/// Parallel light from infinitely far away. It is invisible.
struct DirectionalLight {
    static constexpr std::string_view kKind = "directional";
    Vec3 direction{0, 0, -1};  // in which the light travels
    Vec3 irradiance{1, 1, 1};  // of a surface that faces it, W/m^2
};
constexpr auto fields_of(Describes<DirectionalLight>) {
    using T = DirectionalLight;
    return fields<T>(field("direction", &T::direction), field("irradiance", &T::irradiance));
}
[[nodiscard]] inline LightProblem problem_of(const DirectionalLight& light) {
    return light.direction.length() > 1e-9 ? LightProblem{}
                                           : LightProblem{"facing", "the direction has no length"};
}

struct LightDescription {
    std::string name;
    std::variant<RectangleLight, SphereLight, EnvironmentLight, PointLight, SpotLight,
                 DirectionalLight, DiskLight, ShadeLight>
        light;
};
constexpr auto fields_of(Describes<LightDescription>) {
    using T = LightDescription;
    return fields<T>(unhashed("name", &T::name, "only mattes show it: frame_key adds it for them"),
                     field("light", &T::light));
}

}  // namespace carom::render
