// The pictures of a glTF file.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "core/hash.h"
#include "pipeline/export/gltf_buffer.h"
#include "pipeline/export/textures/texture_group.h"

namespace carom::pipeline {

/// Embeds pictures in a file. Each is embedded once.
class GltfTextures {
  public:
    /// All must outlive this.
    GltfTextures(GltfBuffer& buffer, PictureStore& pictures, std::set<std::string>& extensions)
        : buffer_(buffer), pictures_(pictures), extensions_(extensions) {}

    /// A reference to the picture in a file, as it is, as materials have it.
    [[nodiscard]] nlohmann::ordered_json file(const TextureGroup& group, const std::string& path);

    struct Made {
        nlohmann::ordered_json reference;
        AlphaKind alpha = AlphaKind::opaque;
    };
    /// A reference to a picture that `make` returns. `hash`: of all that it depends on.
    [[nodiscard]] Made made(const TextureGroup& group, const std::string& name, const Hash128& hash,
                            const std::function<BakedPicture()>& make);

    /// The lists of the document, empty without pictures.
    [[nodiscard]] const nlohmann::ordered_json& images() const { return images_; }
    [[nodiscard]] nlohmann::ordered_json textures() const;
    [[nodiscard]] nlohmann::ordered_json samplers() const;

  private:
    std::size_t add_image(const std::string& name, std::span<const std::byte> bytes,
                          PictureFormat format);
    nlohmann::ordered_json reference(const TextureGroup& group, std::size_t image);

    GltfBuffer& buffer_;
    PictureStore& pictures_;
    std::set<std::string>& extensions_;
    nlohmann::ordered_json images_ = nlohmann::ordered_json::array();
    std::map<std::string, std::size_t> files_;  // images
    struct MadeImage {
        std::size_t image;
        AlphaKind alpha;
    };
    std::map<Hash128, MadeImage> made_;
};

}  // namespace carom::pipeline
