#include "pipeline/export/usda_materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/field_hasher.h"
#include "pipeline/export/textures/texture_values.h"

namespace carom::pipeline {

namespace {

using render::PictureChannel;

constexpr double kThrough = 0.9;  // of transmission, as transparency
constexpr double kCutOut = 0.5;   // the opacity below which a cut-out shows nothing
const std::array<const char*, 4> kChannels{"r", "g", "b", "a"};

/// A texture as a shader reads it: what it puts out is the picture times `scale` plus `bias`.
struct UsdaTexture {
    TextureGroup group;
    std::string asset;
    bool is_srgb = false;
    std::string output = "rgb";
    std::array<double, 4> scale{1, 1, 1, 1};
    std::array<double, 4> bias{0, 0, 0, 0};
    AlphaKind alpha = AlphaKind::opaque;
};

std::string numbers(const std::array<double, 4>& values) {
    return fmt::format("({}, {}, {}, {})", usda_number(static_cast<float>(values[0])),
                       usda_number(static_cast<float>(values[1])),
                       usda_number(static_cast<float>(values[2])),
                       usda_number(static_cast<float>(values[3])));
}

std::string pair(const Vec2& v) {
    return fmt::format("({}, {})", usda_number(static_cast<float>(v.x)),
                       usda_number(static_cast<float>(v.y)));
}

/// A path as USD writes it.
std::string marked(const std::string& path) {
    const std::string mark = path.find('@') == std::string::npos ? "@" : "@@@";
    return mark + path + mark;
}

/// The index of refraction whose reflectance straight on is `specular` of that of 1.5.
double ior_of(double specular) {
    const double root = std::sqrt(0.04 * std::clamp(specular, 0.0, 1.0));
    return (1 + root) / (1 - root);
}

/// Pictures that carom and other programs decode to the same values (UsdPreviewSurface
/// Specification, Texture Reader).
bool is_readable(const PictureFacts& facts) {
    return facts.is_plain || facts.format == PictureFormat::exr;
}

class MaterialWriter {
  public:
    MaterialWriter(UsdaText& text, const std::string& path, const ExportMaterial& plain,
                   const MaterialTextures& textures, UsdaPictures& pictures, PictureStore& store)
        : text_(text),
          path_(path.substr(0, path.size() - 1)),
          plain_(plain),
          textures_(textures),
          pictures_(pictures),
          store_(store) {
        if (textures.surface) {
            surface_ = *textures.surface;
        }
    }

    void run() {
        text_.line("token outputs:surface.connect = " + path_ + "/surface.outputs:surface>");
        text_.open("def Shader \"surface\"");
        text_.line("uniform token info:id = \"UsdPreviewSurface\"");
        colour("diffuseColor", plain_.base, base());
        colour("emissiveColor", plain_.emission, emission());
        number("metallic", plain_.metal, number_texture(surface_.metal, "metal"));
        number("roughness", plain_.roughness, number_texture(surface_.roughness, "roughness"));
        number("clearcoat", plain_.coat, number_texture(surface_.coat.weight, "coat"));
        number("clearcoatRoughness", plain_.coat_roughness,
               number_texture(surface_.coat.roughness, "coat roughness"));
        write_opacity();
        number("ior", plain_.transmission > 0 ? plain_.ior : ior_of(plain_.specular), {});
        if (auto texture = relief()) {
            connect("normal3f", "normal", std::move(*texture));
        }
        text_.line("token outputs:surface");
        text_.close();
        write_textures();
    }

  private:
    template <class Source>
    [[nodiscard]] std::optional<TextureGroup> group(const Source& source) {
        std::vector<PlacedTexture> textures;
        add_textures(source, textures);
        return texture_group(std::move(textures), textures_.places, store_);
    }

    template <class... Source>
    [[nodiscard]] static Hash128 hash_of(const char* use, const Source&... sources) {
        FieldHasher hasher(FileHash::stamp);
        hasher.add(use);
        (hasher.add_value(sources), ...);
        return hasher.finish();
    }

    [[nodiscard]] UsdaTexture made(TextureGroup textures, const std::string& use,
                                   const Hash128& hash, const std::function<BakedPicture()>& make) {
        const UsdaPictures::Made picture = pictures_.made(plain_.name + "_" + use, hash, make);
        UsdaTexture texture;
        texture.group = std::move(textures);
        texture.asset = picture.asset;
        texture.alpha = picture.alpha;
        return texture;
    }

