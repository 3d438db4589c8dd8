// Materials of a USD file.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/hash.h"
#include "pipeline/export/export_scene.h"
#include "pipeline/export/textures/texture_group.h"
#include "pipeline/export/usda_text.h"

namespace carom::pipeline {

/// A file that belongs to another one.
struct CompanionFile {
    std::string name;  // within its folder
    std::vector<std::byte> bytes;
};

/// Names pictures as a USD file does, and collects those that have to be made.
class UsdaPictures {
  public:
    /// `folder`: of the file; `made_folder`: within it, for the pictures that are made.
    UsdaPictures(std::string folder, std::string made_folder)
        : folder_(std::move(folder)), made_folder_(std::move(made_folder)) {}

    /// The path of a file in marks, relative to the folder.
    [[nodiscard]] std::string asset(const std::string& file) const;

    struct Made {
        std::string asset;
        AlphaKind alpha = AlphaKind::opaque;
    };
    /// A picture that `make` returns. `hash`: of all that it depends on.
    [[nodiscard]] Made made(const std::string& name, const Hash128& hash,
                            const std::function<BakedPicture()>& make);

    [[nodiscard]] std::vector<CompanionFile> take_files() { return std::move(files_); }

  private:
    std::string folder_;
    std::string made_folder_;
    UsdaNames names_;
    std::map<Hash128, Made> made_;
    std::vector<CompanionFile> files_;
};

/// Writes the prims inside a material whose path is "</shot/materials/NAME>". Throws Error if a
/// picture cannot be read.
void write_usda_material(UsdaText& text, const std::string& path, const ExportMaterial& material,
                         const MaterialTextures& textures, UsdaPictures& pictures,
                         PictureStore& store);

/// The name of the coordinates of that index in meshes.
[[nodiscard]] std::string usda_coordinates(std::size_t index);

}  // namespace carom::pipeline
