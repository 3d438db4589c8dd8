// Materials as plain data: the layered `standard` material, the classic `phong` one, and the
// textures of both. `fields_of` lists the fields of each in the order in which they are hashed
// (core/fields.h).
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/fields.h"
#include "core/vectors.h"
#include "render/scene/texture_words.h"

namespace carom::render {

/// The place of a texture on a surface.
struct Placement {
    Mapping mapping = Mapping::own;
    Vec3 facing{0, 0, 1};  // planar: the side, in object axes, from which the texture is upright
    double rotation = 0;   // counter-clockwise about the texture's origin, rad

    bool operator==(const Placement&) const = default;
};
constexpr auto fields_of(Describes<Placement>) {
    using T = Placement;
    return fields<T>(field("mapping", &T::mapping), field("facing", &T::facing),
                     field("rotation", &T::rotation));
}

/// An image file; its lower left corner is at uv (0, 0). With a mapping in metres one repeat is 1
/// m.
struct ImageTexture {
    std::string file;            // absolute path
    Vec2 scale{1, 1};            // repeats along u and v
    bool is_linear = false;      // false: sRGB-encoded colour. Numbers are always linear
    std::optional<Vec2> size{};  // instead of `scale`: width and height of the picture, m
    Vec2 offset{0, 0};           // translation along u and v, in widths and heights of the picture
    Placement placement{};
    std::optional<Vec3> background{};  // shown where it is transparent; none: kTransparentColour
    Vec3 tint{1, 1, 1};                // factor on the colour
    PictureChannel channel = PictureChannel::automatic;

    [[nodiscard]] Vec3 mean_colour() const { return tint * 0.5; }  // which is not known
    bool operator==(const ImageTexture&) const = default;
};
constexpr auto fields_of(Describes<ImageTexture>) {
    using T = ImageTexture;
    return fields<T>(file_field("file", &T::file), field("scale", &T::scale),
                     field("is_linear", &T::is_linear), field("size", &T::size),
                     field("offset", &T::offset), field("placement", &T::placement),
                     field("background", &T::background), field("tint", &T::tint),
                     field("channel", &T::channel));
}

/// The colour of a material without one of its own.
inline constexpr Vec3 kTransparentColour{0.8, 0.8, 0.8};

/// A billiard ball, painted in object axes: solid or striped, with a number in a white disc at both
/// ends of the x axis; 0 means no number.
struct BallTexture {
    Vec3 colour{1, 1, 1};
    Vec3 white{0.9, 0.87, 0.78};
    bool striped = false;
    int number = 0;
    double disc_radius = 0.385;  // of the number's disc, in ball radii
    double band_width = 0.5;     // of the stripe, in ball diameters
    int spots = 0;               // small red dots, as on training balls (0, 6)

    /// A colour that stands for all of it, as those of the other kinds.
    [[nodiscard]] Vec3 mean_colour() const { return colour; }
};
constexpr auto fields_of(Describes<BallTexture>) {
    using T = BallTexture;
    return fields<T>(field("colour", &T::colour), field("white", &T::white),
                     field("striped", &T::striped), field("number", &T::number),
                     field("disc_radius", &T::disc_radius), field("band_width", &T::band_width),
                     field("spots", &T::spots));
}

/// Woven cloth with a nap: small variations of colour in world or object xy.
struct ClothTexture {
    Vec3 colour{0.02, 0.22, 0.14};
    double thread = 0.0004;   // spacing of the weave, m
    double variation = 0.15;  // relative
    double wear = 0;          // [0, 1]: chalk, tracks of balls, burns
    int seed = 0;             // of the wear
    Vec2 bed{0, 0};  // half the length and width of the table's field, around the origin; 0: wear
                     // is the same everywhere
    double nap = 0;  // [-1, 1]: by how much it is brighter seen against the nap, which lies along x
    Placement placement{};

    [[nodiscard]] Vec3 mean_colour() const { return colour; }
};
constexpr auto fields_of(Describes<ClothTexture>) {
    using T = ClothTexture;
    return fields<T>(field("colour", &T::colour), field("thread", &T::thread),
                     field("variation", &T::variation), field("wear", &T::wear),
                     field("seed", &T::seed), field("bed", &T::bed), field("nap", &T::nap),
                     field("placement", &T::placement));
}

struct WoodTexture {
    Vec3 light{0.35, 0.17, 0.07};
    Vec3 dark{0.13, 0.05, 0.02};
    double ring = 0.012;  // mean spacing of the grain, m
    Vec3 grain{1, 0, 0};  // direction of the grain in object axes
    Placement placement{};

    [[nodiscard]] Vec3 mean_colour() const { return (light + dark) / 2; }
};
constexpr auto fields_of(Describes<WoodTexture>) {
    using T = WoodTexture;
    return fields<T>(field("light", &T::light), field("dark", &T::dark), field("ring", &T::ring),
                     field("grain", &T::grain), field("placement", &T::placement));
}

struct CheckerTexture {
    Vec3 even{0.8, 0.8, 0.8};
    Vec3 odd{0.2, 0.2, 0.2};
    double size = 0.1;  // of a square, m
    Placement placement{};

