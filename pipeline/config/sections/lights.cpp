#include <cmath>
#include <numbers>
#include <utility>

#include "core/colour.h"
#include "core/elementary.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/show_quantity.h"
#include "render/light/light_power.h"

namespace carom::pipeline::config {

namespace {

using render::LightDescription;

constexpr double kBrightest = 1e9;

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

struct ShadeSection {
    render::ShadeShape shape;
    std::optional<double> disk;
    double depth = 0.03;
    Vec3 albedo{0.8, 0.8, 0.8};
    std::string material = kShadeMaterial;

    /// The lamp without its place. By default the disk leaves a gap of a tenth of the radius.
    [[nodiscard]] render::ShadeLight light() const {
        render::ShadeLight light;
        light.shape = shape;
        light.depth = depth;
        light.disk_radius = disk.value_or(0.9 * shape.radius_at(depth));
        light.albedo = albedo;
        return light;
    }
};

struct TubeSection {
    double length = 1, radius = 0.008;
    Vec3 along{1, 0, 0};
};

/// The keys of a light of any kind.
struct LightSection {
    std::optional<Vec3> point, spot, directional;  // intensity, W/sr; irradiance, W/m^2
    SpotAngles angle;
    std::optional<Vec2> rectangle, panel;
    std::optional<double> sphere, disk;
    std::optional<ShadeSection> shade;
    std::optional<TubeSection> tube;
    std::optional<double> beam, lumens;
    std::optional<EnvironmentSection> environment;
    Vec3 at{0, 0, 1};
    Vec3 facing{0, 0, -1};
    double roll = 0;
    double rotation = 0;
    Vec3 radiance{1, 1, 1};
    double strength = 1;
    render::Falloff falloff = render::Falloff::inverse_square;
};

Vec3 direction_of(const LightSection& keys) {
    return keys.facing / std::sqrt(keys.facing.dot(keys.facing));
}

/// Half the edges of a rectangle that faces `normal`: u is parallel to the floor (along x if the
/// rectangle faces up or down) and rotated by `roll` about the normal.
render::RectangleLight rectangle_light(const LightSection& keys, const Vec2& edges, double beam) {
    const Vec3 normal = direction_of(keys);
    const Vec3 level = Vec3(0, 0, 1).cross(normal);
    const double size = level.dot(level);
    const Vec3 u0 = size < 1e-12 ? Vec3(1, 0, 0) : level / std::sqrt(size);
    const Vec3 v0 = normal.cross(u0);
    const double c = cosine(keys.roll);
    const double s = sine(keys.roll);
    render::RectangleLight light;
    light.centre = keys.at;
    light.edge_u = (u0 * c + v0 * s) * (edges.x / 2);
    light.edge_v = (v0 * c - u0 * s) * (edges.y / 2);
    light.normal = normal;
    light.radiance = keys.radiance * keys.strength;
    light.falloff = keys.falloff;
    light.beam = beam;
    return light;
}

render::DiskLight disk_light(const LightSection& keys) {
    return {keys.at,      *keys.disk,           direction_of(keys), keys.radiance * keys.strength,
            keys.falloff, keys.beam.value_or(0)};
}

render::ShadeLight shade_light(const LightSection& keys) {
    render::ShadeLight light = keys.shade->light();
    light.centre = keys.at;
    light.normal = direction_of(keys);
    light.radiance = keys.radiance * keys.strength;
    return light;
}

Tube tube_of(const LightSection& keys) {
    return {keys.at, keys.tube->along.normalized(), keys.tube->length, keys.tube->radius,
            keys.radiance * keys.strength};
}

const MapSpec<ShadeSection>& shade_spec() {
    static const MapSpec<ShadeSection> spec = [] {
        MapSpec<ShadeSection> s(
            "shade",
            "A lamp in an opaque shade, as they hang over tables: an opal disk in a ceiling "
            "inside, "
            "around them a matt wall, and an outside of another material. The wall and the ceiling "
            "shine by what the disk and they themselves send them, which is computed once; they "
            "are "
            "sampled as the disk is, through the opening.");
        const auto size = length(above_up_to(0, 100));
        s.key(
            "radius", [](ShadeSection& shade) -> double& { return shade.shape.radius; }, size,
            "inner radius of the opening");
        s.key(
            "top_radius", [](ShadeSection& shade) -> double& { return shade.shape.top_radius; },
            length(between(0, 100)), "inner radius at the top");
        s.key(
            "height", [](ShadeSection& shade) -> double& { return shade.shape.height; }, size,
            "height from the opening to the top");
        s.key(
            "bulge", [](ShadeSection& shade) -> double& { return shade.shape.bulge; },
            number(between(0, 1)), "from a cone, 0, to a bell, 1");
        s.key("disk", &ShadeSection::disk, size,
              "radius of the opal disk. The default is nine tenths of the shade's at its depth");
        s.key("depth", &ShadeSection::depth, size,
              "depth of the disk, and of the ceiling around it, behind the opening");
        s.key("albedo", &ShadeSection::albedo, colour(between(0, 0.99)), "colour of the inside");
        s.key("material", &ShadeSection::material, name_of(ReferenceKind::material),
              "material of the outside");
        s.check([](Reader& reader, const Node& node, ShadeSection& shade) {
            const render::LightProblem problem = problem_of(shade.light());
            if (problem.what != nullptr) {
                const Entry* key = node.find(problem.field);
                reader.error(key != nullptr ? key->value.place : node.place,
                             reader.label() + ": " + problem.what);
                shade = {};
            }
        });
        return s;
    }();
    return spec;
}

const MapSpec<TubeSection>& tube_spec() {
    static const MapSpec<TubeSection> spec = [] {
        MapSpec<TubeSection> s("tube", "A tube with round ends that shines all around.");
        const auto size = length(above_up_to(0, 100));
        s.key("length", &TubeSection::length, size, "length without the ends").required();
        s.key("radius", &TubeSection::radius, size, "radius");
        s.key("along", &TubeSection::along, vector3(Dimension::none), "direction of its axis");
        s.check([](Reader& reader, const Node& node, TubeSection& tube) {
            if (tube.along.length() < 1e-9) {
                reader.error(node.find("along")->value.place,
                             "'along' must not be the zero vector");
                tube.along = {1, 0, 0};
            }
        });
        return s;
    }();
    return spec;
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

/// These and an environment.
std::vector<std::string> with_environment(std::vector<std::string> kinds) {
    kinds.emplace_back("environment");
    return kinds;
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
    if (keys.lumens && !(luminance(keys.radiance) > 0)) {
        reader.error(node.find("radiance")->value.place,
                     "with 'lumens', 'radiance' is the colour of the light and must not be black");
        keys.radiance = {1, 1, 1};
    }
}

const MapSpec<LightSection>& light_spec() {
    static const MapSpec<LightSection> spec = [] {
        MapSpec<LightSection> s(
            "light",
            "A light source. Points, spots and directional lights have no surface: they cast hard "
            "shadows and are invisible except as a dot in smooth balls.");
        const auto strength = colour(between(0, kBrightest));
        const std::vector<std::string> placed{"point", "spot",  "rectangle", "sphere",
                                              "disk",  "panel", "shade",     "tube"};
        const std::vector<std::string> facing{"rectangle", "disk", "panel",
                                              "shade",     "spot", "directional"};
        const std::vector<std::string> shapes{"rectangle", "sphere", "disk",
                                              "panel",     "shade",  "tube"};
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
        s.key("disk", &LightSection::disk, length(above_up_to(0, 1000)),
              "radius of a disk that radiates to one side");
        s.key(
            "panel", &LightSection::panel, vector2(Dimension::length, above_up_to(0, 1000)),
            "lengths of the two edges of an LED panel: a rectangle with a diffuser (`beam` 1) in a "
            "flat housing of the material `lamp_housing`");
        s.key("shade", &LightSection::shade, record(shade_spec()),
              "a lamp in an opaque shade; `at` is the centre of its opening");
        s.key("tube", &LightSection::tube, record(tube_spec()),
              "a fluorescent or LED tube; `at` is its middle");
        s.key("environment", &LightSection::environment, environment(),
              "light from all directions: an equirectangular picture, a colour or a sky. A shot "
              "has at most one");
        s.key("at", &LightSection::at, vector3(Dimension::length),
              "position of a point or spot, or of the centre of a light with a surface")
            .goes_with(placed);
        s.key("facing", &LightSection::facing, vector3(Dimension::none),
              "direction in which the light shines")
            .goes_with(facing);
        s.key("angle", &LightSection::angle, spot_angle(),
              "angle of a spot from its axis: its edge, or [start of the falloff, edge]")
            .goes_with({"spot"});
        s.key("roll", &LightSection::roll, angle(), "rotation of a rectangle about `facing`")
            .goes_with({"rectangle", "panel"});
        s.key("beam", &LightSection::beam, number(between(0, 100)),
              "how narrow the light is: the radiance is that of a matt light of the same power "
              "times (n + 2) / 2 x cosine^n of the angle from `facing`. 0 (an opal diffuser, the "
              "default of a rectangle and a disk), 1 (a satin one, that of a panel), 2 to 4 "
              "(prisms or lenses)")
            .goes_with({"rectangle", "disk", "panel"});
        s.key("rotation", &LightSection::rotation, angle(), "rotation of an environment about z")
            .goes_with({"environment"});
        s.key("radiance", &LightSection::radiance, colour(between(0, kBrightest)),
              "radiance in W/(m^2 sr); of a shade that of its disk. It multiplies the picture of "
              "an environment. With `lumens` it is only the colour")
            .goes_with(with_environment(shapes));
        s.key("lumens", &LightSection::lumens, number(above_up_to(0, kBrightest)),
              "luminous flux of the whole lamp, lm: it decides the radiance. 179 lm count as 1 W; "
              "of a shade it is what leaves the opening")
            .goes_with(shapes);
        s.key("strength", &LightSection::strength, number(between(0, kBrightest)),
              "factor of the radiance");
        s.key("falloff", &LightSection::falloff,
              choice<render::Falloff>({{"inverse_square", render::Falloff::inverse_square},
                                       {"none", render::Falloff::none}}),
              "how the light decreases with distance. With "
              "`none`, each surface that faces the light receives pi times the radiance in W/m^2 "
              "(or the number of a point or spot in W/m^2) at any distance, which no real lamp "
              "does")
            .goes_with({"point", "spot", "rectangle", "sphere", "disk", "panel"});
        const std::vector<std::string> kinds{"sphere", "rectangle",   "environment", "point",
                                             "spot",   "directional", "disk",        "panel",
                                             "shade",  "tube"};
        s.exactly_one_of(kinds);
        s.kinds(kinds);
        s.check(check_directions);
        return s;
    }();
    return spec;
}

/// Lights that are nothing else.
LightDescription to_light(const LightSection& keys) {
    LightDescription result;
    if (keys.rectangle) {
        result.light = rectangle_light(keys, *keys.rectangle, keys.beam.value_or(0));
    } else if (keys.disk) {
        result.light = disk_light(keys);
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

Lamp to_lamp(const LightSection& keys) {
    if (keys.tube) {
        return lamp_of_tube(tube_of(keys));
    }
    if (keys.panel) {
        return lamp_in_housing(rectangle_light(keys, *keys.panel, keys.beam.value_or(1)));
    }
    if (keys.shade) {
        return lamp_in_shade(shade_light(keys), keys.shade->material);
    }
    return {to_light(keys), {}, {}};
}

/// The power, W, for each colour; 0 without a surface, for which there are no lumens.
Vec3 power_of_lamp(const LightSection& keys, const Lamp& lamp) {
    if (keys.tube) {
        const Tube tube = tube_of(keys);
        return tube.radiance * (std::numbers::pi * tube.area());
    }
    return render::power_of(*lamp.light).value_or(Vec3(0, 0, 0));
}

/// The lamp of the keys, with the radiance that the lumens ask for.
Lamp to_bright_lamp(LightSection keys) {
    if (!keys.lumens) {
        return to_lamp(keys);
    }
    const double strength = std::exchange(keys.strength, 1);
    const double watts = luminance(power_of_lamp(keys, to_lamp(keys)));
    keys.strength =
        watts > 0 ? strength * *keys.lumens / (render::kLumensPerWatt * watts) : strength;
    return to_lamp(keys);
}

}  // namespace

ValueType<std::vector<Named<Lamp>>> lights() {
    return convert<std::vector<Named<Lamp>>>(
        named("light", light_spec()), [](const std::vector<Named<LightSection>>& sections) {
            std::vector<Named<Lamp>> result;
            for (const Named<LightSection>& section : sections) {
                result.push_back({section.name, section.place, to_bright_lamp(section.value)});
            }
            return result;
        });
}

}  // namespace carom::pipeline::config
