// Builds small scenes in a line each.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/frame/frame.h"
#include "render/scene/scene_description.h"
#include "sim/timeline/track.h"

namespace carom::test {

inline Mat44 moved_to(const Vec3& position) {
    Mat44 m;
    m.setTranslation(position);
    return m;
}

struct SceneBuilder {
    render::SceneDescription scene;

    SceneBuilder& material(const std::string& name, render::StandardMaterial surface) {
        scene.materials.push_back({name, std::move(surface)});
        return *this;
    }
    SceneBuilder& phong(const std::string& name, render::PhongMaterial surface) {
        scene.materials.push_back({name, {}, std::move(surface)});
        return *this;
    }
    SceneBuilder& diffuse(const std::string& name, double albedo) {
        render::StandardMaterial surface;
        surface.base = Vec3(albedo, albedo, albedo);
        return material(name, surface);
    }
    /// An object with a track is positioned by the track instead of `at`.
    SceneBuilder& object(const std::string& name, render::Shape shape, const Vec3& at,
                         const std::string& surface, const std::string& track = "") {
        scene.objects.push_back(
            {name, std::move(shape), track.empty() ? moved_to(at) : Mat44(), track, surface});
        return *this;
    }
    SceneBuilder& sphere(const std::string& name, double radius, const Vec3& at,
                         const std::string& surface, const std::string& track = "") {
        return object(name, render::SphereShape{radius}, at, surface, track);
    }
    SceneBuilder& environment(double radiance) {
        render::EnvironmentLight light;
        light.radiance = Vec3(radiance, radiance, radiance);
        scene.lights.push_back({"environment", light});
        return *this;
    }
    SceneBuilder& lamp(const Vec3& centre, double half_x, double half_y, double radiance) {
        render::RectangleLight light;
        light.centre = centre;
        light.edge_u = Vec3(half_x, 0, 0);
        light.edge_v = Vec3(0, half_y, 0);
        light.normal = Vec3(0, 0, -1);
        light.radiance = Vec3(radiance, radiance, radiance);
        scene.lights.push_back({"lamp", light});
        return *this;
    }
    SceneBuilder& bulb(const Vec3& centre, double radius, double radiance) {
        render::SphereLight light;
        light.centre = centre;
        light.radius = radius;
        light.radiance = Vec3(radiance, radiance, radiance);
        scene.lights.push_back({"bulb", light});
        return *this;
    }
};

inline render::RenderSettings small_settings(int width, int height, int samples) {
    render::RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.samples = samples;
    settings.filter = render::PixelFilter::box;
    settings.filter_width = 1;
    return settings;
}

inline render::CameraState camera(const Vec3& position, const Vec3& target, double vertical_fov) {
    render::CameraState state;
    state.position = position;
    state.target = target;
    state.vertical_fov = vertical_fov;
    state.focus_distance = (target - position).length();
    if (std::abs((target - position).normalized().z) > 0.99) {
        state.up = Vec3(0, 1, 0);
    }
    return state;
}

inline render::FrameInput static_frame(const render::CameraState& state) {
    render::FrameInput frame;
    frame.camera_open = state;
    frame.camera_close = state;
    frame.seed = 1;
    return frame;
}

/// From one place to another at constant velocity.
inline sim::Track straight_track(const std::string& name, const Vec3& from, const Vec3& to,
                                 double start, double end) {
    const Vec3 velocity = (to - from) / (end - start);
    sim::Key first;
    first.time = start;
    first.position = from;
    first.velocity_in = first.velocity_out = velocity;
    sim::Key last = first;
    last.time = end;
    last.position = to;
    return sim::Track(name, {first, last});
}

inline sim::Track resting_track(const std::string& name, const Vec3& at) {
    sim::Key key;
    key.position = at;
    return sim::Track(name, {key});
}

/// One pixel's channel of the picture: 0 red ... 3 alpha.
inline float pixel(const render::Film& film, int x, int y, int channel) {
    return film.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                          static_cast<std::size_t>(x)) +
                     static_cast<std::size_t>(channel)];
}

inline const std::vector<float>& plane(const render::Film& film, const std::string& name) {
    for (const render::Channel& channel : film.aovs) {
        if (channel.name == name) {
            return channel.values;
        }
    }
    throw std::out_of_range(name);
}

/// Mean of each channel.
inline Vec3 mean_colour(const render::Film& film) {
    Vec3 sum(0, 0, 0);
    for (std::size_t i = 0; i < film.rgba.size(); i += 4) {
        sum += Vec3(film.rgba[i], film.rgba[i + 1], film.rgba[i + 2]);
    }
    return sum / (static_cast<double>(film.rgba.size()) / 4);
}

/// The smallest and the largest mean of a channel.
inline std::pair<double, double> range_of_means(const render::Film& film) {
    const Vec3 mean = mean_colour(film);
    return std::minmax({mean.x, mean.y, mean.z});
}

}  // namespace carom::test
