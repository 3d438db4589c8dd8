#include "pipeline/import/import_mesh.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/core.h>
#include <fmt/format.h>

#include "core/text.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/text.h"
#include "pipeline/import/conversion.h"
#include "pipeline/import/mesh_material.h"
#include "pipeline/import/mtl_file.h"
#include "render/geometry/mesh_file.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;
using config::quote;
using scene_text::yaml;
using scene_text::yaml_text;

constexpr std::size_t kMostMtlBytes = 16'000'000;

std::string obj_text(const render::MeshShape& mesh) {
    fmt::memory_buffer buffer;
    const auto out = std::back_inserter(buffer);
    fmt::format_to(out, "{}", kMadeMesh);
    for (const Vec3& v : mesh.vertices) {
        fmt::format_to(out, "v {} {} {}\n", v.x, v.y, v.z);
    }
    for (const Vec2& uv : mesh.uv) {
        fmt::format_to(out, "vt {} {}\n", uv.x, uv.y);
    }
    for (const Vec3& n : mesh.normals) {
        fmt::format_to(out, "vn {} {} {}\n", n.x, n.y, n.z);
    }
    const bool has_uv = !mesh.uv.empty();
    const bool has_normals = !mesh.normals.empty();
    for (const auto& triangle : mesh.triangles) {
        fmt::format_to(out, "f");
        for (const std::uint32_t corner : triangle) {
            const std::uint32_t i = corner + 1;
            if (has_uv && has_normals) {
                fmt::format_to(out, " {}/{}/{}", i, i, i);
            } else if (has_uv) {
                fmt::format_to(out, " {}/{}", i, i);
            } else if (has_normals) {
                fmt::format_to(out, " {}//{}", i, i);
            } else {
                fmt::format_to(out, " {}", i);
            }
        }
        fmt::format_to(out, "\n");
    }
    return fmt::to_string(buffer);
}

class MeshImport {
  public:
    MeshImport(const std::string& path, const std::string& yaml_path,
               const ImportMeshOptions& options)
        : path_(path),
          folder_(fs::path(path).parent_path()),
          yaml_folder_(fs::absolute(yaml_path).parent_path()),
          stem_(fs::path(yaml_path).stem().string()),
          options_(options) {}

    ImportMeshResult run() {
        std::vector<render::MeshReading> parts = render::read_mesh_parts(path_);
        if (!parts.front().problems.empty()) {
            const render::MeshRemark& problem = parts.front().problems.front();
            result_.problems.push_back({Severity::error,
                                        {path_, static_cast<int>(problem.line), 0, 1},
                                        {},
                                        problem.sentence,
                                        {}});
            return std::move(result_);
        }
        read_libraries(parts.front().libraries);
        for (const render::MeshReading& part : parts) {
            for (const render::MeshRemark& warning : part.warnings) {
                note(render::text_of(path_, warning));
            }
            add_part(part, parts.size() == 1);
        }
        result_.yaml = head() + "objects:\n" + objects_ +
                       (materials_.empty() ? "" : "materials:\n" + materials_);
        return std::move(result_);
    }

  private:
    void note(const std::string& text) {
        if (std::ranges::find(result_.notes, text) == result_.notes.end()) {
            result_.notes.push_back(text);
        }
    }

    [[nodiscard]] std::string head() const {
        std::string text = "# Made by carom import from " + fs::path(path_).filename().string() +
                           ". Include this in a shot and give the objects their place: 'at'.\n";
        for (const std::string& line : result_.notes) {
            text += "# - " + line + "\n";
        }
        std::ranges::replace_if(
            text, [](char c) { return c != '\n' && static_cast<unsigned char>(c) < 0x20; }, '?');
        return text;
    }

    [[nodiscard]] std::string relative(const fs::path& file) const {
        std::error_code error;
        const fs::path path = fs::proximate(file, yaml_folder_, error);
        return (error ? fs::absolute(file) : path).generic_string();
    }

