// Warnings about objects whose size or file is probably not what was meant.
#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/check/placed_problem.h"
#include "pipeline/check/shape_box.h"
#include "pipeline/check/solid_check.h"
#include "pipeline/check/whole_mesh.h"
#include "pipeline/shot/material_textures.h"
#include "render/geometry/affine.h"

namespace carom::pipeline {
namespace {

constexpr double kLarge = 12;                        // m, of something that stands near a table
constexpr double kSmall = 0.0005;                    // m
constexpr double kFlat = 0.01;                       // thickness of grounds and walls, in lengths
constexpr std::uintmax_t kLargestMesh = 64'000'000;  // bytes

constexpr double kLeastPlausible = 0.005;  // m
constexpr double kMostPlausible = 5;       // m

/// Units of files, in the order in which they are tried.
constexpr std::array<std::pair<const char*, double>, 3> kUnits{
    {{"millimetres", 0.001}, {"centimetres", 0.01}, {"inches", 0.0254}}};

/// "60 m", "0.06 mm"
std::string length_text(double metres) {
    return metres < 0.01 ? fmt::format("{:.3g} mm", 1000 * metres)
                         : fmt::format("{:.3g} m", metres);
}

bool is_laid_by_uv(const render::ColourSource& texture) {
    const render::Placement* placement = placement_of(texture);
    const bool is_picture = std::holds_alternative<render::ImageTexture>(texture);
    return placement != nullptr && (placement->mapping == render::Mapping::uv ||
                                    (placement->mapping == render::Mapping::own && is_picture));
}

class ObjectChecker {
  public:
    ObjectChecker(const Shot& shot, const ShotSource* source)
        : shot_(shot), source_(source), meshes_(kLargestMesh) {}

    std::vector<Problem> check() {
        for (const render::ObjectDescription& object : shot_.scene.objects) {
            if (object.name.starts_with("table/")) {
                continue;
            }
            const auto* mesh = std::get_if<render::MeshShape>(&object.shape);
            const auto reading = mesh != nullptr ? meshes_.find(*mesh) : nullptr;
            if (reading && !reading->mesh.vertices.empty()) {
                Imath::Box3d box;
                for (const Vec3& vertex : reading->mesh.vertices) {
                    box.extendBy(vertex);
                }
                check_size(object, box, !mesh->file.empty());
                check_picture(object, *reading);
                check_materials(object, *reading);
            } else if (const auto box = box_of(object.shape)) {
                check_size(object, *box, false);
            }
        }
        return std::move(problems_);
    }

  private:
    void warn(const render::ObjectDescription& object, const char* key,
              const std::string& message) {
        add(placed_problem(source_, {"objects", object.name, key}, Severity::warning,
                           "object '" + object.name + "' " + message),
            key + message);
    }

    /// Objects that `repeat` made are alike and have one place.
    void add(Problem problem, const std::string& what) {
        if (places_.insert({problem.place.line, what}).second) {
            problems_.push_back(std::move(problem));
        }
    }

    void check_size(const render::ObjectDescription& object, const Imath::Box3d& box,
                    bool is_file) {
        const Vec3 scale = render::axis_scales(object.world_from_object);
        const Vec3 size = box.size() * scale;
        const double longest = std::max({size.x, size.y, size.z});
        const double thickness = std::min({size.x, size.y, size.z});
        // Flat things may be the ground or a wall; a file that is not level is neither as a rule.
        const bool is_flat =
            thickness <= kFlat * longest && (!is_file || size.z <= kFlat * longest);
        const bool is_large = longest > kLarge && !is_flat && !is_room(shot_, object, box);
        const bool is_small = longest > 0 && longest < kSmall;
        if (!is_large && !is_small) {
            return;
        }
        const char* key = std::visit([](const auto& shape) { return shape.kName; }, object.shape);
        const bool is_even =
            std::abs(scale.x - scale.y) + std::abs(scale.y - scale.z) < 1e-6 * scale.x;
        std::string advice;
        if (is_file && is_even) {
            advice = is_large ? scale_for_large(longest, scale.x)
                              : fmt::format("; did you mean 'scale: {:.4g}'?", 1000 * scale.x);
        } else if (is_large && !is_file) {
            advice = "; lengths without a unit are metres";
        }
        warn(object, key, "is " + length_text(longest) + " long" + advice);
    }

    /// For a file whose numbers are of a smaller unit than the metre: the units in which it would
    /// have the size of something on or beside a table.
    static std::string scale_for_large(double longest, double scale) {
        std::string text;
        for (const auto& [name, factor] : kUnits) {
            if (longest * factor < kLeastPlausible || longest * factor > kMostPlausible) {
                continue;
            }
            text += text.empty() ? fmt::format("; if its file is in {}, give it 'scale: {:.4g}'",
                                               name, factor * scale)
                                 : fmt::format("{}{}: {:.4g}", text.ends_with("'") ? " (" : ", ",
                                               name, factor * scale);
        }
        return text.empty() || text.ends_with("'") ? text : text + ")";
    }

    void check_picture(const render::ObjectDescription& object,
                       const render::MeshReading& reading) {
        const auto material = std::ranges::find(shot_.scene.materials, object.material,
                                                &render::MaterialDescription::name);
        if (!reading.mesh.uv.empty() || material == shot_.scene.materials.end()) {
            return;
        }
        std::vector<std::string> keys;
        bool are_pictures = true;
        visit_textures(*material, [&](std::string_view key, const render::ColourSource& texture) {
            if (is_laid_by_uv(texture)) {
                const std::string quoted = "'" + std::string(key) + "'";
                if (keys.empty() || keys.back() != quoted) {
                    keys.push_back(quoted);
                }
                are_pictures =
                    are_pictures && std::holds_alternative<render::ImageTexture>(texture);
            }
        });
        if (!keys.empty()) {
            warn(object, "material",
                 fmt::format("has no texture coordinates (uv), so that each of its triangles shows "
                             "half of the {} in {} of material '{}'; 'mapping: box' needs none",
                             are_pictures ? "picture" : "texture", enumerate(keys, "and"),
                             object.material));
        }
    }

    /// One object has one material.
    void check_materials(const render::ObjectDescription& object,
                         const render::MeshReading& reading) {
        const bool has_own = object.material != "plain";
        if (reading.materials.size() < (has_own ? 2U : 1U)) {
            return;
        }
        constexpr std::size_t kNamed = 4;
        std::vector<std::string> names;
        for (const std::string& name : reading.materials) {
            if (names.size() == kNamed && reading.materials.size() > kNamed + 1) {
                names.push_back(fmt::format("{} more", reading.materials.size() - kNamed));
                break;
            }
            names.push_back("'" + name + "'");
        }
        warn(object, "mesh",
             fmt::format("does not have the {} {} of its file, because an object has one material; "
                         "'carom import' writes the file's materials, and an object for each",
                         names.size() == 1 ? "material" : "materials", enumerate(names, "and")));
    }

    const Shot& shot_;
    const ShotSource* source_;
    WholeMeshes meshes_;
    std::set<std::pair<int, std::string>> places_;
    std::vector<Problem> problems_;
};

}  // namespace

std::vector<Problem> object_problems(const Shot& shot, const ShotSource* source) {
    return ObjectChecker(shot, source).check();
}

}  // namespace carom::pipeline
