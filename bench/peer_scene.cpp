#include "bench/peer_scene.h"

#include <fstream>
#include <numbers>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "tests/render/scene_builder.h"

namespace carom::bench {
namespace {

using nlohmann::json;

Vec3 vector(const json& v) {
    return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
}

void add_boxes(const json& from, PeerScene& to) {
    test::SceneBuilder builder;
    for (const auto& [name, material] : from.at("materials").items()) {
        if (material.at("type") == "lambert") {
            render::StandardMaterial surface;
            surface.base = vector(material.at("albedo"));
            builder.material(name, surface);
        }
    }
    for (const json& box : from.at("boxes")) {
        const Vec3 low = vector(box.at("min"));
        const Vec3 high = vector(box.at("max"));
        builder.object(box.at("name").get<std::string>(), render::BoxShape{high - low},
                       (low + high) * 0.5, box.at("material").get<std::string>());
    }
    to.scene = builder.scene;
}

void add_balls(const json& from, double shutter, PeerScene& to) {
    test::SceneBuilder builder{to.scene};
    const double index = from.at("materials").at("ball").at("ior").get<double>();
    for (const json& ball : from.at("balls")) {
        const std::string name = fmt::format("ball {}", ball.at("id").get<int>());
        render::StandardMaterial surface;
        surface.base = vector(ball.at("base_color"));
        surface.coat = {1, index, 0};
        builder.material(name, surface);
        builder.sphere(name, ball.at("radius").get<double>(), Vec3(0, 0, 0), name, name);
        const Vec3 open = vector(ball.at("open"));
        const Vec3 close = vector(ball.at("close"));
        to.tracks.push_back(open == close ? test::resting_track(name, open)
                                          : test::straight_track(name, open, close, 0, shutter));
    }
    to.scene = builder.scene;
}

render::LightDescription light_from(const json& from) {
    if (from.at("type") == "rectangle") {
        render::RectangleLight light;
        light.centre = vector(from.at("center"));
        light.edge_u = vector(from.at("u")) * (from.at("size").at(0).get<double>() / 2);
        light.edge_v = vector(from.at("v")) * (from.at("size").at(1).get<double>() / 2);
        light.normal = vector(from.at("normal"));
        light.radiance = vector(from.at("radiance"));
        return {from.at("name").get<std::string>(), light};
    }
    render::SphereLight light;
    light.centre = vector(from.at("center"));
    light.radius = from.at("radius").get<double>();
    light.radiance = vector(from.at("radiance"));
    return {from.at("name").get<std::string>(), light};
}

}  // namespace

PeerScene read_peer_scene(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        throw std::runtime_error("cannot read '" + path + "'");
    }
    const json from = json::parse(file);
    PeerScene scene;
    const double shutter = from.at("shutter").at("duration").get<double>();
    add_boxes(from, scene);
    add_balls(from, shutter, scene);
    for (const json& light : from.at("lights")) {
        scene.scene.lights.push_back(light_from(light));
    }
    render::EnvironmentLight environment;
    environment.radiance = vector(from.at("environment").at("radiance"));
    scene.scene.lights.push_back({"environment", environment});
    const json& camera = from.at("camera");
    render::CameraState state =
        test::camera(vector(camera.at("position")), vector(camera.at("target")),
                     camera.at("vfov_deg").get<double>() * std::numbers::pi / 180);
    state.focus_distance = camera.at("focus_distance").get<double>();
    state.lens_radius = camera.at("aperture_radius").get<double>();
    scene.frame = test::static_frame(state);
    scene.frame.scene_close = shutter;
    scene.settings = test::small_settings(from.at("film").at("width").get<int>(),
                                          from.at("film").at("height").get<int>(), 16);
    scene.settings.max_bounces = 4;
    return scene;
}

}  // namespace carom::bench
