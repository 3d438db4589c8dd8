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

/// One-sided: radiates from the side of its normal, from which the camera and reflections see it.
struct RectangleLight {
    static constexpr std::string_view kKind = "rectangle";
    Vec3 centre{0, 0, 1};
    Vec3 edge_u{0.5, 0, 0};  // half edges, orthogonal; the light spans centre +- edge_u +- edge_v
    Vec3 edge_v{0, 0.5, 0};
    Vec3 normal{0, 0, -1};   // unit, orthogonal to both
    Vec3 radiance{1, 1, 1};  // W/(m^2 sr)
    Falloff falloff = Falloff::inverse_square;
};
constexpr auto fields_of(Describes<RectangleLight>) {
    using T = RectangleLight;
    return fields<T>(field("centre", &T::centre), field("edge_u", &T::edge_u),
                     field("edge_v", &T::edge_v), field("normal", &T::normal),
                     field("radiance", &T::radiance), field("falloff", &T::falloff));
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
    return {};
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
                 DirectionalLight>
        light;
};
constexpr auto fields_of(Describes<LightDescription>) {
    using T = LightDescription;
    return fields<T>(unhashed("name", &T::name, "only mattes show it: frame_key adds it for them"),
                     field("light", &T::light));
}

}  // namespace carom::render