    [[nodiscard]] Vec3 mean_colour() const { return (even + odd) / 2; }
};
constexpr auto fields_of(Describes<CheckerTexture>) {
    using T = CheckerTexture;
    return fields<T>(field("even", &T::even), field("odd", &T::odd), field("size", &T::size),
                     field("placement", &T::placement));
}

/// Prints of fingers and hairline scratches on a ball, in object axes: 0 where it is clean.
struct SmudgesTexture {
    double amount = 0.5;  // [0, 1]
    int seed = 0;

    [[nodiscard]] Vec3 mean_colour() const { return Vec3(0.2, 0.2, 0.2) * amount; }
};
constexpr auto fields_of(Describes<SmudgesTexture>) {
    using T = SmudgesTexture;
    return fields<T>(field("amount", &T::amount), field("seed", &T::seed));
}

struct MixTexture;

/// A colour, constant or varying over the surface.
using ColourSource =
    std::variant<Vec3, ImageTexture, BallTexture, ClothTexture, WoodTexture, CheckerTexture,
                 SmudgesTexture, std::shared_ptr<const MixTexture>>;

/// A number that varies over the surface: of a picture its channel, of any other texture the
/// luminance of its colour, 0 meaning `range.x` and 1 meaning `range.y`.
struct NumberTexture {
    ColourSource pattern;  // not a constant
    Vec2 range{0, 1};
};
constexpr auto fields_of(Describes<NumberTexture>) {
    using T = NumberTexture;
    return fields<T>(field("pattern", &T::pattern), field("range", &T::range));
}

/// A number, constant or varying over the surface.
class NumberSource {
  public:
    NumberSource(double value = 0) : source_(value) {}  // NOLINT(google-explicit-constructor)
    NumberSource(NumberTexture texture)                 // NOLINT(google-explicit-constructor)
        : source_(std::make_shared<const NumberTexture>(std::move(texture))) {}

    /// Null: it is constant.
    [[nodiscard]] const NumberTexture* texture() const {
        const auto* texture = std::get_if<Texture>(&source_);
        return texture == nullptr ? nullptr : texture->get();
    }
    /// `otherwise`: of a texture.
    [[nodiscard]] double constant_or(double otherwise) const {
        const auto* value = std::get_if<double>(&source_);
        return value == nullptr ? otherwise : *value;
    }
    /// The largest value that it may have. Of pictures and patterns it is unknown: the larger end
    /// of the range.
    [[nodiscard]] double most() const {
        const NumberTexture* varying = texture();
        return varying == nullptr ? constant_or(0) : std::max(varying->range.x, varying->range.y);
    }

    friend const auto& hashed_part(const NumberSource& number) { return number.source_; }