    /// A file that another one names: as it is, or beside the mesh, as after a move from another
    /// machine. Empty if there is none.
    [[nodiscard]] fs::path find_file(std::string name) const {
        std::error_code ignored;
        for (const bool is_windows : {false, true}) {
            if (is_windows) {
                std::ranges::replace(name, '\\', '/');
            }
            for (const fs::path& candidate :
                 {folder_ / name, folder_ / fs::path(name).filename()}) {
                if (fs::is_regular_file(candidate, ignored)) {
                    return candidate;
                }
            }
        }
        return {};
    }

    void read_libraries(const std::vector<std::string>& libraries) {
        for (const std::string& line : libraries) {
            // One name with blanks, or several names.
            std::vector<std::string> names{line};
            if (find_file(line).empty() && line.find(' ') != std::string::npos) {
                names.clear();
                for (std::size_t at = 0; at < line.size() && line[at] != '#';) {
                    const std::size_t end = std::min(line.find(' ', at), line.size());
                    names.push_back(line.substr(at, end - at));
                    at = end + 1;
                }
            }
            for (const std::string& name : names) {
                read_library(name);
            }
        }
    }

    void read_library(const std::string& name) {
        const fs::path file = find_file(name);
        std::string text;
        if (file.empty() || !config::read_text_file(file.string(), kMostMtlBytes, text)) {
            note("no file " + quote(name) + " with materials was found");
            return;
        }
        MtlFile library = read_mtl(text);
        if (!library.problem.empty()) {
            note(quote(name) + ": " + library.problem);
        }
        library_.merge(library.materials);
    }

    void add_part(const render::MeshReading& part, bool is_only_one) {
        const std::string material = part.materials.empty() ? "" : part.materials.front();
        const std::string object =
            objects_names_.claim(is_only_one || material.empty() ? stem_ : stem_ + "_" + material);
        std::string file = relative(path_);
        if (!is_only_one) {
            file = object + ".obj";
            result_.files.push_back({file, obj_text(part.mesh)});
        }
        objects_ += "  " + object + ": {mesh: " + yaml_text(file);
        if (!options_.is_z_up) {
            objects_ += ", rotate: [90 deg, 0 deg, 0 deg]";
        }
        if (options_.unit != 1) {
            objects_ += ", scale: " + yaml(options_.unit);
        }
        const std::string name = material_of(material, part);
        objects_ += (name.empty() ? "" : ", material: " + name) + "}\n";
    }

    /// The name of the material in the YAML, to which it is added; empty: there is none.
    std::string material_of(const std::string& name, const render::MeshReading& part) {
        const auto found = library_.find(name);
        MtlMaterial material = found != library_.end() ? found->second : MtlMaterial{};
        if (!part.pictures.empty()) {
            material.pictures["map_Kd"] = MtlPicture{part.pictures.front()};
        } else if (name.empty()) {
            return {};
        } else if (found == library_.end()) {
            note("material " + quote(name) + " is not defined; it is a plain grey");
        }
        std::string claimed = material_names_.claim(name.empty() ? stem_ : name);
        const MeshFiles files{[this](const std::string& file) { return find_file(file); },
                              [this](const fs::path& file) { return relative(file); },
                              [this](const std::string& sentence) { note(sentence); }};
        materials_ += "  " + claimed + ": {standard: {" +
                      standard_keys(name, material, !part.mesh.uv.empty(), files) + "}}\n";
        return claimed;
    }

    std::string path_;
    fs::path folder_, yaml_folder_;
    std::string stem_;
    ImportMeshOptions options_;
    std::map<std::string, MtlMaterial> library_;
    scene_text::Names objects_names_, material_names_;
    std::string objects_, materials_;  // lines of the YAML
    ImportMeshResult result_;
};

}  // namespace

bool is_mesh_name(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
    });
    return ending == ".obj" || ending == ".ply";
}

ImportMeshResult import_mesh(const std::string& path, const std::string& yaml_path,
                             const ImportMeshOptions& options) {
    return MeshImport(path, yaml_path, options).run();
}

}  // namespace carom::pipeline
