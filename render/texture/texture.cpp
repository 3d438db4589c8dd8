#include "render/texture/texture.h"

#include <cmath>

#include "core/assert.h"
#include "core/elementary.h"
#include "render/texture/patterns.h"

namespace carom::render {
namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
    using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

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

}  // namespace

std::shared_ptr<const ImagePyramid> ImageCache::file(const std::string& path, bool is_linear) {
    return images_.get({path, is_linear}, [&] { return load_image_pyramid(path, is_linear); });
}

std::shared_ptr<const SlopePicture> ImageCache::normals(const std::string& path) {
    return slopes_.get({path, std::nullopt}, [&] { return SlopePicture::of_normals(path); });
}

std::shared_ptr<const SlopePicture> ImageCache::heights(const std::string& path,
                                                        PictureChannel channel) {
    return slopes_.get({path, channel}, [&] { return SlopePicture::of_heights(path, channel); });
}

std::shared_ptr<const CoverageMask> ImageCache::number(int number) {
    return numbers_.get(number, [&] { return draw_number(number); });
}

std::shared_ptr<const ClothTiles> ImageCache::cloth_tiles() {
    return cloth_tiles_.get(0, make_cloth_tiles);
}

void Texture::set_picture(const ImageTexture& image, const ImageTables& picture) {
    data_.placement = placement_parameters(image.placement);
    data_.image.picture = picture;
    data_.image.repeats = V2f(image.size ? Vec2(1, 1) / *image.size : image.scale);
    data_.image.by_size = image.size.has_value();
    data_.image.offset = V2f(image.offset);
}

Texture::Texture(const ColourSource& source, ImageCache& images, bool is_bare) {
    const auto set_cloth = [&](const ClothTexture& cloth) {
        const auto tiles = images.cloth_tiles();
        data_.kind = TextureKind::cloth;
        data_.placement = placement_parameters(cloth.placement);
        data_.cloth = cloth_parameters(cloth, *tiles);
        pictures_ = tiles;
    };
    const auto set_ball = [&](const BallTexture& ball) {
        const auto number = ball.number > 0 ? images.number(ball.number) : nullptr;
        data_.kind = TextureKind::ball;
        data_.ball = ball_parameters(ball, number.get());
        pictures_ = number;
    };
    const auto set_image = [&](const ImageTexture& image) {
        const auto picture = images.file(image.file, image.is_linear);
        data_.kind = TextureKind::image;
        set_picture(image, picture->tables());
        data_.image.tint = V3f(image.tint);
        data_.image.background = V3f(image.background.value_or(kTransparentColour));
        data_.image.is_bare = is_bare && !image.background;
        pictures_ = picture;
    };
    const auto set_wood = [&](const WoodTexture& wood) {
        data_.kind = TextureKind::wood;
        data_.placement = placement_parameters(wood.placement);
        data_.wood = wood_parameters(wood);
    };
    const auto set_checker = [&](const CheckerTexture& checker) {
        data_.kind = TextureKind::checker;
        data_.placement = placement_parameters(checker.placement);
        data_.checker = checker_parameters(checker);
    };
    std::visit(Overloaded{[&](const Vec3& colour) { data_.plain = V3f(colour); }, set_image,
                          set_ball, set_cloth, set_wood, set_checker,
                          [](const std::shared_ptr<const MixTexture>&) { CAROM_ASSERT(false); }},
               source);
}

Texture::Texture(const NormalPicture& normals, ImageCache& images) {
    const auto picture = images.normals(normals.image.file);
    data_.kind = TextureKind::normals;
    set_picture(normals.image, picture->tables());
    pictures_ = picture;
}

Texture::Texture(const ImageTexture& heights, PictureChannel channel, ImageCache& images) {
    const auto picture = images.heights(heights.file, channel);
    data_.kind = TextureKind::heights;
    set_picture(heights, picture->tables());
    pictures_ = picture;
}

}  // namespace carom::render