  private:
    using Texture = std::shared_ptr<const NumberTexture>;
    std::variant<double, Texture> source_;
};

/// `a` where `by` is 0, `b` where it is 1.
struct MixTexture {
    ColourSource a = Vec3{0, 0, 0};
    ColourSource b = Vec3{1, 1, 1};
    NumberSource by = 0.5;
};
constexpr auto fields_of(Describes<MixTexture>) {
    using T = MixTexture;
    return fields<T>(field("a", &T::a), field("b", &T::b), field("by", &T::by));
}

/// Directions of normals in a picture's red, green and blue: along u, along v and outwards, -1 to 1
/// as 0 to 1.
struct NormalPicture {
    ImageTexture image;
    double strength = 1;  // factor on the slopes
};
constexpr auto fields_of(Describes<NormalPicture>) {
    using T = NormalPicture;
    return fields<T>(field("image", &T::image), field("strength", &T::strength));
}

/// A relief: at 1 it is `depth` higher than at 0. Its slopes are shaded; the surface stays flat.
struct HeightTexture {
    NumberTexture number;
    double depth = 0.001;  // m
};
constexpr auto fields_of(Describes<HeightTexture>) {
    using T = HeightTexture;
    return fields<T>(field("number", &T::number), field("depth", &T::depth));
}

using Relief = std::variant<std::monostate, NormalPicture, HeightTexture>;

struct Coat {
    NumberSource weight = 0;     // [0, 1]
    double ior = 1.5;            // [1, 3]
    NumberSource roughness = 0;  // [0, 1]
};
constexpr auto fields_of(Describes<Coat>) {
    return fields<Coat>(field("weight", &Coat::weight), field("ior", &Coat::ior),
                        field("roughness", &Coat::roughness));
}

/// Layers from the bottom up: diffuse base, metal or glass, sheen, coat. Glass fills the inside of
/// a closed surface with outward normals.
struct StandardMaterial {
    ColourSource base = Vec3{0.8, 0.8, 0.8};  // albedo, each channel in [0, 1]
    NumberSource metal = 0;                   // [0, 1]: base becomes the reflectance of a metal
    NumberSource roughness = 0.5;  // [0, 1] of the base's specular lobe (GGX alpha = roughness^2)
    NumberSource specular = 0;     // [0, 1] weight of the base's own dielectric highlight, ior 1.5
    double transmission = 0;  // [0, 1] fraction of the base that is glass, rough by `roughness`
    double ior = 1.5;         // [1, 3] of the glass
    /// The fraction of light that remains after `transmission_depth` m of glass; with a depth of 0
    /// it applies at each surface instead.
    Vec3 transmission_colour{1, 1, 1};
    double transmission_depth = 0;
    NumberSource sheen = 0;  // [0, 1] weight
    Vec3 sheen_colour{1, 1, 1};
    double bump = 0;  // strength of the texture's own relief, [0, 1] (cloth)
    Relief relief;    // of all layers
    Coat coat;
    ColourSource emission = Vec3{0, 0, 0};  // times the strength: radiance of its front, W/(m^2 sr)
    double emission_strength = 1;
    NumberSource opacity = 1;  // [0, 1] fraction of rays that meet the surface
};
constexpr auto fields_of(Describes<StandardMaterial>) {
    using T = StandardMaterial;
    return fields<T>(
        field("base", &T::base), field("metal", &T::metal), field("roughness", &T::roughness),
        field("specular", &T::specular), field("transmission", &T::transmission),
        field("ior", &T::ior), field("transmission_colour", &T::transmission_colour),
        field("transmission_depth", &T::transmission_depth), field("sheen", &T::sheen),
        field("sheen_colour", &T::sheen_colour), field("bump", &T::bump),
        field("relief", &T::relief), field("coat", &T::coat), field("emission", &T::emission),
        field("emission_strength", &T::emission_strength), field("opacity", &T::opacity));
}

/// A number that a texture may give; `key`: as shots name it.
struct TexturedParameter {
    std::string_view key;
    const NumberSource* number;
};

/// All of them, in the order of TexturedNumber.
[[nodiscard]] inline std::array<TexturedParameter, kTexturedNumbers> textured_parameters(
    const StandardMaterial& m) {
    return {{{"metal", &m.metal},
             {"roughness", &m.roughness},
             {"specular", &m.specular},
             {"sheen", &m.sheen},
             {"coat.weight", &m.coat.weight},
             {"coat.roughness", &m.coat.roughness}}};
}

/// The classic model: the terms of Phong 1975, "Illumination for computer generated pictures", and
/// the reflected and refracted rays of Whitted 1980 ("An improved illumination model for shaded
/// display"), spread as in Cook, Porter and Carpenter 1984 ("Distributed ray tracing"). The
/// `distributed` integrator does not enforce energy conservation: diffuse, specular, reflectance
/// and transmittance should add up to at most 1. The `path` integrator renders it as PhongLobes,
/// which conserve energy.
struct PhongMaterial {
    std::optional<Vec3> ambient;  // colour under the ambient light; none: that of `diffuse`
    ColourSource diffuse = Vec3{0.8, 0.8, 0.8};
    Vec3 specular{0, 0, 0};           // colour of the highlights of lights
    double shininess = 20;            // exponent of the highlights, [0, 1e6]
    Vec3 reflectance{0, 0, 0};        // of the mirror direction
    double reflectance_spread = 0;    // standard deviation from the mirror direction, rad
    Vec3 transmittance{0, 0, 0};      // of the refracted direction
    double transmittance_spread = 0;  // standard deviation from the refracted direction, rad
    double index = 1.5;               // of refraction, of the inside over the outside, [0.1, 10]
    Vec3 emission{0, 0, 0};           // radiance of its front, W/(m^2 sr)
};
constexpr auto fields_of(Describes<PhongMaterial>) {
    using T = PhongMaterial;
    return fields<T>(field("ambient", &T::ambient), field("diffuse", &T::diffuse),
                     field("specular", &T::specular), field("shininess", &T::shininess),
                     field("reflectance", &T::reflectance),
                     field("reflectance_spread", &T::reflectance_spread),
                     field("transmittance", &T::transmittance),
                     field("transmittance_spread", &T::transmittance_spread),
                     field("index", &T::index), field("emission", &T::emission));
}

inline constexpr double kWidestPhongSpread = 1.5;  // rad

struct MaterialDescription {
    std::string name;
    StandardMaterial surface;
    std::optional<PhongMaterial> phong{};  // if set, replaces `surface`
};
constexpr auto fields_of(Describes<MaterialDescription>) {
    using T = MaterialDescription;
    return fields<T>(unhashed("name", &T::name, "only mattes show it: frame_key adds it for them"),
                     field("surface", &T::surface), field("phong", &T::phong));
}

}  // namespace carom::render
