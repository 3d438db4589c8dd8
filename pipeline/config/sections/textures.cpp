#include "pipeline/config/sections/textures.h"

#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "pipeline/config/sections/placement_keys.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/value_types.h"
#include "pipeline/shot/material_textures.h"

namespace carom::pipeline::config {

namespace {

using render::ColourSource;
using render::HeightTexture;
using render::ImageTexture;
using render::MixTexture;
using render::NormalPicture;
using render::NumberSource;
using render::NumberTexture;
using render::PictureChannel;

constexpr int kDeepestMix = 4;

// ---- pictures -------------------------------------------------------------------------------

constexpr const char* kEncoding =
    "whether the values of the picture are linear, whatever its file says. Otherwise integers are "
    "sRGB-encoded unless the file names another gamma, and floating-point numbers are linear";

/// Adds the keys that all pictures have. `of_encoding`: what `is_linear` means.
void add_picture_keys(MapSpec<ImageTexture>& s, FileKind kind, const char* of_encoding) {
    s.key("file", &ImageTexture::file, file(kind), "the picture").required();
    s.key("scale", &ImageTexture::scale, vector2(Dimension::none, above_up_to(0, 1e4)),
          "numbers of repetitions along u and v; with `planar` and `box` those in a metre");
    s.key("size", &ImageTexture::size, vector2(Dimension::length, above_up_to(0, 1e4)),
          "instead of `scale`: width and height of the picture. By `uv` they are lengths on flat "
          "shapes, on cylinders and, around the equator, on spheres");
    s.key("offset", &ImageTexture::offset, vector2(Dimension::none),
          "translation of the picture along u and v, in widths and heights of the picture");
    add_placement_keys(s, "`uv`", "the corner where u and v are 0");
    s.key("is_linear", &ImageTexture::is_linear, boolean(), of_encoding);
    s.at_most_one_of({"scale", "size"});
}

void add_background(MapSpec<ImageTexture>& s, const char* of_what) {
    s.key("background", &ImageTexture::background, colour(between(0, 1)),
          std::string(of_what) +
              " where the picture is transparent. The default is 0.8, with a warning");
    s.check([](Reader& reader, const Node& node, ImageTexture& image) {
        if (image.background || image.channel == PictureChannel::alpha) {
            reader.set_background(node.find("file")->value);
        }
    });
}

/// A picture whose colours are seen.
const MapSpec<ImageTexture>& image_spec() {
    static const MapSpec<ImageTexture> spec = [] {
        MapSpec<ImageTexture> s("image", "A picture.");
        add_picture_keys(s, FileKind::texture, kEncoding);
        s.key("tint", &ImageTexture::tint, colour(between(0, 1)), "factor on the colours");
        add_background(s, "colour that is seen");
        s.refuse("channel",
                 "has no meaning where a colour is wanted; it chooses the number that a picture "
                 "gives 'roughness' and the like");
        return s;
    }();
    return spec;
}

/// A picture that gives a number.
const MapSpec<ImageTexture>& number_image_spec() {
    static const MapSpec<ImageTexture> spec = [] {
        MapSpec<ImageTexture> s("number image",
                                "A picture of numbers: black is 0, white is 1. The values of its "
                                "file are not sRGB-decoded.");
        add_picture_keys(s, FileKind::texture,
                         "has no effect here, because numbers are always linear");
        s.key("channel", &ImageTexture::channel,
              choice<PictureChannel>({{"auto", PictureChannel::automatic},
                                      {"red", PictureChannel::red},
                                      {"green", PictureChannel::green},
                                      {"blue", PictureChannel::blue},
                                      {"alpha", PictureChannel::alpha},
                                      {"luminance", PictureChannel::luminance}}),
              "what of the picture is the number. `auto` is the luminance, but for an `opacity` "
              "and the `by` of a mix the alpha of a picture that has it");
        add_background(s, "colour that counts");
        s.refuse("range", "belongs beside 'image', not in it");
        s.refuse("tint",
                 "has no meaning where a number is wanted; 'range' says what black and white mean");
        return s;
    }();
    return spec;
}

/// A picture of normals.
const MapSpec<ImageTexture>& normal_image_spec() {
    static const MapSpec<ImageTexture> spec = [] {
        MapSpec<ImageTexture> s("normal image",
                                "A picture of normals: red points along u, green along v (as in "
                                "OpenGL) and blue outwards. The values of its file are not "
                                "sRGB-decoded.");
        add_picture_keys(s, FileKind::normals,
                         "has no effect here, because normals are always linear");
        s.refuse("channel", "has no meaning for normals, which are in red, green and blue");
        for (const char* key : {"tint", "background"}) {
            s.refuse(key, "has no meaning for normals, which are no colours");
        }
        return s;
    }();
    return spec;
}

/// The name of a picture's file, or a map of these keys.
ValueType<ImageTexture> picture(FileKind kind, const MapSpec<ImageTexture>& keys) {
    const auto by_file = convert<ImageTexture>(file(kind), [](std::string path) {
        ImageTexture texture;
        texture.file = std::move(path);
        return texture;
    });
    return any_of<ImageTexture>({{is_scalar, by_file}, {is_map, record(keys)}});
}

// ---- patterns -------------------------------------------------------------------------------

constexpr const char* kOwnAxes = "the pattern's own, in the object's axes";
constexpr const char* kOrigin = "the origin of the pattern";

const MapSpec<render::ClothTexture>& cloth_spec() {
    static const MapSpec<render::ClothTexture> spec = [] {
        MapSpec<render::ClothTexture> s("cloth", "Woven cloth with a nap.");
        s.key("colour", &render::ClothTexture::colour, colour(between(0, 1)), "mean albedo");
        s.key("thread", &render::ClothTexture::thread, length(inside(0, 1)),
              "spacing of the weave");
        s.key("variation", &render::ClothTexture::variation, number(between(0, 1)),
              "relative variation of the colour");
        s.key(
            "wear", &render::ClothTexture::wear, number(between(0, 1)),
            "how long it has been played on: mottles, chalk, tracks of balls along the cushions of "
            "a table, burns where it is racked and broken");
        s.key("seed", &render::ClothTexture::seed, integer(0, 1000000), "another wear for each");
        s.key("nap", &render::ClothTexture::nap, number(between(-1, 1)),
              "how much brighter the cloth is when one looks against its nap, which lies along x; "
              "negative: along -x");
        add_placement_keys(s, kOwnAxes, kOrigin);
        return s;
    }();
    return spec;
}

const MapSpec<render::WoodTexture>& wood_spec() {
    static const MapSpec<render::WoodTexture> spec = [] {
        MapSpec<render::WoodTexture> s("wood", "Wood with rings along a grain.");
        s.key("light", &render::WoodTexture::light, colour(between(0, 1)),
              "colour of the early wood");
        s.key("dark", &render::WoodTexture::dark, colour(between(0, 1)), "colour of the late wood");
        s.key("ring", &render::WoodTexture::ring, length(inside(0, 10)),
              "mean spacing of the rings");
        s.key("grain", &render::WoodTexture::grain, vector3(Dimension::none),
              "direction of the grain in the object's axes");
        add_placement_keys(s, kOwnAxes, kOrigin);
        s.check([](Reader& reader, const Node& node, render::WoodTexture& wood) {
            if (wood.grain.length() < 1e-9) {
                reader.error(node.find("grain")->value.place,
                             "'grain' must not be the zero vector");
            }
        });
        return s;
    }();
    return spec;
}

const MapSpec<render::CheckerTexture>& checker_spec() {
    static const MapSpec<render::CheckerTexture> spec = [] {
        MapSpec<render::CheckerTexture> s("checker", "Squares of two colours.");
        s.key("even", &render::CheckerTexture::even, colour(between(0, 1)), "first colour");
        s.key("odd", &render::CheckerTexture::odd, colour(between(0, 1)), "second colour");
        s.key("size", &render::CheckerTexture::size, length(inside(0, 1000)),
              "edge length of a square");
        add_placement_keys(s, kOwnAxes, kOrigin);
        return s;
    }();
    return spec;
}

const MapSpec<render::SmudgesTexture>& smudges_spec() {
    static const MapSpec<render::SmudgesTexture> spec = [] {
        MapSpec<render::SmudgesTexture> s(
            "smudges",
            "Prints of fingers and hairline scratches around the middle of a ball: 0 "
            "where it is clean.");
        s.key("amount", &render::SmudgesTexture::amount, number(between(0, 1)),
              "from none to six prints and sixteen scratches");
        s.key("seed", &render::SmudgesTexture::seed, integer(0, 1000000), "others for each");
        return s;
    }();
    return spec;
}

// ---- textures of colours and numbers --------------------------------------------------------

constexpr const char* kTextureExample = "a texture such as {image: wood.png}";

/// Reads with `type`, but a word is told how a texture is written. `constant`: "a number".
template <class V>
ValueType<V> with_hint_of_texture(ValueType<V> type, const std::string& constant) {
    type.read = [constant, read = type.read](Reader& reader, const Node& node) -> std::optional<V> {
        if (is_word(node) && !node.text.starts_with('#')) {
            reader.wrong_type(node, constant + " or " + kTextureExample);
            return std::nullopt;
        }
        return read(reader, node);
    };
    return type;
}

/// The maps of keys that contain each other. They are made together, so that a type may refer to a
/// map whose keys are still to be added.
class TextureSpecs {
  public:
    static const TextureSpecs& get() {
        static const TextureSpecs specs;
        return specs;
    }

