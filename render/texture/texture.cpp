#include "render/texture/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/assert.h"
#include "core/elementary.h"
#include "core/splitmix.h"

namespace carom::render {
namespace {

constexpr float kSmallest = 1e-5F;  // thread, ring or cube, m

PlacementParameters placement_parameters(const Placement& placement) {
    PlacementParameters parameters;
    parameters.mapping = placement.mapping;
    parameters.turn = V2f(Vec2(cosine(placement.rotation), sine(placement.rotation)));
    // Upright as seen from the side `facing`; from above and below with y up.
    const Vec3 towards = placement.facing.normalized();
    const Vec3 rising = Vec3(0, 0, 1) - towards * towards.z;
    const Vec3 up = rising.length() > 1e-6 ? rising.normalized() : Vec3(0, 1, 0);
    parameters.up = V3f(up);
    parameters.right = V3f(up.cross(towards));
    return parameters;
}

void set_picture(const ImageTexture& image, const ImageTables& picture, TextureData& data) {
    data.placement = placement_parameters(image.placement);
    data.image.picture = picture;
    data.image.repeats = V2f(image.size ? Vec2(1, 1) / *image.size : image.scale);
    data.image.by_size = image.size.has_value();
    data.image.offset = V2f(image.offset);
}

Vec3 random_direction(SplitMix64& random) {
    const double z = random.between(-1, 1);
    const double turn = random.between(0, 2 * std::numbers::pi);
    const double width = std::sqrt(1 - z * z);
    return {width * cosine(turn), width * sine(turn), z};
}

/// What seeds noise in kernels.
std::uint32_t random_word(SplitMix64& random) {
    return static_cast<std::uint32_t>(random.next() >> 32U);
}

SmudgesParameters smudges_parameters(const SmudgesTexture& smudges) {
    using P = SmudgesParameters;
    SplitMix64 random(static_cast<std::uint64_t>(smudges.seed));
    P parameters;
    parameters.amount = std::clamp(static_cast<float>(smudges.amount), 0.0F, 1.0F);
    parameters.seed = random_word(random);
    const auto part_of = [&](int most) {
        return static_cast<int>(std::lround(static_cast<float>(most) * parameters.amount));
    };
    parameters.prints = part_of(P::kMostPrints);
    parameters.hairlines = part_of(P::kMostHairlines);
    for (int k = 0; k < P::kMostPrints; ++k) {
        const Vec3 middle = random_direction(random);
        parameters.print_middle[k] = V3f(middle);
        parameters.print_across[k] = V3f(middle.cross(random_direction(random)).normalized());
    }
    for (int k = 0; k < P::kMostHairlines; ++k) {
        parameters.line_axis[k] = V3f(random_direction(random));
        parameters.line_middle[k] = V3f(random_direction(random));
    }
    return parameters;
}

/// Makes a texture of each kind of ColourSource. Patterns are band-limited: detail finer than the
/// width of a pixel on the surface fades into its mean, so that distant surfaces do not turn into
/// noise.
struct TextureMaker {
    ImageCache& images;
    TextureData& data;
    std::shared_ptr<const void>& pictures;

    void operator()(const Vec3& colour) const { data.plain = V3f(colour); }

    void operator()(const std::shared_ptr<const MixTexture>& /*mix*/) const { CAROM_ASSERT(false); }

    void operator()(const ImageTexture& image) const {
        const auto picture = images.file(image.file, image.is_linear);
        data.kind = TextureKind::image;
        set_picture(image, picture->tables(), data);
        data.image.tint = V3f(image.tint);
        data.image.background = V3f(image.background.value_or(kTransparentColour));
        pictures = picture;
    }

    void operator()(const BallTexture& ball) const {
        const auto number = ball.number > 0 ? images.number(ball.number) : nullptr;
        data.kind = TextureKind::ball;
        data.ball = {V3f(ball.colour),
                     V3f(ball.white),
                     ball.striped,
                     ball.spots > 0,
                     std::clamp(static_cast<float>(ball.disc_radius), 0.01F, 0.95F),
                     std::clamp(static_cast<float>(ball.band_width), 0.01F, 0.99F),
                     number != nullptr ? number->tables() : PyramidTables{}};
        pictures = number;
    }

