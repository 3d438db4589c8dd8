#include "pipeline/export/gltf_textures.h"

#include <filesystem>

namespace carom::pipeline {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kLinear = 9729;  // constants of the glTF specification for filters and wrapping
constexpr int kLinearMipmapLinear = 9987;
constexpr int kRepeat = 10497;

}  // namespace

std::size_t GltfTextures::add_image(const std::string& name, std::span<const std::byte> bytes,
                                    PictureFormat format) {
    images_.push_back({{"name", name},
                       {"mimeType", format == PictureFormat::jpeg ? "image/jpeg" : "image/png"},
                       {"bufferView", buffer_.add_bytes(bytes)}});
    return images_.size() - 1;
}

Json GltfTextures::reference(const TextureGroup& group, std::size_t image) {
    Json result{{"index", image}};  // every image has one texture
    if (group.coordinates != 0) {
        result["texCoord"] = group.coordinates;
    }
    const TextureTile& tile = group.shared.tile;
    if (!(tile == TextureTile{})) {
        // Coordinates in the file run down: v is 1 - v.
        const Vec2 offset(-tile.offset.x, 1 - tile.repeats.y + tile.offset.y);
        result["extensions"]["KHR_texture_transform"] = {
            {"offset", {offset.x, offset.y}}, {"scale", {tile.repeats.x, tile.repeats.y}}};
        extensions_.insert("KHR_texture_transform");
    }
    return result;
}

Json GltfTextures::file(const TextureGroup& group, const std::string& path) {
    const auto known = files_.find(path);
    if (known != files_.end()) {
        return reference(group, known->second);
    }
    const std::size_t image = add_image(std::filesystem::path(path).stem().string(),
                                        read_picture_bytes(path), pictures_.facts(path).format);
    files_.emplace(path, image);
    return reference(group, image);
}

GltfTextures::Made GltfTextures::made(const TextureGroup& group, const std::string& name,
                                      const Hash128& hash,
                                      const std::function<BakedPicture()>& make) {
    const auto known = made_.find(hash);
    if (known != made_.end()) {
        return {reference(group, known->second.image), known->second.alpha};
    }
    const std::shared_ptr<const EncodedPicture> picture =
        pictures_.made(hash, [&] { return encode(make(), made_format(group, pictures_)); });
    const MadeImage image{add_image(name, picture->bytes, picture->format), picture->alpha};
    made_.emplace(hash, image);
    return {reference(group, image.image), image.alpha};
}

Json GltfTextures::textures() const {
    Json result = Json::array();
    for (std::size_t i = 0; i < images_.size(); ++i) {
        result.push_back({{"sampler", 0}, {"source", i}});
    }
    return result;
}

Json GltfTextures::samplers() const {
    if (images_.empty()) {
        return Json::array();
    }
    return Json::array({Json{{"magFilter", kLinear},
                             {"minFilter", kLinearMipmapLinear},
                             {"wrapS", kRepeat},
                             {"wrapT", kRepeat}}});
}

}  // namespace carom::pipeline
