#include "pipeline/export/gltf_materials.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/field_hasher.h"
#include "pipeline/export/textures/texture_values.h"

namespace carom::pipeline {

namespace {

using Json = nlohmann::ordered_json;
using render::PictureChannel;

/// The roughness r = 1/3 of carom's sheen (render/material/kernels/sheen.h) is the square of
/// glTF's.
constexpr double kSheenRoughness = 0.5773502691896258;
constexpr double kCutOut = 0.5;  // the alpha below which a cut-out shows nothing

/// A number of a material and where glTF has it.
struct Slot {
    const render::NumberSource& number;
    double plain;
    int channel;       // of the picture, 0 to 3
    bool is_constant;  // its texture, if any, cannot be shown
};

const render::ImageTexture* lone_image(const render::ColourSource& source) {
    return std::get_if<render::ImageTexture>(&source);
}
const render::ImageTexture* lone_image(const render::NumberSource& source) {
    const render::NumberTexture* texture = source.texture();
    return texture == nullptr ? nullptr : lone_image(texture->pattern);
}

bool has_any(const Vec3& v) {
    return v.x > 0 || v.y > 0 || v.z > 0;
}

/// Whether that channel of the picture is what counts of it.
bool is_in_channel(PictureChannel wanted, int channel, const PictureFacts& facts) {
    if (wanted == PictureChannel::alpha) {
        return channel == 3;
    }
    if (facts.is_grey()) {
        return channel < 3;
    }
    return channel < 3 &&
           wanted == std::array{PictureChannel::red, PictureChannel::green,
                                PictureChannel::blue}[static_cast<std::size_t>(channel)];
}

class MaterialJson {
  public:
    MaterialJson(const ExportMaterial& plain, const MaterialTextures& textures,
                 GltfTextures& pictures, PictureStore& store, std::set<std::string>& extensions)
        : plain_(plain),
          places_(textures.places),
          lengths_(textures.relief_lengths),
          pictures_(pictures),
          store_(store),
          extensions_(extensions) {
        if (textures.surface) {
            surface_ = *textures.surface;
        }
    }

    Json run() {
        add_base();
        add_metal();
        result_["doubleSided"] = true;
        add_relief();
        add_emission();
        add_coat();
        add_sheen();
        if (plain_.transmission > 0) {
            extend("KHR_materials_transmission", {{"transmissionFactor", plain_.transmission}});
            extend("KHR_materials_ior", {{"ior", plain_.ior}});
        }
        add_specular();
        result_["name"] = plain_.name;
        result_["pbrMetallicRoughness"] = std::move(pbr_);
        return std::move(result_);
    }

  private:
    template <class... Source>
    [[nodiscard]] std::optional<TextureGroup> group(const Source&... sources) {
        std::vector<PlacedTexture> textures;
        (add_textures(sources, textures), ...);
        return texture_group(std::move(textures), places_, store_);
    }

    template <class... Source>
    [[nodiscard]] Hash128 hash_of(const char* use, const Source&... sources) const {
        FieldHasher hasher(FileHash::stamp);
        hasher.add(use);
        (hasher.add_value(sources), ...);
        return hasher.finish();
    }

    void extend(const char* name, Json values) {
        result_["extensions"][name] = std::move(values);
        extensions_.insert(name);
    }

    /// Whether a picture's file shows the colour: other programs decode it as it is meant, and what
    /// is not opaque has no other colour. `is_own_alpha`: it is seen as much as its alpha says.
    [[nodiscard]] bool is_usable(const render::ImageTexture& image, bool is_own_alpha = false) {
        const PictureFacts facts = store_.facts(image.file);
        const bool is_seen_alone =
            is_own_alpha && (facts.alpha == AlphaKind::cut_out || !image.background);
        return facts.is_plain_colour && !image.is_linear && !store_.is_too_large(facts) &&
               (facts.alpha == AlphaKind::opaque || is_seen_alone);
    }
    [[nodiscard]] bool is_bare() const { return surface_.opacity.texture() != nullptr; }

