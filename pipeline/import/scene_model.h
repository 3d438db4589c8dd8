// The contents of a scene text, in its author's units and axes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/vectors.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::scene_text {

/// The name of an element and its position in the text.
struct Name {
    std::string text;
    config::Place place;
};

/// An optional number. It is empty if it is missing or -1, where that means the default.
using Real = std::optional<double>;

struct Settings {
    Name name;
    Real width, height, fps;
    Real interpolate_samples, blur_samples, blur_duration, blur_switch_ratio;
    Real dof_samples, dof_c, soft_shadow_samples;
    Real diffuse_reflection_samples, diffuse_refraction_samples, recursion;
};

struct Camera {
    Name name;
    Real video_start, video_end, time_start, time_end;
    Real dof_start, dof_end, fov_start, fov_end;
    std::vector<Vec3> positions, targets;
    std::optional<Vec3> sky_start, sky_end;
};

struct PhongInfo {
    Name name;
    std::optional<Vec3> ambient, diffuse, specular;
    Real shininess, reflectance, diffuse_reflection, refraction, diffuse_refraction,
        refraction_index;
};

struct Texture {
    Name name;
    std::optional<Name> filename;
};

/// `material_phong`, or with a texture `material_texture`.
struct Material {
    Name name;
    std::size_t phong = 0;               // index of the PhongInfo
    std::optional<std::size_t> texture;  // index of the Texture
    Real scale_u, scale_v;
};

struct ForceEvent {
    Vec3 force{0, 0, 0};
    double time = 0;  // s
};

enum class ShapeKind { plane, sphere, triangle, rectangle, box };

struct Object {
    Name name;
    ShapeKind kind = ShapeKind::sphere;
    std::optional<std::size_t> material;  // index of the Material
    bool uses_physics = false;
    bool moves = false;                                   // found by the conversion
    std::optional<Vec3> normal, position, equator, pole;  // equator: `v_e`, pole: `v_n`
    std::array<std::optional<Vec3>, 3> vertices;
    Real radius, height;
    std::vector<ForceEvent> events;
};

enum class LightKind { point, rectangle, bulb };

struct Light {
    Name name;
    LightKind kind = LightKind::point;
    std::optional<Vec3> position, colour, x, y;
    Real radius;
};

struct SceneModel {
    std::optional<Settings> settings;
    std::vector<Camera> cameras;
    std::vector<PhongInfo> phong_infos;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Object> objects;
    std::vector<Light> lights;
};

}  // namespace carom::pipeline::scene_text
