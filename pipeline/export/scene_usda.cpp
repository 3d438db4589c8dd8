#include "pipeline/export/scene_usda.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include <fmt/core.h>

#include "pipeline/export/usda_materials.h"
#include "pipeline/export/usda_text.h"
#include "render/light/light_power.h"

namespace carom::pipeline {

namespace {

constexpr double kTenths = 10;  // USD measures lenses in tenths of the stage's unit, the metre
constexpr double kDegrees = 57.29577951308232;

template <class Range, class Text>
std::string array_of(const Range& values, Text text) {
    std::string result = "[";
    const char* separator = "";
    for (const auto& value : values) {
        result += separator + text(value);
        separator = ", ";
    }
    return result + "]";
}

std::string display_name(const std::string& name) {
    return "displayName = " + usda_string(name);
}

std::string with_schema(const std::string& schema) {
    return "prepend apiSchemas = [\"" + schema + "\"]";
}

std::string index_text(std::uint32_t index) {
    return fmt::format("{}", index);
}

class UsdaWriter {
  public:
    UsdaWriter(const ExportScene& scene, const std::string& path)
        : scene_(scene), assets_(folder_of(path), pictures_of(path)) {}

    UsdaFiles run() {
        write_head();
        text_.open("def Xform \"shot\"", {display_name(scene_.name)});
        write_materials();
        for (const ExportPart& part : scene_.parts) {
            write_part(part);
        }
        for (const ExportCamera& camera : scene_.cameras) {
            write_camera(camera);
        }
        for (const render::LightDescription& light : scene_.lights) {
            write_light(light);
        }
        text_.close();
        return {text_.finish(), assets_.take_files()};
    }

  private:
    static std::string folder_of(const std::string& path) {
        return std::filesystem::path(path).parent_path().string();
    }
    static std::string pictures_of(const std::string& path) {
        const std::string name = std::filesystem::path(path).stem().string();
        return (name.empty() ? "scene" : name) + "_textures";
    }

    [[nodiscard]] double code(double scene_time) const { return scene_time * scene_.fps; }

    void write_head() {
        text_.line("(");
        text_.line("    defaultPrim = \"shot\"");
        text_.line("    metersPerUnit = 1");
        text_.line("    upAxis = \"Z\"");
        text_.line("    timeCodesPerSecond = " + usda_number(scene_.fps));
        text_.line("    framesPerSecond = " + usda_number(scene_.fps));
        text_.line("    startTimeCode = " + usda_number(code(scene_.start_time)));
        text_.line("    endTimeCode = " + usda_number(code(scene_.end_time)));
        text_.line(")");
    }

    void open(const std::string& head, const std::string& name, const char* schema = nullptr) {
        UsdaText::Metadata metadata{display_name(name)};
        if (schema != nullptr) {
            metadata.push_back(with_schema(schema));
        }
        text_.open(head + " \"" + names_.unique(name) + "\"", metadata);
    }

    /// Writes "type name = value", or timeSamples if the value changes. `value(i)` is the text of
    /// key i.
    template <class Value>
    void attribute(const std::string& type_and_name, const std::vector<double>& times,
                   Value value) {
        bool changes = false;
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < times.size(); ++i) {
            texts.push_back(value(i));
            changes = changes || texts.back() != texts.front();
        }
        if (!changes) {
            text_.line(type_and_name + " = " + texts.front());
            return;
        }
        text_.line(type_and_name + ".timeSamples = {");
        double last = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < times.size(); ++i) {
            // Two times that are a number apart, where a track jumps, may give the same code.
            const double at = std::max(code(times[i]), sim::time_after_jump(last));
            text_.line("    " + usda_time_code(at) + ": " + texts[i] + ",");
            last = at;
        }
        text_.line("}");
    }

    /// `origin`: of what is below, in axes that the keys move.
    void write_keys(const LinearKeys& keys, const Vec3& origin = Vec3(0, 0, 0)) {
        attribute("double3 xformOp:translate", keys.times,
                  [&](std::size_t i) { return usda_tuple(keys.positions[i]); });
        attribute("quatf xformOp:orient", keys.times,
                  [&](std::size_t i) { return usda_tuple(keys.orientations[i]); });
        if (origin == Vec3(0, 0, 0)) {
            text_.line(
                "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]");
            return;
        }
        text_.line("double3 xformOp:translate:mesh = " + usda_tuple(origin));
        text_.line(
            "uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\", "
            "\"xformOp:translate:mesh\"]");
    }