    void add_base() {
        std::optional<TextureGroup> of_opacity = group(surface_.opacity);
        std::optional<TextureGroup> of_base = group(surface_.base);
        std::optional<TextureGroup> both;
        if (of_base && of_opacity && fit_together(of_base->shared, of_opacity->shared)) {
            both = group(surface_.base, surface_.opacity);
        }
        Vec3 factor = plain_.base;
        double alpha = plain_.opacity;
        bool is_transparent = alpha < 1;
        if (of_opacity) {  // a shape that is cut out matters more than a colour that does not fit
            of_base = both ? of_base : std::nullopt;
            Json texture;
            const AlphaKind kind = add_opacity(both && of_base ? *both : *of_opacity,
                                               of_base.has_value(), factor, texture);
            alpha = 1;
            is_transparent = kind == AlphaKind::varied;
            pbr_["baseColorTexture"] = std::move(texture);
            if (kind == AlphaKind::cut_out) {
                result_["alphaMode"] = "MASK";
                result_["alphaCutoff"] = kCutOut;
            }
        } else if (of_base) {
            factor = tint_of_base();
            pbr_["baseColorTexture"] = base_texture(*of_base);
        }
        pbr_["baseColorFactor"] = {factor.x, factor.y, factor.z, alpha};
        if (is_transparent) {
            result_["alphaMode"] = "BLEND";
        }
    }

    /// The tint of a lone picture remains a factor, which keeps the digits of dark colours.
    [[nodiscard]] Vec3 tint_of_base() const {
        const render::ImageTexture* image = lone_image(surface_.base);
        return image == nullptr ? Vec3(1, 1, 1) : image->tint;
    }
    [[nodiscard]] render::ColourSource untinted_base() const {
        const render::ImageTexture* image = lone_image(surface_.base);
        if (image == nullptr) {
            return surface_.base;
        }
        render::ImageTexture untinted = *image;
        untinted.tint = Vec3(1, 1, 1);
        return untinted;
    }

    Json base_texture(const TextureGroup& of_base) {
        const render::ImageTexture* image = lone_image(surface_.base);
        if (image != nullptr && is_usable(*image)) {
            return pictures_.file(of_base, image->file);
        }
        const render::ColourSource base = untinted_base();
        return pictures_
            .made(of_base, plain_.name + " base",
                  hash_of(is_bare() ? "bare colour" : "colour", base),
                  [&] {
                      return bake_colour(baked_grid(of_base, store_),
                                         colour_values(base, of_base, store_, is_bare()), {});
                  })
            .reference;
    }

    /// Opacity as the alpha of the base colour. Sets `factor`, which is that of the constant base,
    /// if the base is a texture.
    AlphaKind add_opacity(const TextureGroup& textures, bool has_base, Vec3& factor,
                          Json& texture) {
        factor = has_base ? tint_of_base() : factor;
        if (has_base && is_alpha_of_base()) {
            const std::string& file = lone_image(surface_.base)->file;
            texture = pictures_.file(textures, file);
            return store_.facts(file).alpha;
        }
        const render::ColourSource base =
            has_base ? untinted_base() : render::ColourSource(Vec3(1, 1, 1));
        const GltfTextures::Made made = pictures_.made(
            textures, plain_.name + " opacity", hash_of("cut out", base, surface_.opacity), [&] {
                return bake_colour(
                    baked_grid(textures, store_), colour_values(base, textures, store_, is_bare()),
                    number_values(surface_.opacity, textures, store_, NumberUse::mask));
            });
        texture = made.reference;
        // Making a picture smaller blurs the edges of what is cut out.
        return is_made_of_cut_out() && made.alpha != AlphaKind::opaque ? AlphaKind::cut_out
                                                                       : made.alpha;
    }

    /// Whether opacity is the whole range of a picture's alpha.
    [[nodiscard]] bool is_of_alpha(const render::ImageTexture& image) {
        const PictureFacts facts = store_.facts(image.file);
        return surface_.opacity.texture()->range == Vec2(0, 1) &&
               channel_of(image, facts, NumberUse::mask) == PictureChannel::alpha;
    }
    [[nodiscard]] bool is_made_of_cut_out() {
        const render::ImageTexture* image = lone_image(surface_.opacity);
        return image != nullptr && is_of_alpha(*image) &&
               store_.facts(image->file).alpha == AlphaKind::cut_out;
    }
    /// Whether one file has both, the colour and the alpha.
    [[nodiscard]] bool is_alpha_of_base() {
        const render::ImageTexture* image = lone_image(surface_.base);
        const render::ImageTexture* opacity = lone_image(surface_.opacity);
        return image != nullptr && opacity != nullptr && image->file == opacity->file &&
               placed(*image).tile == placed(*opacity).tile && is_of_alpha(*opacity) &&
               is_usable(*image, true);
    }