    /// The picture of a lone texture if its file can be read as its colour. `is_bare`: as
    /// colour_values has it.
    [[nodiscard]] std::optional<UsdaTexture> colour_file(const TextureGroup& textures,
                                                         const render::ColourSource& source,
                                                         bool is_bare) {
        const auto* image = std::get_if<render::ImageTexture>(&source);
        if (image == nullptr) {
            return std::nullopt;
        }
        const PictureFacts facts = store_.facts(image->file);
        const bool is_hdr = facts.format == PictureFormat::exr;
        const bool decodes = is_hdr || (image->is_linear ? facts.is_plain : facts.is_plain_colour);
        // Colours of EXR files are multiplied by their alpha.
        const bool is_seen_alone = is_bare && !is_hdr && !image->background;
        if (!decodes || !(facts.alpha == AlphaKind::opaque || is_seen_alone)) {
            return std::nullopt;
        }
        UsdaTexture texture;
        texture.group = textures;
        texture.asset = pictures_.asset(image->file);
        texture.is_srgb = !is_hdr && !image->is_linear;
        texture.scale = {image->tint.x, image->tint.y, image->tint.z, 1};
        return texture;
    }

    [[nodiscard]] std::optional<UsdaTexture> base() {
        const std::optional<TextureGroup> textures = group(surface_.base);
        if (!textures) {
            return std::nullopt;
        }
        const bool is_bare = surface_.opacity.texture() != nullptr;
        if (auto file = colour_file(*textures, surface_.base, is_bare)) {
            return file;
        }
        const Hash128 hash = hash_of(is_bare ? "bare colour" : "colour", surface_.base);
        UsdaTexture texture = made(*textures, "base", hash, [&] {
            return bake_colour(baked_grid(*textures, store_),
                               colour_values(surface_.base, *textures, store_, is_bare), {});
        });
        texture.is_srgb = true;
        return texture;
    }

    [[nodiscard]] std::optional<UsdaTexture> emission() {
        const std::optional<TextureGroup> textures = group(surface_.emission);
        if (!textures) {
            return std::nullopt;
        }
        std::optional<UsdaTexture> texture = colour_file(*textures, surface_.emission, false);
        double strength = surface_.emission_strength;
        if (!texture) {
            const BakedGrid grid = baked_grid(*textures, store_);
            const ColourAt colour = colour_values(surface_.emission, *textures, store_);
            const float brightest = std::max(1.0F, largest_value(grid, colour));
            const auto dimmed = [&](const Vec2& c) { return colour(c) / brightest; };
            texture = made(*textures, "emission", hash_of("light", surface_.emission),
                           [&] { return bake_colour(grid, dimmed, {}); });
            texture->is_srgb = true;
            strength *= static_cast<double>(brightest);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            texture->scale[i] *= strength;
        }
        return texture;
    }

    static const render::ImageTexture* image_of(const render::NumberSource& number) {
        const render::NumberTexture* texture = number.texture();
        return texture == nullptr ? nullptr : std::get_if<render::ImageTexture>(&texture->pattern);
    }

    /// The channel of the picture's file that is the number; empty if it has to be made.
    [[nodiscard]] std::optional<std::size_t> channel_in_file(const render::ImageTexture& image,
                                                             NumberUse use) {
        const PictureFacts facts = store_.facts(image.file);
        const PictureChannel channel = channel_of(image, facts, use);
        if (!is_readable(facts) || !is_as_stored(image, channel, facts)) {
            return std::nullopt;
        }
        switch (channel) {
            case PictureChannel::red:
                return 0;
            case PictureChannel::green:
                return facts.is_grey() ? 0 : 1;
            case PictureChannel::blue:
                return facts.is_grey() ? 0 : 2;
            case PictureChannel::alpha:
                return 3;
            default:
                return facts.is_grey() ? std::optional<std::size_t>(0) : std::nullopt;
        }
    }

