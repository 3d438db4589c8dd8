#include "render/texture/texture.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/elementary.h"
#include "render/texture/cloth_tiles.h"

namespace carom::render {
namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
    using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

// The axis that a surface faces most: flat patterns are laid along the two others.
int facing_axis(const V3f& normal) {
    const V3f a{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    if (a.z >= a.x && a.z >= a.y) {
        return 2;
    }
    return a.x >= a.y ? 0 : 1;
}

V2f flat_place(const SurfacePoint& point) {
    const V3f& p = point.object_position;
    switch (facing_axis(point.geometric_normal)) {
        case 0:
            return {p.y, p.z};
        case 1:
            return {p.x, p.z};
        default:
            return {p.x, p.y};
    }
}

V3f lay_flat(const V2f& v, int axis) {
    switch (axis) {
        case 0:
            return {0, v.x, v.y};
        case 1:
            return {v.x, 0, v.y};
        default:
            return {v.x, v.y, 0};
    }
}

}  // namespace

std::shared_ptr<const ImagePyramid> ImageCache::file(const std::string& path, bool is_linear) {
    return images_.get({path, is_linear}, [&] { return load_image_pyramid(path, is_linear); });
}

std::shared_ptr<const CoverageMask> ImageCache::number(int number) {
    return numbers_.get(number, [&] { return draw_number(number); });
}

std::shared_ptr<const ClothTiles> ImageCache::cloth_tiles() {
    return cloth_tiles_.get(0, make_cloth_tiles);
}

Texture::Texture(const ColourSource& source, ImageCache& images)
    : source_(make_source(source, images)) {}

Texture::Source Texture::make_source(const ColourSource& source, ImageCache& images) {
    return std::visit(
        Overloaded{
            [](const Vec3& colour) -> Source { return V3f(colour); },
            [&](const ImageTexture& image) -> Source {
                const Vec2 repeats = image.size ? Vec2(1, 1) / *image.size : image.scale;
                const Vec2 turn(cosine(image.rotation), sine(image.rotation));
                return Image{images.file(image.file, image.is_linear), V2f(repeats),
                             image.size.has_value(), V2f(image.offset), V2f(turn)};
            },
            [&](const BallTexture& ball) -> Source {
                return BallPaint(ball, ball.number > 0 ? images.number(ball.number) : nullptr);
            },
            [&](const ClothTexture& cloth) -> Source {
                return ClothPattern(cloth, images.cloth_tiles());
            },
            [](const WoodTexture& wood) -> Source { return WoodPattern(wood); },
            [](const CheckerTexture& checker) -> Source { return CheckerPattern(checker); },
        },
        source);
}

V3f Texture::Image::colour(const SurfacePoint& point, float footprint) const {
    const V2f at = by_size ? point.uv * point.uv_metres : point.uv;
    const V2f turned(turn.x * at.x + turn.y * at.y, turn.x * at.y - turn.y * at.x);
    const V2f place = turned * repeats - offset;
    const float most = std::max(std::abs(repeats.x), std::abs(repeats.y));
    const float width = footprint * most * (by_size ? 1 : point.uv_per_metre);
    return pyramid->lookup(place.x, 1.0f - place.y, width, Wrap::repeat, Wrap::repeat);
}

V3f Texture::colour(const SurfacePoint& point, float footprint) const {
    return std::visit(
        Overloaded{
            [](const V3f& colour) { return colour; },
            [&](const Image& image) { return image.colour(point, footprint); },
            [&](const BallPaint& ball) { return ball.colour(point.object_position, footprint); },
            [&](const ClothPattern& cloth) {
                return cloth.evaluate(flat_place(point), footprint).colour;
            },
            [&](const WoodPattern& wood) { return wood.colour(point.object_position, footprint); },
            [&](const CheckerPattern& checker) {
                return checker.colour(point.object_position, point.geometric_normal, footprint);
            },
        },
        source_);
}

Texture::Relief Texture::relief(const SurfacePoint& point, float footprint) const {
    const ClothPattern* cloth = std::get_if<ClothPattern>(&source_);
    CAROM_ASSERT(cloth != nullptr);
    const ClothPattern::Value value = cloth->evaluate(flat_place(point), footprint);
    return {value.colour, -lay_flat(value.slope, facing_axis(point.geometric_normal))};
}

}  // namespace carom::render
