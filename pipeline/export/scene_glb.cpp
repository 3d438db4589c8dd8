#include "pipeline/export/scene_glb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "pipeline/export/gltf_buffer.h"
#include "pipeline/export/gltf_materials.h"

namespace carom::pipeline {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kNearest = 0.01;       // near plane of cameras, m
constexpr double kWidestSpot = 1.57;    // rad
constexpr double kLumensPerWatt = 683;  // the conversion of Blender and others
const Quat kYUp(std::sqrt(0.5), Vec3(-std::sqrt(0.5), 0, 0));  // the rotation of y_up

/// Converts from Z up to glTF's Y up: a quarter turn about x.
template <class Vector>
Vector y_up(const Vector& v) {
    return {v.x, v.z, -v.y};
}

Quat y_up(const Quat& q) {
    return {q.r, y_up(q.v)};
}

/// Readers keep floats, but far away some keep all digits.
Json list(const Vec3& v) {
    constexpr double kFar = 1'000;  // m
    if (v.length() > kFar) {
        return {v.x, v.y, v.z};
    }
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Four floats x y z w, chosen so that their length is as close to 1 as rounding allows.
std::array<float, 4> floats(const Quat& q) {
    const Quat unit = q.normalized();
    return {static_cast<float>(unit.v.x), static_cast<float>(unit.v.y),
            static_cast<float>(unit.v.z), static_cast<float>(unit.r)};
}

class GlbWriter {
  public:
    GlbWriter(const ExportScene& scene, PictureStore& pictures)
        : scene_(scene), pictures_(pictures) {}

    std::string run() {
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            materials_.push_back(gltf_material(scene_.materials[i], scene_.textures[i], textures_,
                                               pictures_, extensions_));
        }
        for (const ExportPart& part : scene_.parts) {
            add_part(part);
        }
        for (const ExportPart& lamp : scene_.lamps) {
            add_part(lamp);
        }
        for (const ExportCamera& camera : scene_.cameras) {
            add_camera(camera);
        }
        for (const render::LightDescription& light : scene_.lights) {
            add_light(light);
        }
        return glb_container(document(), buffer_.bytes());
    }

  private:
    void add_part(const ExportPart& part) {
        std::vector<float> vertices;
        std::vector<float> normals;
        for (const auto& vertex : part.mesh.vertices) {
            const auto v = y_up(vertex);
            vertices.insert(vertices.end(), {v.x, v.y, v.z});
        }
        for (const auto& normal : part.mesh.normals) {
            const auto n = y_up(normal);
            normals.insert(normals.end(), {n.x, n.y, n.z});
        }
        Json attributes{{"POSITION", buffer_.add(vertices, "VEC3", GltfBuffer::Use::vertices)}};
        if (!normals.empty()) {
            attributes["NORMAL"] = buffer_.add(normals, "VEC3", GltfBuffer::Use::vertices);
        }
        for (std::size_t i = 0; i < part.coordinates.size(); ++i) {
            attributes["TEXCOORD_" + std::to_string(i)] = add_coordinates(part.coordinates[i]);
        }
        Json primitives = Json::array();
        for (const ExportPatch& patch : part.patches) {
            std::vector<std::uint32_t> indices;
            for (std::size_t i = patch.first; i < patch.first + patch.count; ++i) {
                const auto& triangle = part.mesh.triangles[i];
                indices.insert(indices.end(), triangle.begin(), triangle.end());
            }
            primitives.push_back({{"attributes", attributes},
                                  {"indices", buffer_.add_indices(indices)},
                                  {"material", patch.material}});
        }
        meshes_.push_back({{"name", part.name}, {"primitives", std::move(primitives)}});
        if (part.origin == Vec3(0, 0, 0)) {
            add_node({{"name", part.name}, {"mesh", meshes_.size() - 1}}, part.keys);
            return;
        }
        // The mesh is in a node of its own, because its body turns about another point.
        add_node({{"name", part.name}, {"children", {nodes_.size() + 1}}}, part.keys);
        nodes_.push_back({{"name", part.name + " mesh"},
                          {"mesh", meshes_.size() - 1},
                          {"translation", list(y_up(part.origin))}});
        children_.insert(nodes_.size() - 1);
    }

    /// In the file v runs down.
    std::size_t add_coordinates(const std::vector<Imath::V2f>& coordinates) {
        std::vector<float> numbers;
        for (const Imath::V2f& c : coordinates) {
            numbers.insert(numbers.end(), {c.x, 1 - c.y});
        }
        return buffer_.add(numbers, "VEC2", GltfBuffer::Use::vertices);
    }

    /// Adds a camera whose position and orientation follow scene time. glTF cannot animate the
    /// field of view, so the first one is used.
    void add_camera(const ExportCamera& camera) {
        cameras_.push_back({{"name", camera.name},
                            {"type", "perspective"},
                            {"perspective",
                             {{"aspectRatio", scene_.aspect},
                              {"yfov", camera.keys.front().state.vertical_fov},
                              {"znear", kNearest}}}});
        LinearKeys keys;
        for (const ExportCameraKey& key : camera.by_scene_time()) {
            keys.add(key.scene_time, key.state.position, camera_axes(key.state).orientation());
        }
        add_node({{"name", camera.name}, {"camera", cameras_.size() - 1}}, keys, Axes::of_gltf);
    }

    /// Adds lights without an area. Area lights are among the scene's lamps; the environment is
    /// omitted.
    void add_light(const render::LightDescription& light) {
        const Vec3 down(0, 0, -1);
        if (const auto* point = std::get_if<render::PointLight>(&light.light)) {
            add_punctual(light.name, {{"type", "point"}}, point->intensity, point->position, down);
        } else if (const auto* spot = std::get_if<render::SpotLight>(&light.light)) {
            const double outer = std::min(spot->outer_angle, kWidestSpot);
            Json cone{{"innerConeAngle", std::min(spot->inner_angle, 0.999 * outer)},
                      {"outerConeAngle", outer}};
            add_punctual(light.name, {{"type", "spot"}, {"spot", std::move(cone)}}, spot->intensity,
                         spot->position, spot->direction);
        } else if (const auto* sun = std::get_if<render::DirectionalLight>(&light.light)) {
            add_punctual(light.name, {{"type", "directional"}}, sun->irradiance, {0, 0, 0},
                         sun->direction);
        }
    }

    void add_punctual(const std::string& name, Json light, const Vec3& strength,
                      const Vec3& position, const Vec3& direction) {
        const double largest = std::max({1e-12, strength.x, strength.y, strength.z});
        light["name"] = name;
        light["color"] = list(strength / largest);
        light["intensity"] = largest * kLumensPerWatt;
        lights_.push_back(std::move(light));
        extensions_.insert("KHR_lights_punctual");
        Quat turn;
        turn.setRotation(Vec3(0, 0, -1),
                         direction.normalized());  // the light's direction is its -z axis
        LinearKeys keys;
        keys.add(scene_.start_time, position, turn);
        add_node({{"name", name},
                  {"extensions", {{"KHR_lights_punctual", {{"light", lights_.size() - 1}}}}}},
                 keys, Axes::of_gltf);
    }

    /// Whether the node's contents were converted to Y up, or have axes that glTF prescribes.
    enum class Axes { turned, of_gltf };

    /// Times in a file are positive (glTF 2.0, 5.8), so what a cue stick or a motion by keys does
    /// before the scene begins is left out.
    void add_node(Json node, const LinearKeys& all_keys, Axes axes = Axes::turned) {
        const LinearKeys keys = all_keys.from(scene_.start_time);
        const auto turn_of = [&](const Quat& q) {
            return floats(axes == Axes::turned ? y_up(q) : kYUp * q);
        };
        const std::size_t index = nodes_.size();
        const std::array<float, 4> turn = turn_of(keys.orientations.front());
        node["translation"] = list(y_up(keys.positions.front()));
        if (turn != std::array<float, 4>{0, 0, 0, 1}) {
            node["rotation"] = turn;
        }
        nodes_.push_back(std::move(node));
        if (keys.is_constant()) {
            return;
        }
        std::vector<float> times;
        std::vector<float> positions;
        std::vector<float> turns;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            auto time = static_cast<float>(keys.times[i] - scene_.start_time);
            if (!times.empty() && time <= times.back()) {  // equal when rounded to float
                if (!keys.jumps_to(i)) {
                    continue;
                }
                time = std::nextafter(times.back(), std::numeric_limits<float>::infinity());
            }
            times.push_back(time);
            const Vec3 p = y_up(keys.positions[i]);
            positions.insert(positions.end(), {static_cast<float>(p.x), static_cast<float>(p.y),
                                               static_cast<float>(p.z)});
            const std::array<float, 4> q = turn_of(keys.orientations[i]);
            turns.insert(turns.end(), q.begin(), q.end());
        }
        const std::size_t input = buffer_.add(times, "SCALAR", GltfBuffer::Use::keys);
        add_channel(index, "translation", input, positions, "VEC3");
        add_channel(index, "rotation", input, turns, "VEC4");
    }

