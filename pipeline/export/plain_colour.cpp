#include "pipeline/export/plain_colour.h"

#include "core/colour.h"

namespace carom::pipeline {

namespace {

constexpr double kPictureGrey = 0.5;

}  // namespace

Vec3 plain_colour(const render::ColourSource& source) {
    struct Visitor {
        Vec3 operator()(const Vec3& colour) const { return colour; }
        Vec3 operator()(const render::ImageTexture&) const { return Vec3(kPictureGrey); }
        Vec3 operator()(const render::BallTexture& ball) const { return ball.colour; }
        Vec3 operator()(const render::ClothTexture& cloth) const { return cloth.colour; }
        Vec3 operator()(const render::WoodTexture& wood) const {
            return (wood.light + wood.dark) / 2;
        }
        Vec3 operator()(const render::CheckerTexture& checker) const {
            return (checker.even + checker.odd) / 2;
        }
        Vec3 operator()(const std::shared_ptr<const render::MixTexture>& mix) const {
            const double by = plain_number(mix->by);
            return plain_colour(mix->a) * (1 - by) + plain_colour(mix->b) * by;
        }
    };
    return std::visit(Visitor{}, source);
}

double plain_number(const render::NumberSource& source) {
    const render::NumberTexture* texture = source.texture();
    if (texture == nullptr) {
        return source.constant_or(0);
    }
    const double value = luminance(Imath::V3f(plain_colour(texture->pattern)));
    return texture->range.x + (texture->range.y - texture->range.x) * value;
}

}  // namespace carom::pipeline