    /// The texture of numbers that one picture has, or null. Where a number is in the picture,
    /// `factors` is what it is multiplied by; otherwise its plain value. `is_shared`: glTF reads
    /// all of the channels from the same texture, also those of constant numbers.
    Json numbers_texture(const char* name, const std::vector<Slot>& slots, bool is_shared,
                         std::vector<double>& factors) {
        std::vector<PlacedTexture> textures;
        for (const Slot& slot : slots) {
            factors.push_back(slot.plain);
            if (!slot.is_constant) {
                add_textures(slot.number, textures);
            }
        }
        const std::optional<TextureGroup> shared =
            texture_group(std::move(textures), places_, store_);
        if (!shared) {
            return nullptr;
        }
        if (const std::string path = file_of(slots, is_shared); !path.empty()) {
            for (std::size_t i = 0; i < slots.size(); ++i) {
                if (varies(slots[i])) {
                    factors[i] = slots[i].number.texture()->range.y;
                }
            }
            return pictures_.file(*shared, path);
        }
        FieldHasher hasher(FileHash::stamp);
        hasher.add("numbers");
        for (std::size_t i = 0; i < slots.size(); ++i) {
            if (varies(slots[i])) {
                factors[i] = 1;
                hasher.add(slots[i].channel);
                hasher.add_value(slots[i].number);
            }
        }
        const auto make = [&] {
            std::vector<NumberAt> numbers(3);
            for (const Slot& slot : slots) {
                if (varies(slot)) {
                    const auto channel = static_cast<std::size_t>(slot.channel);
                    numbers.resize(std::max(numbers.size(), channel + 1));
                    numbers[channel] = number_values(slot.number, *shared, store_);
                }
            }
            return bake_numbers(baked_grid(*shared, store_), numbers);
        };
        return pictures_.made(*shared, plain_.name + " " + name, hasher.finish(), make).reference;
    }

    static bool varies(const Slot& slot) {
        return !slot.is_constant && slot.number.texture() != nullptr;
    }

    /// The file whose channels are these numbers, up to factors; empty if there is none.
    [[nodiscard]] std::string file_of(const std::vector<Slot>& slots, bool is_shared) {
        const render::ImageTexture* common = nullptr;
        for (const Slot& slot : slots) {
            if (!varies(slot)) {
                if (is_shared && slot.plain != 0) {
                    return {};
                }
                continue;
            }
            const render::ImageTexture* image = lone_image(slot.number);
            const bool is_same =
                image != nullptr &&
                (common == nullptr ||
                 (common->file == image->file && placed(*common).tile == placed(*image).tile));
            if (!is_same) {
                return {};
            }
            const PictureFacts facts = store_.facts(image->file);
            const PictureChannel channel = channel_of(*image, facts, NumberUse::usual);
            if (!facts.is_plain || store_.is_too_large(facts) ||
                slot.number.texture()->range.x != 0 || !is_as_stored(*image, channel, facts) ||
                !is_in_channel(channel, slot.channel, facts)) {
                return {};
            }
            common = image;
        }
        return common == nullptr ? "" : common->file;
    }

    /// Whether a number has to be constant beside another one.
    [[nodiscard]] bool is_left_out(const render::NumberSource& number,
                                   const render::NumberSource& beside) {
        const std::optional<TextureGroup> own = group(number);
        const std::optional<TextureGroup> other = group(beside);
        return !own || (other && !fit_together(own->shared, other->shared));
    }

    void add_metal() {
        const std::vector<Slot> slots{
            {surface_.roughness, plain_.roughness, 1, !group(surface_.roughness)},
            {surface_.metal, plain_.metal, 2, is_left_out(surface_.metal, surface_.roughness)}};
        std::vector<double> factors;
        Json texture = numbers_texture("roughness", slots, true, factors);
        pbr_["metallicFactor"] = factors[1];
        pbr_["roughnessFactor"] = factors[0];
        if (!texture.is_null()) {
            pbr_["metallicRoughnessTexture"] = std::move(texture);
        }
    }

    void add_relief() {
        const std::optional<TextureGroup> relief = group(surface_.relief);
        if (!relief) {
            return;
        }
        const auto* normal = std::get_if<render::NormalPicture>(&surface_.relief);
        Json texture = normal != nullptr && is_usable(*normal)
                           ? pictures_.file(*relief, normal->image.file)
                           : made_relief(*relief);
        if (normal != nullptr && normal->strength != 1) {
            texture["scale"] = normal->strength;
        }
        result_["normalTexture"] = std::move(texture);
    }

    [[nodiscard]] bool is_usable(const render::NormalPicture& normal) {
        const PictureFacts facts = store_.facts(normal.image.file);
        return facts.is_plain && !facts.is_grey() && !store_.is_too_large(facts);
    }

    Json made_relief(const TextureGroup& relief) {
        const auto make = [&] {
            return bake_normals(baked_grid(relief, store_),
                                normal_values(surface_.relief, relief, lengths_, store_));
        };
        return pictures_
            .made(relief, plain_.name + " relief", hash_of("relief", surface_.relief, lengths_),
                  make)
            .reference;
    }

