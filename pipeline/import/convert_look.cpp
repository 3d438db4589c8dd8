// Converts materials to phong materials, and lights.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include "pipeline/config/text.h"
#include "pipeline/import/conversion.h"

namespace carom::pipeline::scene_text {

namespace {

namespace fs = std::filesystem;
using config::quote;

constexpr double kWidestSpread = 1.5;  // rad, of the format

// ---- materials ------------------------------------------------------------------------------

class PhongText {
  public:
    PhongText(const PhongInfo& phong, Conversion& conversion)
        : phong_(phong), conversion_(conversion) {}

    /// `diffuse` replaces the colour, unless it is empty.
    std::string operator()(const std::string& diffuse) {
        std::string text = "ambient: " + colour(phong_.ambient, "ambient");
        text += ", diffuse: " + (diffuse.empty() ? colour(phong_.diffuse, "diffuse") : diffuse);
        text += ", specular: " + colour(phong_.specular, "specular");
        text += ", shininess: " + yaml(clamped(phong_.shininess, 20, 0, 1e6, "shininess"));
        const double reflectance = clamped(phong_.reflectance, 0, 0, 1, "reflectance");
        if (reflectance > 0) {
            text += ", reflectance: " + yaml(reflectance);
            text += spread("reflectance_spread", phong_.diffuse_reflection, "diffuse_reflection");
        }
        const double refraction = clamped(phong_.refraction, 0, 0, 1, "refraction");
        if (refraction > 0) {
            text += ", transmittance: " + yaml(refraction);
            text += spread("transmittance_spread", phong_.diffuse_refraction, "diffuse_refraction");
            text += ", index: " +
                    yaml(clamped(phong_.refraction_index, 1, 0.1, 10, "refraction_index"));
        }
        return text;
    }

  private:
    std::string colour(const std::optional<Vec3>& given, const char* name) {
        Vec3 c = given.value_or(Vec3(0, 0, 0));
        for (int i = 0; i < 3; ++i) {
            c[i] = clamped(c[i], 0, 0, 1, name);
        }
        return yaml(c);
    }

    double clamped(const Real& given, double otherwise, double low, double high, const char* name) {
        const double value = given.value_or(otherwise);
        const double result = std::clamp(value, low, high);
        if (result != value) {
            conversion_.note("phong_info " + quote(phong_.name.text) + ": " + name + " " +
                             yaml(value) + " became " + yaml(result));
        }
        return result;
    }

    std::string spread(const char* key, const Real& given, const char* name) {
        const double value = clamped(given, 0, 0, kWidestSpread, name);
        return value > 0 ? std::string(", ") + key + ": " + yaml(value) + " rad" : std::string();
    }

