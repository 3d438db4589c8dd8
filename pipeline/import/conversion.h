// Shared parts of the conversion from a scene text to YAML.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "pipeline/config/problem_list.h"
#include "pipeline/import/import_scene.h"
#include "pipeline/import/names.h"
#include "pipeline/import/scene_model.h"

namespace carom::pipeline::scene_text {

/// Converts the author's coordinates and units to carom's.
class Axes {
  public:
    explicit Axes(const ImportOptions& options) : unit_(options.unit), is_z_up_(options.is_z_up) {}

    /// Converts a direction, without the unit: a quarter turn about x maps y up to z up.
    [[nodiscard]] Vec3 direction(const Vec3& v) const {
        return is_z_up_ ? v : Vec3(v.x, -v.z, v.y);
    }
    [[nodiscard]] Vec3 place(const Vec3& v) const { return direction(v) * unit_; }
    [[nodiscard]] double length(double author_units) const { return author_units * unit_; }
    [[nodiscard]] Vec3 author_up() const { return is_z_up_ ? Vec3(0, 0, 1) : Vec3(0, 1, 0); }

  private:
    double unit_;
    bool is_z_up_;
};

/// The state of a conversion.
struct Conversion {
    SceneModel scene;
    const ImportOptions& options;
    Axes axes;
    config::ProblemList& problems;
    std::string scene_folder, shot_folder;
    std::vector<std::string> notes{};
    std::set<std::string> noted{};

    /// Adds a note, unless it was added before. Only the first hundred are kept.
    void note(const std::string& text);

    /// The name in the YAML of the element `given`, with a note if it differs. `kind`: "material".
    [[nodiscard]] std::string name(const char* kind, const std::string& given, Names& names);
};

/// The names of all `elements`.
template <class Element>
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Element>& elements) {
    std::vector<std::string> names;
    names.reserve(elements.size());
    for (const Element& element : elements) {
        names.push_back(element.name.text);
    }
    return names;
}

/// The materials that objects use, each once for every way in which its picture is placed: shots
/// place pictures by the material, the text by the shape.
class MaterialTable {
  public:
    explicit MaterialTable(Conversion& conversion);

    /// The name in the YAML of material `index` on `object`, of which null is a sphere.
    std::string use(std::size_t index, const Object* object);

    /// The section of all materials, also of those that no object uses.
    [[nodiscard]] std::string section();

  private:
    Conversion& conversion_;
    Names names_;
    std::vector<std::string> pictures_;                        // files of the textures
    std::vector<std::map<std::string, std::string>> written_;  // names by image, by material
    std::string text_;
};

// ---- sections of the YAML, whole lines ------------------------------------------------------

// Parts that cannot be converted are reported as problems.

/// The objects, with the materials that they use, and the events; events after `last_time` (s) are
/// omitted.
[[nodiscard]] std::string objects_and_events(Conversion& conversion, double last_time);
[[nodiscard]] std::string lights_section(Conversion& conversion);
/// `duration` becomes the latest scene time that is filmed.
[[nodiscard]] std::string cameras_section(Conversion& conversion, double& duration);
[[nodiscard]] std::string render_section(Conversion& conversion);

/// The size of pictures in texts without one, pixels.
inline constexpr double kDefaultWidth = 320;
inline constexpr double kDefaultHeight = 240;

/// The centre of interest: the middle of the moving spheres, otherwise of all spheres, otherwise
/// the first camera's target. In the author's units.
[[nodiscard]] Vec3 middle_of_moving_spheres(const SceneModel& scene);

// ---- YAML ------------------------------------------------------------------------------------

/// Nine significant digits: "0.45".
[[nodiscard]] std::string yaml(double value);
/// "[0.1, 0.2, 0.3]"
[[nodiscard]] std::string yaml(const Vec3& value);
/// Double-quoted.
[[nodiscard]] std::string yaml_text(const std::string& value);
/// "rotate: {axis: [0, 0, 1], angle: 30 deg}" for the rotation that maps x, y and z to these unit
/// vectors; empty for the identity.
[[nodiscard]] std::string yaml_rotation(const Vec3& x, const Vec3& y, const Vec3& z);

}  // namespace carom::pipeline::scene_text