    void write_place(const Vec3& position, const Quat& orientation) {
        LinearKeys keys;
        keys.add(scene_.start_time, position, orientation);
        write_keys(keys);
    }

    [[nodiscard]] std::string path_of(std::size_t material) const {
        return "</shot/materials/" + material_names_[material] + ">";
    }

    void write_materials() {
        text_.open("def Scope \"" + names_.unique("materials") + "\"");
        UsdaNames names;
        PictureStore store;
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            const ExportMaterial& material = scene_.materials[i];
            material_names_.push_back(names.unique(material.name));
            text_.open("def Material \"" + material_names_.back() + "\"",
                       {display_name(material.name)});
            write_usda_material(text_, path_of(i), material, scene_.textures[i], assets_, store);
            text_.close();
        }
        text_.close();
    }

    void number(const std::string& name, double value) {
        text_.line("float " + name + " = " + usda_number(static_cast<float>(value)));
    }

    void write_part(const ExportPart& part) {
        open("def Mesh", part.name, "MaterialBindingAPI");
        const auto point = [](const auto& v) { return usda_tuple(v); };
        text_.line("uniform token subdivisionScheme = \"none\"");
        text_.line("uniform bool doubleSided = 1");
        text_.line("point3f[] points = " + array_of(part.mesh.vertices, point));
        if (!part.mesh.normals.empty()) {
            text_.line("normal3f[] normals = " + array_of(part.mesh.normals, point),
                       {"interpolation = \"vertex\""});
        }
        for (std::size_t i = 0; i < part.coordinates.size(); ++i) {
            const auto pair = [](const Imath::V2f& c) {
                return fmt::format("({}, {})", usda_number(c.x), usda_number(c.y));
            };
            text_.line("texCoord2f[] primvars:" + usda_coordinates(i) + " = " +
                           array_of(part.coordinates[i], pair),
                       {"interpolation = \"vertex\""});
        }
        const std::vector<std::uint32_t> threes(part.mesh.triangles.size(), 3);
        text_.line("int[] faceVertexCounts = " + array_of(threes, index_text));
        std::vector<std::uint32_t> corners;
        for (const auto& triangle : part.mesh.triangles) {
            corners.insert(corners.end(), triangle.begin(), triangle.end());
        }
        text_.line("int[] faceVertexIndices = " + array_of(corners, index_text));
        text_.line("rel material:binding = " + path_of(part.patches.front().material));
        write_keys(part.keys, part.origin);
        for (std::size_t i = 1; i < part.patches.size(); ++i) {
            write_patch(part.patches[i], i);
        }
        text_.close();
    }

    /// Writes a subset of faces whose material differs from that of the mesh.
    void write_patch(const ExportPatch& patch, std::size_t number) {
        std::vector<std::uint32_t> faces;
        for (std::size_t i = 0; i < patch.count; ++i) {
            faces.push_back(static_cast<std::uint32_t>(patch.first + i));
        }
        text_.open(fmt::format("def GeomSubset \"field_{}\"", number),
                   {with_schema("MaterialBindingAPI")});
        text_.line("uniform token elementType = \"face\"");
        text_.line("uniform token familyName = \"materialBind\"");
        text_.line("int[] indices = " + array_of(faces, index_text));
        text_.line("rel material:binding = " + path_of(patch.material));
        text_.close();
    }

    /// Writes a camera with the rig's sensor; focal length, focus and aperture vary with scene
    /// time.
    void write_camera(const ExportCamera& camera) {
        const std::vector<ExportCameraKey> keys = camera.by_scene_time();
        LinearKeys path;
        for (const ExportCameraKey& key : keys) {
            path.add(key.scene_time, key.state.position, camera_axes(key.state).orientation());
        }
        const auto focal_length = [&](std::size_t i) {
            return camera.sensor_height / (2 * std::tan(keys[i].state.vertical_fov / 2));
        };
        const auto value = [](double v) { return usda_number(static_cast<float>(v)); };
        // The camera is inside an Xform that moves it, because three.js animates only Xforms and
        // meshes.
        open("def Xform", camera.name);
        write_keys(path);
        open("def Camera", camera.name + "_lens");
        number("horizontalAperture", kTenths * camera.sensor_height * scene_.aspect);
        number("verticalAperture", kTenths * camera.sensor_height);
        attribute("float focalLength", path.times,
                  [&](std::size_t i) { return value(kTenths * focal_length(i)); });
        attribute("float focusDistance", path.times,
                  [&](std::size_t i) { return value(keys[i].state.focus_distance); });
        attribute("float fStop", path.times, [&](std::size_t i) {  // 0: pinhole camera
            const double radius = keys[i].state.lens_radius;
            return value(radius > 0 ? focal_length(i) / (2 * radius) : 0);
        });
        text_.close();
        text_.close();
    }

    void write_light(const render::LightDescription& light) {
        if (const auto* rectangle = std::get_if<render::RectangleLight>(&light.light)) {
            const Vec3 back = -rectangle->normal;  // the light's direction is its -z axis
            const Vec3 u = rectangle->edge_u.normalized();
            open_light("RectLight", light.name, rectangle->radiance);
            number("inputs:width", 2 * rectangle->edge_u.length());
            number("inputs:height", 2 * rectangle->edge_v.length());
            write_place(rectangle->centre, CameraAxes{u, back.cross(u), back}.orientation());
        } else if (const auto* sphere = std::get_if<render::SphereLight>(&light.light)) {
            open_light("SphereLight", light.name, sphere->radiance);
            number("inputs:radius", sphere->radius);
            write_place(sphere->centre, Quat());
        } else if (const auto* disk = std::get_if<render::DiskLight>(&light.light)) {
            write_disk(light.name, disk->centre, disk->normal, disk->radius, disk->radiance);
            return;
        } else if (const auto* shade = std::get_if<render::ShadeLight>(&light.light)) {
            write_disk(light.name, shade->centre, shade->normal, shade->shape.radius,
                       render::mean_radiance(*shade));
            return;
        } else if (const auto* sun = std::get_if<render::DirectionalLight>(&light.light)) {
            open_light("DistantLight", light.name, sun->irradiance);
            write_place({0, 0, 0}, light_rotation(sun->direction));
        } else if (const auto* spot = std::get_if<render::SpotLight>(&light.light)) {
            open_light("SphereLight", light.name, spot->intensity, "ShapingAPI");
            text_.line("bool treatAsPoint = 1");
            number("inputs:shaping:cone:angle", kDegrees * spot->outer_angle);
            number("inputs:shaping:cone:softness", 1 - spot->inner_angle / spot->outer_angle);
            write_place(spot->position, light_rotation(spot->direction));
        } else if (const auto* point = std::get_if<render::PointLight>(&light.light)) {
            open_light("SphereLight", light.name, point->intensity);
            text_.line("bool treatAsPoint = 1");
            write_place(point->position, Quat());
        } else if (!write_dome(light)) {
            return;
        }
        text_.close();
    }

    void write_disk(const std::string& name, const Vec3& centre, const Vec3& normal, double radius,
                    const Vec3& radiance) {
        open_light("DiskLight", name, radiance);
        number("inputs:radius", radius);
        write_place(centre, light_rotation(normal));
        text_.close();
    }

    /// Returns false for a sky model, which USD does not have.
    bool write_dome(const render::LightDescription& light) {
        const auto& room = std::get<render::EnvironmentLight>(light.light);
        if (room.sky) {
            return false;
        }
        open_light("DomeLight", light.name, room.radiance);
        if (!room.image.empty()) {
            text_.line("asset inputs:texture:file = " + assets_.asset(room.image));
            text_.line("token inputs:texture:format = \"latlong\"");
        }
        // A UsdLux dome's image has Y up and +z in the middle; carom's has Z up and +x in the
        // middle.
        const Quat x_y_z_to_y_z_x(0.5, Vec3(0.5, 0.5, 0.5));
        Quat turn;
        turn.setAxisAngle(Vec3(0, 0, 1), room.rotation);
        write_place({0, 0, 0}, turn * x_y_z_to_y_z_x);
        return true;
    }

    static Quat light_rotation(const Vec3& direction) {
        Quat turn;
        turn.setRotation(Vec3(0, 0, -1), direction.normalized());
        return turn;
    }

    void open_light(const std::string& type, const std::string& name, const Vec3& strength,
                    const char* schema = nullptr) {
        const double largest = std::max({1e-12, strength.x, strength.y, strength.z});
        open("def " + type, name, schema);
        text_.line("color3f inputs:color = " + usda_tuple(strength / largest));
        number("inputs:intensity", largest);
    }

    const ExportScene& scene_;
    UsdaPictures assets_;
    UsdaText text_;
    UsdaNames names_;
    std::vector<std::string> material_names_;
};

}  // namespace

UsdaFiles scene_to_usda(const ExportScene& scene, const std::string& path) {
    return UsdaWriter(scene, path).run();
}

}  // namespace carom::pipeline