    void add_channel(std::size_t node, const char* path, std::size_t input,
                     const std::vector<float>& values, const char* type) {
        channels_.push_back(
            {{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
        samplers_.push_back({{"input", input},
                             {"output", buffer_.add(values, type, GltfBuffer::Use::keys)},
                             {"interpolation", "LINEAR"}});
    }

    Json document() {
        Json all = Json::array();
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (!children_.contains(i)) {
                all.push_back(i);
            }
        }
        Json document{{"asset", {{"version", "2.0"}, {"generator", "carom"}}},
                      {"scene", 0},
                      {"scenes", {{{"name", scene_.name}, {"nodes", std::move(all)}}}}};
        const auto add = [&](const char* name, Json values) {
            if (!values.empty()) {
                document[name] = std::move(values);
            }
        };
        add("extensionsUsed", Json(extensions_));
        add("nodes", std::move(nodes_));
        add("cameras", std::move(cameras_));
        add("materials", std::move(materials_));
        add("textures", textures_.textures());
        add("images", textures_.images());
        add("samplers", textures_.samplers());
        add("meshes", std::move(meshes_));
        if (!lights_.empty()) {
            document["extensions"] = {{"KHR_lights_punctual", {{"lights", std::move(lights_)}}}};
        }
        if (!channels_.empty()) {
            Json animation{{"name", "scene"}};
            animation["channels"] = std::move(channels_);
            animation["samplers"] = std::move(samplers_);
            document["animations"] = Json::array({std::move(animation)});
        }
        add("accessors", buffer_.accessors());
        add("bufferViews", buffer_.views());
        document["buffers"] = Json::array({Json{{"byteLength", buffer_.bytes().size()}}});
        return document;
    }

    const ExportScene& scene_;
    PictureStore& pictures_;
    GltfBuffer buffer_;
    std::set<std::string> extensions_;
    GltfTextures textures_{buffer_, pictures_, extensions_};
    std::set<std::size_t> children_;  // nodes below another one
    Json nodes_ = Json::array();
    Json cameras_ = Json::array();
    Json materials_ = Json::array();
    Json meshes_ = Json::array();
    Json lights_ = Json::array();
    Json channels_ = Json::array();
    Json samplers_ = Json::array();
};

}  // namespace

std::string scene_to_glb(const ExportScene& scene, PictureStore& pictures) {
    return GlbWriter(scene, pictures).run();
}

std::string scene_to_glb(const ExportScene& scene) {
    PictureStore pictures;
    return scene_to_glb(scene, pictures);
}

}  // namespace carom::pipeline
