#include "render/texture/texture.h"

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

}  // namespace

std::shared_ptr<const ImagePyramid> ImageCache::file(const ImageTexture& image) {
    const Vec3 colour = image.background.value_or(kTransparentColour);
    return images_.get(
        {image.file, image.is_linear, Background{colour.x, colour.y, colour.z}},
        [&] { return load_image_pyramid(image.file, image.is_linear, V3f(colour)); });
}

std::shared_ptr<const CoverageMask> ImageCache::number(int number) {
    return numbers_.get(number, [&] { return draw_number(number); });
}

std::shared_ptr<const ClothTiles> ImageCache::cloth_tiles() {
    return cloth_tiles_.get(0, make_cloth_tiles);
}

Texture::Texture(const ColourSource& source, ImageCache& images) {
    const auto set_cloth = [&](const ClothTexture& cloth) {
        const auto tiles = images.cloth_tiles();
        data_.kind = TextureKind::cloth;
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
        const auto picture = images.file(image);
        const Vec2 repeats = image.size ? Vec2(1, 1) / *image.size : image.scale;
        const Vec2 turn(cosine(image.placement.rotation), sine(image.placement.rotation));
        data_.kind = TextureKind::image;
        data_.image = {picture->tables(), V2f(repeats), image.size.has_value(), V2f(image.offset),
                       V2f(turn)};
        pictures_ = picture;
    };
    const auto set_wood = [&](const WoodTexture& wood) {
        data_.kind = TextureKind::wood;
        data_.wood = wood_parameters(wood);
    };
    const auto set_checker = [&](const CheckerTexture& checker) {
        data_.kind = TextureKind::checker;
        data_.checker = checker_parameters(checker);
    };
    std::visit(Overloaded{[&](const Vec3& colour) { data_.plain = V3f(colour); }, set_image,
                          set_ball, set_cloth, set_wood, set_checker,
                          [&](const std::shared_ptr<const MixTexture>&) {}},
               source);
}

}  // namespace carom::render
