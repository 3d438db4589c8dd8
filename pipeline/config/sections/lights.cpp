#include <cmath>

#include "pipeline/config/sections/sections.h"

namespace carom::pipeline::config {

namespace {

using render::LightDescription;

constexpr double kBrightest = 1e9;

/// Half edges of a rectangle that faces `normal`: u level with the floor (x if it faces up or
/// down), turned by `roll` about the normal.
render::RectangleLight rectangle_light(const LightSection& keys) {
    const Vec3 normal = keys.facing / std::sqrt(keys.facing.dot(keys.facing));
    const Vec3 level = Vec3(0, 0, 1).cross(normal);
    const double size = level.dot(level);
    const Vec3 u0 = size < 1e-12 ? Vec3(1, 0, 0) : level / std::sqrt(size);
    const Vec3 v0 = normal.cross(u0);
    const double c = std::cos(keys.roll);
    const double s = std::sin(keys.roll);
    render::RectangleLight light;
    light.centre = keys.at;
    light.edge_u = (u0 * c + v0 * s) * (keys.rectangle->x / 2);
    light.edge_v = (v0 * c - u0 * s) * (keys.rectangle->y / 2);
    light.normal = normal;
    light.radiance = keys.radiance * keys.strength;
    return light;
}

ValueType<EnvironmentSection> environment() {
    const auto image = convert<EnvironmentSection>(file(), [](std::string path) {
        return EnvironmentSection{std::move(path), {}};
    });
    const auto constant =
        convert<EnvironmentSection>(colour(between(0, kBrightest)), [](const Vec3& c) {
            return EnvironmentSection{{}, c};
        });
    const auto is_constant = [](const Node& node) {
        return is_list(node) || is_number(node) || (node.is_scalar() && node.text.starts_with('#'));
    };
    return any_of<EnvironmentSection>({{is_constant, constant}, {is_scalar, image}});
}

/// Keys that mean nothing for this kind of light.
void refuse_keys(Reader& reader, const Node& node, std::string_view kind,
                 const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
        if (const Entry* entry = node.find(key)) {
            reader.error(entry->key_place,
                         "'" + key + "' has no meaning for " + std::string(kind) + " light");
        }
    }
}

void check_kind(Reader& reader, const Node& node, LightSection& keys) {
    if (node.find("sphere") != nullptr) {
        refuse_keys(reader, node, "a sphere", {"facing", "roll", "rotation"});
    } else if (node.find("rectangle") != nullptr) {
        refuse_keys(reader, node, "a rectangle", {"rotation"});
    } else if (node.find("environment") != nullptr) {
        refuse_keys(reader, node, "an environment", {"at", "facing", "roll"});
    }
    if (keys.facing.length() < 1e-9) {
        reader.error(node.find("facing")->value.place, "'facing' must have a length");
        keys.facing = {0, 0, -1};
    }
}

}  // namespace

const MapSpec<LightSection>& light_spec() {
    static const MapSpec<LightSection> spec = [] {
        MapSpec<LightSection> s("light", "A source of light: rectangle, sphere or environment.");
        s.key("rectangle", &LightSection::rectangle,
              vector2(Dimension::length, above_up_to(0, 1000)),
              "its two edges; it radiates to one side");
        s.key("sphere", &LightSection::sphere, length(above_up_to(0, 1000)), "its radius");
        s.key("environment", &LightSection::environment, environment(),
              "light from all around: an equirectangular picture or a colour; one at most");
        s.key("at", &LightSection::at, vector3(Dimension::length),
              "centre of a rectangle or sphere");
        s.key("facing", &LightSection::facing, vector3(Dimension::none),
              "direction in which a rectangle radiates");
        s.key("roll", &LightSection::roll, angle(), "turn of a rectangle about `facing`");
        s.key("rotation", &LightSection::rotation, angle(), "turn of an environment about z");
        s.key("radiance", &LightSection::radiance, colour(between(0, kBrightest)),
              "in W/(m^2 sr); multiplies an environment's picture");
        s.key("strength", &LightSection::strength, number(between(0, kBrightest)),
              "multiplies the radiance");
        s.exactly_one_of({"rectangle", "sphere", "environment"});
        s.check(check_kind);
        return s;
    }();
    return spec;
}

LightDescription to_light(const LightSection& keys) {
    LightDescription result;
    if (keys.rectangle) {
        result.light = rectangle_light(keys);
    } else if (keys.sphere) {
        result.light = render::SphereLight{keys.at, *keys.sphere, keys.radiance * keys.strength};
    } else if (keys.environment) {
        render::EnvironmentLight light;
        light.radiance = keys.radiance * keys.strength;
        light.image = keys.environment->image.value_or(std::string());
        light.rotation = keys.rotation;
        if (keys.environment->radiance) {
            light.radiance = light.radiance * *keys.environment->radiance;
        }
        result.light = light;
    }
    return result;
}

}  // namespace carom::pipeline::config
