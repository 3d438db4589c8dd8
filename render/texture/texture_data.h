// Textures as plain data, which formulas over lanes read. All pointers are borrowed.
#pragma once

#include <cstdint>

#include "render/geometry/ray.h"
#include "render/geometry/texture_needs.h"
#include "render/lanes/list.h"
#include "render/scene/texture_words.h"

namespace carom::render {

/// See MipPyramid::tables. Indices count texels from `texels` on, all bytes of which fit an
/// integer. A level is stored row by row, with a border of one texel all around.
struct PyramidTables {
    List<std::uint8_t> texels;  // of any type; without a picture they don't exist
    List<std::int32_t> first;   // by level: the index of its upper left texel
    List<std::int32_t> width;   // by level, without the border
    List<std::int32_t> height;
    float longest_side = 0;  // of the finest level, texels
    bool repeats = false;    // beyond [0, 1] the picture repeats; otherwise its edge is continued

    template <class Visit>
    void each_list(const Visit& visit) {
        visit(texels, first, width, height);
    }
};

/// See ImagePyramid.
struct ImageTables {
    PyramidTables levels;  // of half-float colours or numbers; with codes, without the finest one
    bool is_grey = false;
    bool has_alpha = false;  // of which colours are multiples; not with codes
    /// The finest level as the file has it, row by row without a border, if it exists. Colours are
    /// three codes, one after the other.
    List<std::uint8_t> codes;  // of 8 or 16 bits
    List<float> values;        // of the codes
    bool has_16_bits = false;  // each code, instead of 8
    int width = 0;             // of the finest level
    int height = 0;

    template <class Visit>
    void each_list(const Visit& visit) {
        visit(codes, values);
        levels.each_list(visit);
    }
};

/// Where a texture lies (Placement).
struct PlacementParameters {
    Mapping mapping = Mapping::own;
    V3f right{1, 0, 0}, up{0, 1, 0};  // planar: in object axes
    V2f turn{1, 0};                   // cosine and sine of the rotation
};

/// A picture laid onto a surface.
struct ImageParameters {
    ImageTables picture;
    V2f repeats{1, 1};  // along u and v; with `by_size`: per metre
    bool by_size = false;
    V2f offset{0, 0};
    V3f tint{1, 1, 1};
    V3f background{0, 0, 0};  // shown where it is transparent...
    bool is_bare = false;     // ... or else, the colour of what is opaque there
};

/// The paint of a billiard ball. Solid: one colour; striped: white with a band of the colour around
/// the z axis. A number stands in a white disc at both ends of the x axis, upright (z up) as seen
/// from that side. Edges are computed, and are as sharp as the pixel allows at any distance; only
/// the digits are looked up.
struct BallParameters {
    V3f colour{0, 0, 0};
    V3f white{0, 0, 0};
    bool is_striped = false;
    bool has_spots = false;
    float disc_radius = 0;      // chord radius in ball radii
    float band_half_width = 0;  // of the stripe, along the axis, in ball radii
    PyramidTables number;       // of coverage; without texels: no number
};

/// Plain weave under a brushed nap, with faint broad variations from wear. See ClothTiles.
struct ClothParameters {
    V3f colour{0, 0, 0};
    float thread = 0;  // m
    float variation = 0;
    PyramidTables weave;      // of half-float numbers
    PyramidTables nap, wear;  // of signed numbers
    float wear_amount = 0;    // [0, 1]
    std::uint32_t wear_seed = 0;
    V2f wear_shift{0, 0};  // of what does not depend on the table, m
    V2f bed{0, 0};         // half the sides of the table's field, m; 0: there is none
    float brightness_along_nap = 0;
};

/// Prints and scratches on a ball; a number, as grey.
struct SmudgesParameters {
    static constexpr int kMostPrints = 6;
    static constexpr int kMostHairlines = 16;