    TextureSpecs(const TextureSpecs&) = delete;
    TextureSpecs& operator=(const TextureSpecs&) = delete;

    /// `constant`: the type of a colour that is not a texture.
    [[nodiscard]] ValueType<ColourSource> colour_source(const Range& range) const {
        const auto constant = with_hint_of_texture(
            convert<ColourSource>(colour(range), [](const Vec3& c) -> ColourSource { return c; }),
            "a colour such as \"#1a6b3c\"");
        ValueType<ColourSource> result =
            any_of<ColourSource>({{is_map, record(colour_)}, {is_no_map, constant}});
        result.show = [](const ColourSource& source) {
            const Vec3* colour = std::get_if<Vec3>(&source);
            return colour == nullptr ? std::string() : vector3(Dimension::none).show(*colour);
        };
        return result;
    }

    [[nodiscard]] ValueType<NumberSource> fraction_source() const {
        const auto constant = with_hint_of_texture(
            convert<NumberSource>(number(between(0, 1)),
                                  [](double value) { return NumberSource(value); }),
            "a number");
        const auto texture = convert<NumberSource>(
            record(number_), [](NumberTexture n) { return NumberSource(std::move(n)); });
        ValueType<NumberSource> result =
            any_of<NumberSource>({{is_no_map, constant}, {is_map, texture}});
        result.show = [](const NumberSource& source) {
            return source.texture() == nullptr ? number().show(source.constant_or(0))
                                               : std::string();
        };
        return result;
    }