    void operator()(const ClothTexture& cloth) const {
        const auto tiles = images.cloth_tiles();
        data.kind = TextureKind::cloth;
        data.placement = placement_parameters(cloth.placement);
        data.cloth = {V3f(cloth.colour),
                      std::max(static_cast<float>(cloth.thread), kSmallest),
                      static_cast<float>(cloth.variation),
                      tiles->weave.tables(),
                      tiles->nap.tables(),
                      tiles->wear.tables(),
                      std::clamp(static_cast<float>(cloth.wear), 0.0F, 1.0F)};
        SplitMix64 random(static_cast<std::uint64_t>(cloth.seed));
        data.cloth.wear_seed = random_word(random);
        constexpr double kMostShift = 4;  // m
        data.cloth.wear_shift.x = static_cast<float>(random.between(0, kMostShift));
        data.cloth.wear_shift.y = static_cast<float>(random.between(0, kMostShift));
        data.cloth.bed = V2f(static_cast<float>(cloth.bed.x), static_cast<float>(cloth.bed.y));
        constexpr float kMostOfNap = 0.3F;
        data.cloth.brightness_along_nap = kMostOfNap * static_cast<float>(cloth.nap);
        pictures = tiles;
    }

    void operator()(const SmudgesTexture& smudges) const {
        data.kind = TextureKind::smudges;
        data.smudges = smudges_parameters(smudges);
    }

    void operator()(const WoodTexture& wood) const {
        const V3f grain(wood.grain);
        const V3f along = grain.length2() > 0 ? grain.normalized() : V3f(1, 0, 0);
        const V3f least = std::abs(along.z) < 0.9F ? V3f(0, 0, 1) : V3f(1, 0, 0);
        const V3f across = least.cross(along).normalized();
        data.kind = TextureKind::wood;
        data.placement = placement_parameters(wood.placement);
        data.wood = {
            V3f(wood.light), V3f(wood.dark), std::max(static_cast<float>(wood.ring), kSmallest),
            along,           across,         along.cross(across)};
    }

    void operator()(const CheckerTexture& checker) const {
        data.kind = TextureKind::checker;
        data.placement = placement_parameters(checker.placement);
        data.checker = {V3f(checker.even), V3f(checker.odd),
                        std::max(static_cast<float>(checker.size), kSmallest)};
    }
};

}  // namespace

std::shared_ptr<const ImagePyramid> ImageCache::file(const std::string& path, bool is_linear) {
    return images_.get({path, is_linear},
                       [&] { return load_image_pyramid(path, is_linear, read_); });
}

std::shared_ptr<const SlopePicture> ImageCache::normals(const std::string& path) {
    return slopes_.get({path, std::nullopt}, [&] { return SlopePicture::of_normals(path, read_); });
}

std::shared_ptr<const SlopePicture> ImageCache::heights(const std::string& path,
                                                        PictureChannel channel) {
    return slopes_.get({path, channel},
                       [&] { return SlopePicture::of_heights(path, channel, read_); });
}

std::shared_ptr<const CoverageMask> ImageCache::number(int number) {
    return numbers_.get(number, [&] { return draw_number(number); });
}

std::shared_ptr<const ClothTiles> ImageCache::cloth_tiles() {
    return cloth_tiles_.get(0, make_cloth_tiles);
}

Texture::Texture(const ColourSource& source, ImageCache& images, bool is_bare) {
    std::visit(TextureMaker{images, data_, pictures_}, source);
    const auto* image = std::get_if<ImageTexture>(&source);
    data_.image.is_bare = is_bare && image != nullptr && !image->background;
}

Texture::Texture(const NormalPicture& normals, ImageCache& images) {
    const auto picture = images.normals(normals.image.file);
    data_.kind = TextureKind::normals;
    set_picture(normals.image, picture->tables(), data_);
    pictures_ = picture;
}

Texture::Texture(const ImageTexture& heights, PictureChannel channel, ImageCache& images) {
    const auto picture = images.heights(heights.file, channel);
    data_.kind = TextureKind::heights;
    set_picture(heights, picture->tables(), data_);
    pictures_ = picture;
}

}  // namespace carom::render