    void add_emission() {
        Vec3 emission = plain_.emission;
        if (const std::optional<TextureGroup> textures = group(surface_.emission)) {
            emission = surface_.emission_strength * emission_texture(*textures);
        }
        if (!has_any(emission)) {
            result_.erase("emissiveTexture");  // multiplied by 0
            return;
        }
        const double strength = std::max({1.0, emission.x, emission.y, emission.z});
        result_["emissiveFactor"] = {emission.x / strength, emission.y / strength,
                                     emission.z / strength};
        if (strength > 1) {
            extend("KHR_materials_emissive_strength", {{"emissiveStrength", strength}});
        }
    }

    /// Adds the texture and returns its factor.
    Vec3 emission_texture(const TextureGroup& textures) {
        const render::ImageTexture* image = lone_image(surface_.emission);
        if (image != nullptr && is_usable(*image)) {
            result_["emissiveTexture"] = pictures_.file(textures, image->file);
            return image->tint;
        }
        const BakedGrid grid = baked_grid(textures, store_);
        const ColourAt colour = colour_values(surface_.emission, textures, store_);
        const float brightest = std::max(1.0F, largest_value(grid, colour));
        const auto dimmed = [&](const Vec2& c) { return colour(c) / brightest; };
        result_["emissiveTexture"] =
            pictures_
                .made(textures, plain_.name + " emission", hash_of("light", surface_.emission),
                      [&] { return bake_colour(grid, dimmed, {}); })
                .reference;
        return Vec3(static_cast<double>(brightest));
    }

    void add_coat() {
        const render::Coat& coat = surface_.coat;
        const std::vector<Slot> slots{
            {coat.weight, plain_.coat, 0, !group(coat.weight)},
            {coat.roughness, plain_.coat_roughness, 1, is_left_out(coat.roughness, coat.weight)}};
        if (plain_.coat <= 0 && slots[0].is_constant) {
            return;
        }
        std::vector<double> factors;
        const Json texture = numbers_texture("coat", slots, false, factors);
        Json values{{"clearcoatFactor", factors[0]}, {"clearcoatRoughnessFactor", factors[1]}};
        if (varies(slots[0])) {
            values["clearcoatTexture"] = texture;
        }
        if (varies(slots[1])) {
            values["clearcoatRoughnessTexture"] = texture;
        }
        if (result_.contains("normalTexture")) {
            values["clearcoatNormalTexture"] = result_["normalTexture"];
        }
        extend("KHR_materials_clearcoat", std::move(values));
    }

    void add_sheen() {
        const std::optional<TextureGroup> textures = group(surface_.sheen);
        Vec3 colour = plain_.sheen;
        Json values;
        if (textures) {
            colour = surface_.sheen_colour;
            const auto make = [&] {
                const NumberAt weight = number_values(surface_.sheen, *textures, store_);
                const auto grey = [&](const Vec2& c) { return Imath::V3f(weight(c)); };
                return bake_colour(baked_grid(*textures, store_), grey, {});
            };
            values["sheenColorTexture"] =
                pictures_
                    .made(*textures, plain_.name + " sheen", hash_of("sheen", surface_.sheen), make)
                    .reference;
        }
        if (has_any(colour)) {
            values["sheenColorFactor"] = {colour.x, colour.y, colour.z};
            values["sheenRoughnessFactor"] = kSheenRoughness;
            extend("KHR_materials_sheen", std::move(values));
        }
    }

    void add_specular() {
        std::vector<double> factors;
        Json texture = numbers_texture(
            "specular", {{surface_.specular, plain_.specular, 3, !group(surface_.specular)}}, false,
            factors);
        if (texture.is_null() && plain_.specular == 1) {
            return;
        }
        Json values{{"specularFactor", factors.front()}};
        if (!texture.is_null()) {
            values["specularTexture"] = std::move(texture);
        }
        extend("KHR_materials_specular", std::move(values));
    }

    const ExportMaterial& plain_;
    const std::vector<TexturePlace>& places_;
    Vec2 lengths_;  // of the relief
    GltfTextures& pictures_;
    PictureStore& store_;
    std::set<std::string>& extensions_;
    render::StandardMaterial surface_;  // without textures if there are none
    Json pbr_ = Json::object();
    Json result_ = Json::object();
};

}  // namespace

Json gltf_material(const ExportMaterial& material, const MaterialTextures& textures,
                   GltfTextures& pictures, PictureStore& store, std::set<std::string>& extensions) {
    return MaterialJson(material, textures, pictures, store, extensions).run();
}

}  // namespace carom::pipeline