    [[nodiscard]] std::optional<UsdaTexture> number_texture(const render::NumberSource& number,
                                                            const char* name,
                                                            NumberUse use = NumberUse::usual) {
        const std::optional<TextureGroup> textures = group(number);
        if (!textures) {
            return std::nullopt;
        }
        const render::ImageTexture* image = image_of(number);
        const auto channel = image != nullptr ? channel_in_file(*image, use) : std::nullopt;
        if (!channel) {
            UsdaTexture texture =
                made(*textures, name,
                     hash_of(use == NumberUse::mask ? "opacity" : "number", number), [&] {
                         const NumberAt value = number_values(number, *textures, store_, use);
                         return bake_numbers(baked_grid(*textures, store_), {value, value, value});
                     });
            texture.output = "r";
            return texture;
        }
        const Vec2 range = number.texture()->range;
        UsdaTexture texture;
        texture.group = *textures;
        texture.asset = pictures_.asset(image->file);
        texture.output = kChannels[*channel];
        texture.scale[*channel] = range.y - range.x;
        texture.bias[*channel] = range.x;
        texture.alpha = *channel == 3 ? store_.facts(image->file).alpha : AlphaKind::varied;
        return texture;
    }

    void write_opacity() {
        const double solid = 1 - kThrough * plain_.transmission;
        std::optional<UsdaTexture> texture =
            number_texture(surface_.opacity, "opacity", NumberUse::mask);
        const bool is_cut_out = texture && is_all_or_nothing(*texture);
        if (texture) {
            for (std::size_t i = 0; i < 4; ++i) {
                texture->scale[i] *= solid;
                texture->bias[i] *= solid;
            }
        }
        number("opacity", plain_.opacity * solid, std::move(texture));
        if (is_cut_out) {
            text_.line("float inputs:opacityThreshold = " + usda_number(kCutOut));
        }
    }

    /// Whether the opacity is 0 or 1 everywhere.
    [[nodiscard]] bool is_all_or_nothing(const UsdaTexture& texture) {
        if (texture.output == "a") {
            return texture.alpha == AlphaKind::cut_out &&
                   surface_.opacity.texture()->range == Vec2(0, 1);
        }
        const NumberAt value =
            number_values(surface_.opacity, texture.group, store_, NumberUse::mask);
        const BakedGrid grid = baked_grid(texture.group, store_);
        for (int y = 0; y < grid.height; ++y) {
            for (int x = 0; x < grid.width; ++x) {
                const float one = value(grid.centre(x, y));
                if (one > 0 && one < 1) {
                    return false;
                }
            }
        }
        return true;
    }

    [[nodiscard]] bool is_usable(const render::NormalPicture& normal) {
        const PictureFacts facts = store_.facts(normal.image.file);
        return facts.is_plain && !facts.is_grey();
    }

    [[nodiscard]] std::optional<UsdaTexture> relief() {
        const std::optional<TextureGroup> textures = group(surface_.relief);
        if (!textures) {
            return std::nullopt;
        }
        const auto* normal = std::get_if<render::NormalPicture>(&surface_.relief);
        const double strength = normal != nullptr ? normal->strength : 1;
        UsdaTexture texture;
        if (normal != nullptr && is_usable(*normal)) {
            texture.group = *textures;
            texture.asset = pictures_.asset(normal->image.file);
        } else {
            const Vec2& lengths = textures_.relief_lengths;
            texture = made(*textures, "relief", hash_of("relief", surface_.relief, lengths), [&] {
                return bake_normals(baked_grid(*textures, store_),
                                    normal_values(surface_.relief, *textures, lengths, store_));
            });
        }
        texture.scale = {2 * strength, 2 * strength, 2, 1};
        texture.bias = {-strength, -strength, -1, 0};
        return texture;
    }

    void colour(const std::string& name, const Vec3& plain, std::optional<UsdaTexture> texture) {
        if (texture) {
            connect("color3f", name, std::move(*texture));
        } else {
            text_.line("color3f inputs:" + name + " = " + usda_tuple(plain));
        }
    }

    void number(const std::string& name, double plain, std::optional<UsdaTexture> texture) {
        if (texture) {
            connect("float", name, std::move(*texture));
        } else {
            text_.line("float inputs:" + name + " = " + usda_number(static_cast<float>(plain)));
        }
    }

    void connect(const std::string& type, const std::string& name, UsdaTexture texture) {
        text_.line(fmt::format("{} inputs:{}.connect = {}/{}_texture.outputs:{}>", type, name,
                               path_, name, texture.output));
        used_.emplace_back(name, std::move(texture));
    }