    [[nodiscard]] const MapSpec<HeightTexture>& height() const { return height_; }

  private:
    TextureSpecs() {
        add_kinds(colour_, image_spec());
        colour_.refuse("range", "has no meaning where a colour is wanted");
        add_kinds(number_, number_image_spec());
        number_.key("range", &NumberTexture::range, vector2(Dimension::none, between(0, 1)),
                    "what black and white mean; the first may be the larger one");
        add_kinds(height_, number_image_spec());
        height_.key("depth", &HeightTexture::depth, length(between(-1, 1)),
                    "how much higher white is than black; negative: lower");
        for (const char* key : {"range", "strength"}) {
            height_.refuse(key, "has no meaning; 'depth' says how high white is");
        }
        fill_mix();
    }

    static bool is_no_map(const Node& node) { return !node.is_map(); }

    static ColourSource& pattern_of(ColourSource& source) { return source; }
    static ColourSource& pattern_of(NumberTexture& number) { return number.pattern; }
    static ColourSource& pattern_of(HeightTexture& height) { return height.number.pattern; }

    /// Adds the kinds of textures, of which one must be given.
    template <class T>
    void add_kinds(MapSpec<T>& s, const MapSpec<ImageTexture>& image) const {
        const auto store = [](T& target, auto texture) { pattern_of(target) = std::move(texture); };
        s.set("image", picture(FileKind::texture, image), store,
              "a picture: the name of its file, or a map");
        s.set("cloth", record(cloth_spec()), store, "woven cloth");
        s.set("wood", record(wood_spec()), store, "wood");
        s.set("checker", record(checker_spec()), store, "squares of two colours");
        s.set("ball", record(ball_texture_spec()), store, "a billiard ball");
        s.set("smudges", record(smudges_spec()), store, "prints and scratches on a ball");
        s.set(
            "mix", record(mix_),
            [](T& target, MixTexture mix) {
                pattern_of(target) = std::make_shared<const MixTexture>(std::move(mix));
            },
            "two colours or textures, mixed");
        s.exactly_one_of({"image", "cloth", "wood", "checker", "ball", "smudges", "mix"});
        for (const char* key : {"mapping", "facing", "rotate", "scale", "size", "offset",
                                "background", "is_linear", "channel", "tint"}) {
            s.refuse(key, std::string(
                              "belongs in the map of its kind, as in {image: {file: wood.png, ") +
                              key + ": ...}}");
        }
        s.refuse("file",
                 "belongs in the map of a picture, as in {image: {file: wood.png, mapping: box}}");
    }