    const PhongInfo& phong_;
    Conversion& conversion_;
};

/// The path of a texture's image for the YAML; empty, with a note, if the file does not exist.
std::string picture(const Texture& texture, Conversion& conversion) {
    const fs::path path = fs::path(conversion.scene_folder) / texture.filename->text;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        conversion.note("texture " + quote(texture.name.text) + ": no file " +
                        quote(texture.filename->text) +
                        " was found; the diffuse colour replaces it");
        return {};
    }
    const fs::path relative = fs::proximate(path, conversion.shot_folder, error);
    return (error ? fs::absolute(path, error) : relative).generic_string();
}

/// The lengths over which u and v grow from 0 to 1. An infinite plane has one unit.
std::pair<double, double> picture_extent(const Object& object) {
    if (object.kind == ShapeKind::plane) {
        return {1, 1};
    }
    const Vec3 edge = *object.vertices[1] - *object.vertices[0];
    const Vec3 across = edge.cross(*object.vertices[2] - *object.vertices[0]);
    return {edge.length(), across.length() / std::max(edge.length(), 1e-300)};
}

/// Where `scale_U` and `scale_V` put the picture on the object; without an object, on a sphere.
std::string placement(const Material& material, const Object* object, Conversion& conversion) {
    if (material.scale_u || material.scale_v) {
        conversion.note(
            "scale_U and scale_V are the width and height of one picture in units of the scene, on "
            "spheres its fraction of the way around and from pole to pole");
    }
    if (object == nullptr || object->kind == ShapeKind::sphere) {
        const auto repeats = [](const Real& scale) {
            return yaml(std::clamp(1 / scale.value_or(1), 1e-9, 1e4));
        };
        return "scale: [" + repeats(material.scale_u) + ", " + repeats(material.scale_v) + "]";
    }
    // Without a scale, one picture covers the shape; an infinite plane has one on each square unit.
    const auto [width, height] = picture_extent(*object);
    const auto length = [&](double units) {
        return yaml(std::clamp(conversion.axes.length(units), 1e-9, 1e4));
    };
    return "size: [" + length(material.scale_u.value_or(width)) + ", " +
           length(material.scale_v.value_or(height)) + "]";
}

// ---- lights ---------------------------------------------------------------------------------

// Lights of the format do not fall off with distance. A surface of diffuse colour k that faces a
// light has the radiance k times the light's colour, so its irradiance is pi times that colour.
// Rectangles and bulbs give this irradiance if their radiance is the colour.
constexpr const char* kFalloff = ", falloff: none";

/// The part of v perpendicular to the unit vector `axis`.
Vec3 perpendicular_part(const Vec3& v, const Vec3& axis) {
    return v - axis * axis.dot(v);
}

/// `towards`: a point on the side that emits.
std::string rectangle_light(const Light& light, const Vec3& towards, Conversion& conversion) {
    const Axes& axes = conversion.axes;
    const double width = light.x->length();
    const Vec3 u = *light.x / std::max(width, 1e-300);
    const Vec3 across = perpendicular_part(*light.y, u);
    const double breadth = across.length();
    if (!(width > 0) || !(breadth > 1e-9 * std::max(width, light.y->length()))) {
        conversion.problems.error(light.name.place, "the edges x and y of light_rect " +
                                                        quote(light.name.text) +
                                                        " do not span a rectangle");
        return {};
    }
    if (std::abs(u.dot(*light.y)) > 1e-6 * light.y->length()) {
        conversion.note("light_rect " + quote(light.name.text) +
                        ": its edges are not at right angles; y was straightened");
    }
    const Vec3 middle = *light.position + *light.x / 2 + across / 2;
    Vec3 normal = u.cross(across / breadth);
    normal = normal.dot(towards - middle) < 0 ? -normal : normal;
    conversion.note("light_rect " + quote(light.name.text) + " emits light from one side only");
    // The first axis of the format's light, and the rotation from it.
    const Vec3 n = axes.direction(normal);
    const Vec3 level = Vec3(0, 0, 1).cross(n);
    const Vec3 u0 = level.dot(level) < 1e-12 ? Vec3(1, 0, 0) : level.normalized();
    const Vec3 our_u = axes.direction(u);
    const double roll = std::atan2(our_u.dot(n.cross(u0)), our_u.dot(u0)) * 180 / std::numbers::pi;
    return "rectangle: [" + yaml(axes.length(width)) + ", " + yaml(axes.length(breadth)) +
           "], at: " + yaml(axes.place(middle)) + ", facing: " + yaml(n) + ", roll: " + yaml(roll) +
           " deg, radiance: " + yaml(light.colour.value_or(Vec3(1, 1, 1))) + kFalloff;
}

std::string light_text(const Light& light, const Vec3& towards, Conversion& conversion) {
    const Axes& axes = conversion.axes;
    const Vec3 colour = light.colour.value_or(Vec3(1, 1, 1));
    switch (light.kind) {
        case LightKind::rectangle:
            return rectangle_light(light, towards, conversion);
        case LightKind::bulb:
            return "sphere: " + yaml(axes.length(*light.radius)) +
                   ", at: " + yaml(axes.place(*light.position)) + ", radiance: " + yaml(colour) +
                   kFalloff;
        case LightKind::point:
            return "point: " + yaml(colour * std::numbers::pi) +
                   ", at: " + yaml(axes.place(*light.position)) + kFalloff;
    }
    return {};
}

/// A light above the first camera, at the distance of the camera's target.
Light light_over_camera(const Conversion& conversion) {
    const Camera& camera = conversion.scene.cameras.front();
    const Vec3 position = camera.positions.front();
    const double distance = (camera.targets.front() - position).length();
    Light light;
    light.name.text = "over_the_camera";
    light.position = position + conversion.axes.author_up() * distance;
    return light;
}

}  // namespace

MaterialTable::MaterialTable(Conversion& conversion)
    : conversion_(conversion), names_(names_of(conversion.scene.materials)) {
    for (const Texture& texture : conversion.scene.textures) {
        pictures_.push_back(picture(texture, conversion));
    }
    written_.resize(conversion.scene.materials.size());
}

std::string MaterialTable::use(std::size_t index, const Object* object) {
    static constexpr const char* kKinds[] = {"plane", "sphere", "triangle", "rectangle", "box"};
    const Material& material = conversion_.scene.materials[index];
    std::string image;
    if (material.texture && !pictures_[*material.texture].empty()) {
        image = "{image: {file: " + yaml_text(pictures_[*material.texture]) + ", " +
                placement(material, object, conversion_) + ", is_linear: true}}";
    }
    std::map<std::string, std::string>& names = written_[index];
    std::string& name = names[image];
    if (name.empty()) {
        name = object == nullptr || names.size() == 1
                   ? conversion_.name("material", material.name.text, names_)
                   : names_.claim(material.name.text + "_on_" +
                                  kKinds[static_cast<int>(object->kind)]);
        PhongText phong(conversion_.scene.phong_infos[material.phong], conversion_);
        text_ += "  " + name + ":\n    phong: {" + phong(image) + "}\n";
    }
    return name;
}

std::string MaterialTable::section() {
    for (std::size_t i = 0; i < written_.size(); ++i) {
        if (written_[i].empty()) {
            use(i, nullptr);
        }
    }
    return text_.empty() ? text_ : "materials:\n" + text_;
}

std::string lights_section(Conversion& conversion) {
    std::vector<Light> lights = conversion.scene.lights;
    if (lights.empty()) {
        conversion.note("the text has no lights: a light above the camera was added");
        lights.push_back(light_over_camera(conversion));
    }
    const Vec3 towards = middle_of_moving_spheres(conversion.scene);
    std::ostringstream out;
    Names names(names_of(lights));
    out << "lights:\n";
    for (const Light& light : lights) {
        out << "  " << conversion.name("light", light.name.text, names) << ": {"
            << light_text(light, towards, conversion) << "}\n";
    }
    return out.str();
}

}  // namespace carom::pipeline::scene_text
