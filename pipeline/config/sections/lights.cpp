#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"

namespace carom::pipeline::config {

namespace {

using render::LightDescription;

constexpr double kBrightest = 1e9;

/// Half the edges of a rectangle that faces `normal`: u is parallel to the floor (along x if the
/// rectangle faces up or down) and rotated by `roll` about the normal.
/// An environment light: a picture, a colour or a sky.
struct EnvironmentSection {
    std::optional<std::string> image;
    std::optional<Vec3> radiance;
    std::optional<render::Sky> sky;
};

/// Half angles of a spot's cone, rad.
struct SpotAngles {
    double inner = 0.3;
    double outer = 0.4;
};

/// The keys of a light of any kind.
struct LightSection {
    std::optional<Vec3> point, spot, directional;  // intensity, W/sr; irradiance, W/m^2
    SpotAngles angle;
    std::optional<Vec2> rectangle;
    std::optional<double> sphere;
    std::optional<EnvironmentSection> environment;
    Vec3 at{0, 0, 1};
    Vec3 facing{0, 0, -1};
    double roll = 0;
    double rotation = 0;
    Vec3 radiance{1, 1, 1};
    double strength = 1;
    render::Falloff falloff = render::Falloff::inverse_square;
};

render::RectangleLight rectangle_light(const LightSection& keys) {
    const Vec3 normal = keys.facing / std::sqrt(keys.facing.dot(keys.facing));
    const Vec3 level = Vec3(0, 0, 1).cross(normal);
    const double size = level.dot(level);
    const Vec3 u0 = size < 1e-12 ? Vec3(1, 0, 0) : level / std::sqrt(size);
    const Vec3 v0 = normal.cross(u0);
    const double c = cosine(keys.roll);
    const double s = sine(keys.roll);
    render::RectangleLight light;
    light.centre = keys.at;
    light.edge_u = (u0 * c + v0 * s) * (keys.rectangle->x / 2);
    light.edge_v = (v0 * c - u0 * s) * (keys.rectangle->y / 2);
    light.normal = normal;
    light.radiance = keys.radiance * keys.strength;
    light.falloff = keys.falloff;
    return light;
}

const MapSpec<render::Sky>& sky_spec() {
    static const MapSpec<render::Sky> spec = [] {
        MapSpec<render::Sky> s("sky",
                               "A clear sky (Preetham, Shirley and Smits 1999) without the disk of "
                               "the sun: add a directional light for the sun.");
        s.key("sun", &render::Sky::sun, vector3(Dimension::none),
              "direction towards the sun, above the horizon");
        s.key("turbidity", &render::Sky::turbidity, number(between(2, 10)),
              "amount of haze: 2 very clear, 3 clear, 6 hazy");
        s.key("ground", &render::Sky::ground, colour(between(0, 1)),
              "albedo of the ground below the horizon");
        s.check([](Reader& reader, const Node& node, render::Sky& sky) {
            if (!(sky.sun.length() > 1e-9) || !(sky.sun.normalized().z > 1e-3)) {
                reader.error(node.find("sun")->value.place, "'sun' must point above the horizon");
                sky.sun = {0, 0, 1};
            }
        });
        return s;
    }();
    return spec;
}

ValueType<EnvironmentSection> environment() {
    const auto image =
        convert<EnvironmentSection>(file(FileKind::environment), [](std::string path) {
            return EnvironmentSection{std::move(path), {}, {}};
        });
    const auto sky = convert<EnvironmentSection>(record(sky_spec()), [](const render::Sky& s) {
        return EnvironmentSection{{}, {}, s};
    });
    const auto constant =
        convert<EnvironmentSection>(colour(between(0, kBrightest)), [](const Vec3& c) {
            return EnvironmentSection{{}, c, {}};
        });
    const auto is_constant = [](const Node& node) {
        return is_list(node) || is_number(node) || (node.is_scalar() && node.text.starts_with('#'));
    };
    return any_of<EnvironmentSection>({{is_constant, constant}, {is_scalar, image}, {is_map, sky}});
}

/// One angle (a hard edge) or two.
ValueType<SpotAngles> spot_angle() {
    const auto one = convert<SpotAngles>(angle(above_up_to(0, std::numbers::pi)), [](double edge) {
        return SpotAngles{edge, edge};
    });
    ValueType<SpotAngles> two = convert<SpotAngles>(
        list_of(angle(between(0, std::numbers::pi)), 2, 2), [](const std::vector<double>& angles) {
            return SpotAngles{angles[0], angles[1]};
        });
    ValueType<SpotAngles> result =
        any_of<SpotAngles>({{is_scalar, one}, {is_list, std::move(two)}});
    result.show = [](const SpotAngles& angles) {
        return "[" + show(angles.inner, Dimension::none) + " rad, " +
               show(angles.outer, Dimension::none) + " rad]";
    };
    return result;
}

void check_directions(Reader& reader, const Node& node, LightSection& keys) {
    if (keys.angle.inner > keys.angle.outer || keys.angle.outer <= 0) {
        reader.error(node.find("angle")->value.place,
                     "the second value of 'angle' must be above 0 and not less than the first");
        keys.angle = {};
    }
    if (keys.facing.length() < 1e-9) {
        reader.error(node.find("facing")->value.place, "'facing' must not be the zero vector");
        keys.facing = {0, 0, -1};
    }
}

const MapSpec<LightSection>& light_spec() {
    static const MapSpec<LightSection> spec = [] {
        MapSpec<LightSection> s(
            "light",
            "A light source. Points, spots and directional lights have no surface: they cast hard "
            "shadows and are invisible except as a dot in smooth balls.");
        const auto strength = colour(between(0, kBrightest));
        const std::vector<std::string> placed{"point", "spot", "rectangle", "sphere"};
        s.key("point", &LightSection::point, strength, "point light: its intensity in W/sr");
        s.key("spot", &LightSection::spot, strength,
              "point light within a cone: its intensity in W/sr");
        s.key("directional", &LightSection::directional, strength,
              "parallel light: irradiance in W/m^2 of a surface that faces it");
        s.key("rectangle", &LightSection::rectangle,
              vector2(Dimension::length, above_up_to(0, 1000)),
              "lengths of the two edges; a rectangle radiates to one side");
        s.key("sphere", &LightSection::sphere, length(above_up_to(0, 1000)),
              "radius of a sphere that radiates");
        s.key("environment", &LightSection::environment, environment(),
              "light from all directions: an equirectangular picture, a colour or a sky. A shot "
              "has at most one");
        s.key("at", &LightSection::at, vector3(Dimension::length),
              "position of a point or spot, or of the centre of a rectangle or sphere")
            .goes_with(placed);
        s.key("facing", &LightSection::facing, vector3(Dimension::none),
              "direction in which a rectangle, a spot or a directional light shines")
            .goes_with({"rectangle", "spot", "directional"});
        s.key("angle", &LightSection::angle, spot_angle(),
              "angle of a spot from its axis: its edge, or [start of the falloff, edge]")
            .goes_with({"spot"});
        s.key("roll", &LightSection::roll, angle(), "rotation of a rectangle about `facing`")
            .goes_with({"rectangle"});
        s.key("rotation", &LightSection::rotation, angle(), "rotation of an environment about z")
            .goes_with({"environment"});
        s.key("radiance", &LightSection::radiance, colour(between(0, kBrightest)),
              "radiance in W/(m^2 sr). It multiplies the picture of an environment")
            .goes_with({"rectangle", "sphere", "environment"});
        s.key("strength", &LightSection::strength, number(between(0, kBrightest)),
              "factor of the radiance");
        s.key("falloff", &LightSection::falloff,
              choice<render::Falloff>({{"inverse_square", render::Falloff::inverse_square},
                                       {"none", render::Falloff::none}}),
              "how the light of a point, spot, rectangle or sphere decreases with distance. With "
              "`none`, each surface that faces the light receives pi times the radiance in W/m^2 "
              "(or the number of a point or spot in W/m^2) at any distance, which no real lamp "
              "does")
            .goes_with(placed);
        s.exactly_one_of({"point", "spot", "directional", "rectangle", "sphere", "environment"});
        s.kinds({"sphere", "rectangle", "environment", "point", "spot", "directional"});
        s.check(check_directions);
        return s;
    }();
    return spec;
}

LightDescription to_light(const LightSection& keys) {
    LightDescription result;
    if (keys.rectangle) {
        result.light = rectangle_light(keys);
    } else if (keys.sphere) {
        result.light =
            render::SphereLight{keys.at, *keys.sphere, keys.radiance * keys.strength, keys.falloff};
    } else if (keys.point) {
        result.light = render::PointLight{keys.at, *keys.point * keys.strength, keys.falloff};
    } else if (keys.spot) {
        result.light =
            render::SpotLight{keys.at,          keys.facing,      *keys.spot * keys.strength,
                              keys.angle.inner, keys.angle.outer, keys.falloff};
    } else if (keys.directional) {
        result.light = render::DirectionalLight{keys.facing, *keys.directional * keys.strength};
    } else if (keys.environment) {
        render::EnvironmentLight light;
        light.radiance = keys.radiance * keys.strength;
        light.image = keys.environment->image.value_or(std::string());
        light.rotation = keys.rotation;
        light.sky = keys.environment->sky;
        if (keys.environment->radiance) {
            light.radiance = light.radiance * *keys.environment->radiance;
        }
        result.light = light;
    }
    return result;
}

}  // namespace

ValueType<std::vector<Named<LightDescription>>> lights() {
    return convert<std::vector<Named<LightDescription>>>(
        named("light", light_spec()), [](const std::vector<Named<LightSection>>& sections) {
            std::vector<Named<LightDescription>> result;
            for (const Named<LightSection>& section : sections) {
                result.push_back({section.name, section.place, to_light(section.value)});
            }
            return result;
        });
}

}  // namespace carom::pipeline::config