    void fill_mix() {
        const ValueType<ColourSource> side = colour_source(between(0, 1));
        mix_.key("a", &MixTexture::a, side, "colour or a texture where `by` is 0");
        mix_.key("b", &MixTexture::b, side, "colour or a texture where `by` is 1");
        mix_.key("by", &MixTexture::by, fraction_source(),
                 "the share of `b`: a number or a texture of one");
        mix_.check(check_mix);
    }

    static void check_mix(Reader& reader, const Node& node, MixTexture& mix) {
        if (depth_of(mix) == kDeepestMix + 1) {  // only once, however many are around it
            reader.error(reader.key_place(), reader.label() + " has mixes in mixes, more than " +
                                                 std::to_string(kDeepestMix) + " deep");
        }
        const NumberTexture* by = mix.by.texture();
        if (const ImageTexture* mask = by == nullptr ? nullptr : mask_of(*by)) {
            const bool is_b_opaque = by->range.x < by->range.y;
            for (const char* side : {"by", is_b_opaque ? "b" : "a"}) {
                if (const Entry* entry = node.find(side)) {
                    const Reader::Scope scope(reader, entry->key, entry->key_place);
                    reader.set_cut_out(mask->file);
                }
            }
        }
    }

    MapSpec<ColourSource> colour_{"texture", "A colour that varies over the surface.",
                                  ColourSource(Vec3(0, 0, 0))};
    MapSpec<NumberTexture> number_{
        "number texture",
        "A number that varies over the surface: that of a picture, or the luminance of another "
        "texture.",
        NumberTexture{Vec3(0, 0, 0)}};
    MapSpec<HeightTexture> height_{
        "height",
        "A relief: the bright parts of a texture are higher. Its slopes are shaded; the surface "
        "itself stays as it is.",
        HeightTexture{NumberTexture{Vec3(0, 0, 0)}}};
    MapSpec<MixTexture> mix_{
        "texture mix", "Two colours or textures, mixed. Mixes may contain mixes, up to 4 deep."};
};

const MapSpec<NormalPicture>& normal_spec() {
    static const MapSpec<NormalPicture> spec = [] {
        MapSpec<NormalPicture> s("normal", "A relief by a picture of normals.");
        s.key("image", &NormalPicture::image, picture(FileKind::normals, normal_image_spec()),
              "the picture: the name of its file, or a map")
            .required();
        s.key("strength", &NormalPicture::strength, number(between(0, 10)),
              "factor on the slopes; 0: flat");
        s.refuse("file", "belongs in the map of a picture, as in {image: {file: normals.png}}");
        return s;
    }();
    return spec;
}

}  // namespace

const ImageTexture* mask_of(const NumberTexture& number) {
    const auto* image = std::get_if<ImageTexture>(&number.pattern);
    const bool may_be_alpha = image != nullptr && (image->channel == PictureChannel::automatic ||
                                                   image->channel == PictureChannel::alpha);
    return may_be_alpha ? image : nullptr;
}

ValueType<ColourSource> colour_source(const Range& range) {
    return TextureSpecs::get().colour_source(range);
}

ValueType<NumberSource> fraction_source() {
    return TextureSpecs::get().fraction_source();
}

ValueType<NormalPicture> normal_picture() {
    const auto by_file = convert<NormalPicture>(file(FileKind::normals), [](std::string path) {
        NormalPicture normal;
        normal.image.file = std::move(path);
        return normal;
    });
    return any_of<NormalPicture>({{is_scalar, by_file}, {is_map, record(normal_spec())}});
}

ValueType<HeightTexture> height_texture() {
    ValueType<HeightTexture> type = record(TextureSpecs::get().height());
    type.read = [read = type.read](Reader& reader, const Node& node) {
        if (!node.is_map()) {
            reader.wrong_type(node, kTextureExample);
            return std::optional<HeightTexture>();
        }
        return read(reader, node);
    };
    return type;
}

}  // namespace carom::pipeline::config