    float amount = 0;        // [0, 1]
    std::uint32_t seed = 0;  // of the film of grease
    int prints = 0, hairlines = 0;
    // Directions from the ball's middle. NOLINTBEGIN(*-avoid-c-arrays): a device has no std::array
    V3f print_middle[kMostPrints];
    V3f print_across[kMostPrints];    // at right angles to its length
    V3f line_axis[kMostHairlines];    // a scratch is part of a circle around it...
    V3f line_middle[kMostHairlines];  // ... on this side
    // NOLINTEND(*-avoid-c-arrays)
};

/// Growth rings of a tree whose trunk is along the grain, cut by the surface, with fibres and
/// pores.
struct WoodParameters {
    V3f light{0, 0, 0}, dark{0, 0, 0};
    float ring = 0;                                    // m
    V3f along{1, 0, 0}, across{0, 1, 0}, up{0, 0, 1};  // orthonormal
};

/// Cubes of two colours, box-filtered exactly along each axis.
struct CheckerParameters {
    V3f even{0, 0, 0}, odd{0, 0, 0};
    float size = 0;  // m
};

/// A number that a texture gives at a point: its value or one channel of it, of which 0 and 1 mean
/// these two numbers.
struct NumberPick {
    std::int32_t texture = -1;  // place in the material's list; -1: `at_zero` everywhere
    PictureChannel channel = PictureChannel::luminance;
    float at_zero = 0;
    float at_one = 1;
};

/// Two textures of the material's list, and how much the second one counts.
struct MixParameters {
    std::int32_t a = 0, b = 0;
    NumberPick by;
};

/// `normals` and `heights`: pictures of slopes (relief_picture.h).
enum class TextureKind : std::uint8_t {
    plain,
    image,
    ball,
    cloth,
    wood,
    checker,
    smudges,
    mix,
    normals,
    heights
};

/// A texture of any kind. Only the numbers of that kind count; they lie side by side, since a
/// device has no std::variant. A kind needs a case in `value_of` (kernels/texture.h).
struct TextureData {
    TextureKind kind = TextureKind::plain;
    PlacementParameters placement;
    V3f plain{0, 0, 0};
    ImageParameters image;
    BallParameters ball;
    ClothParameters cloth;
    WoodParameters wood;
    CheckerParameters checker;
    SmudgesParameters smudges;
    MixParameters mix;

    /// Calls `visit` with every list.
    template <class Visit>
    void each_list(const Visit& visit) {
        image.picture.each_list(visit);
        ball.number.each_list(visit);
        cloth.weave.each_list(visit);
        cloth.nap.each_list(visit);
        cloth.wear.each_list(visit);
    }
};

/// The relief of a surface.
struct ReliefParameters {
    /// `own`: of the cloth that is the base; `slopes`: of a picture, kind `normals` or `heights`;
    /// `differences`: of any textures, from three places of them.
    enum class Kind : std::uint8_t { none, own, slopes, differences };
    Kind kind = Kind::none;
    float strength = 0;                // factor on slopes; of heights: m
    std::int32_t texture = -1;         // of `slopes`
    NumberPick height;                 // of `differences`...
    std::int32_t first = 0, last = 0;  // ... and the textures that it depends on
};

/// The textures of a material, and what they are for.
struct MaterialTextures {
    static constexpr int kMost = 40;  // in the list: 12 mixes, each of two constants, and others

    /// In the scene's list. A mix follows what it mixes; what only light and opacity need comes
    /// last.
    std::int32_t first = 0;
    std::int32_t count = 0;
    std::int32_t of_surface = 0;  // as many from the first one on describe how it scatters
    std::int32_t base = 0;        // place in the list
    std::int32_t emission = -1;   // likewise; -1: constant
    float emission_strength = 1;
    NumberPick numbers[kTexturedNumbers];  // NOLINT(*-avoid-c-arrays): a device has no std::array
    NumberPick opacity;
    ReliefParameters relief;
    TextureNeeds needs;
    bool only_base = true;  // the rest of what scatters is constant, without slopes of pictures
    bool varies = false;    // the numbers do
};

/// Cells along the sides of ClothTiles: threads of the weave, cells of the nap's noise, and the
/// coarsest cells of the noise of wear.
struct ClothCells {
    static constexpr int kThreads = 64;
    static constexpr int kNap = 64;
    static constexpr int kWear = 16;
};

}  // namespace carom::render
