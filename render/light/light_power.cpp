#include "render/light/light_power.h"

#include <numbers>
#include <variant>

#include "render/light/shade_inside.h"

namespace carom::render {

namespace {

constexpr double kPi = std::numbers::pi;

struct Power {
    std::optional<Vec3> operator()(const RectangleLight& light) const {
        const double area = 4 * light.edge_u.length() * light.edge_v.length();
        return light.radiance * (kPi * area);
    }
    std::optional<Vec3> operator()(const DiskLight& light) const {
        return light.radiance * (kPi * kPi * light.radius * light.radius);
    }
    std::optional<Vec3> operator()(const SphereLight& light) const {
        return light.radiance * (4 * kPi * kPi * light.radius * light.radius);
    }
    std::optional<Vec3> operator()(const ShadeLight& light) const {
        return mean_radiance(light) * (kPi * kPi * light.shape.radius * light.shape.radius);
    }
    template <class Other>
    std::optional<Vec3> operator()(const Other& /*without a surface*/) const {
        return std::nullopt;
    }
};

}  // namespace

std::optional<Vec3> power_of(const LightDescription& light) {
    return std::visit(Power{}, light.light);
}

Vec3 mean_radiance(const ShadeLight& light) {
    return shade_inside(light).mean_radiance;
}

}  // namespace carom::render