    /// Writes the shaders that read pictures, and those that say where.
    void write_textures() {
        std::vector<bool> is_read(textures_.places.size(), false);
        for (const auto& [name, texture] : used_) {
            const std::size_t place = texture.group.coordinates;
            std::string source = fmt::format("{}/{}.outputs:result>", path_, reader_of(place));
            if (!is_read[place]) {
                is_read[place] = true;
                write_reader(place);
            }
            if (!(texture.group.shared.tile == TextureTile{})) {
                write_transform(name + "_place", texture.group.shared.tile, source);
                source = fmt::format("{}/{}_place.outputs:result>", path_, name);
            }
            write_texture(name, texture, source);
        }
    }

    static std::string reader_of(std::size_t place) { return usda_coordinates(place) + "_reader"; }

    void write_reader(std::size_t place) {
        text_.open("def Shader \"" + reader_of(place) + "\"");
        text_.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
        text_.line("string inputs:varname = \"" + usda_coordinates(place) + "\"");
        text_.line("float2 outputs:result");
        text_.close();
    }

    void write_transform(const std::string& name, const TextureTile& tile,
                         const std::string& source) {
        text_.open("def Shader \"" + name + "\"");
        text_.line("uniform token info:id = \"UsdTransform2d\"");
        text_.line("float2 inputs:in.connect = " + source);
        text_.line("float2 inputs:scale = " + pair(tile.repeats));
        text_.line("float2 inputs:translation = " + pair(-tile.offset));
        text_.line("float2 outputs:result");
        text_.close();
    }

    void write_texture(const std::string& name, const UsdaTexture& texture,
                       const std::string& source) {
        text_.open("def Shader \"" + name + "_texture\"");
        text_.line("uniform token info:id = \"UsdUVTexture\"");
        text_.line("asset inputs:file = " + texture.asset);
        text_.line(std::string("token inputs:sourceColorSpace = \"") +
                   (texture.is_srgb ? "sRGB\"" : "raw\""));
        text_.line("token inputs:wrapS = \"repeat\"");
        text_.line("token inputs:wrapT = \"repeat\"");
        text_.line("float2 inputs:st.connect = " + source);
        if (texture.scale != UsdaTexture{}.scale) {
            text_.line("float4 inputs:scale = " + numbers(texture.scale));
        }
        if (texture.bias != UsdaTexture{}.bias) {
            text_.line("float4 inputs:bias = " + numbers(texture.bias));
        }
        text_.line((texture.output == "rgb" ? "float3" : "float") + (" outputs:" + texture.output));
        text_.close();
    }

    UsdaText& text_;
    std::string path_;  // with the mark that opens it
    const ExportMaterial& plain_;
    const MaterialTextures& textures_;
    UsdaPictures& pictures_;
    PictureStore& store_;
    render::StandardMaterial surface_;                       // without textures if there are none
    std::vector<std::pair<std::string, UsdaTexture>> used_;  // by the input that they give
};

}  // namespace

std::string UsdaPictures::asset(const std::string& file) const {
    const std::string path = exported_path(file, folder_);
    return marked(path.starts_with("..") || path.starts_with("/") ? path : "./" + path);
}

UsdaPictures::Made UsdaPictures::made(const std::string& name, const Hash128& hash,
                                      const std::function<BakedPicture()>& make) {
    const auto known = made_.find(hash);
    if (known != made_.end()) {
        return known->second;
    }
    EncodedPicture picture = encode(make(), PictureFormat::png);
    const std::string file = names_.unique(name) + ".png";
    const Made result{marked("./" + made_folder_ + "/" + file), picture.alpha};
    files_.push_back({made_folder_ + "/" + file, std::move(picture.bytes)});
    made_.emplace(hash, result);
    return result;
}

void write_usda_material(UsdaText& text, const std::string& path, const ExportMaterial& material,
                         const MaterialTextures& textures, UsdaPictures& pictures,
                         PictureStore& store) {
    MaterialWriter(text, path, material, textures, pictures, store).run();
}

std::string usda_coordinates(std::size_t index) {
    return index == 0 ? "st" : fmt::format("st{}", index);
}

}  // namespace carom::pipeline
