#include "render/texture/ball_paint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/texture/noise.h"

namespace carom::render {
namespace {

constexpr float kBandHalfWidth = 0.56f;  // of the stripe, in ball radii along the axis
constexpr float kSpotRadius = 0.105f;    // in ball radii
constexpr float kFinest = 1e-4f;         // narrowest edge, in ball radii
const V3f kInk{0.012f, 0.012f, 0.013f};
const V3f kSpotColour{0.52f, 0.02f, 0.018f};

V3f mix(const V3f& a, const V3f& b, float t) {
    return a + (b - a) * t;
}

/// Coverage by the inside of a circle around an axis. As seen from the axis, the circle has the
/// chord radius `radius` and the point the distance `distance`. Both are sines of angles; dividing
/// by the cosine turns them into lengths along the surface.
float inside_circle(float distance, float radius, float width) {
    return smooth_step((radius - distance) / std::sqrt(1.0f - radius * radius), width);
}

}  // namespace

BallPaint::BallPaint(const BallTexture& texture, std::shared_ptr<const CoverageMask> number)
    : colour_(texture.colour),
      white_(texture.white),
      striped_(texture.striped),
      disc_radius_(std::clamp(static_cast<float>(texture.disc_radius), 0.01f, 0.95f)),
      spots_(texture.spots),
      number_(std::move(number)) {}

V3f BallPaint::colour(const V3f& position, float footprint) const {
    const float radius = position.length();
    const V3f direction = position / radius;
    const float width = std::clamp(footprint / radius, kFinest, 2.0f);
    V3f result = colour_;
    if (striped_) {
        result = mix(white_, colour_, inside_circle(std::abs(direction.z), kBandHalfWidth, width));
    }
    if (number_) {
        result = with_number(result, direction, width);
    }
    if (spots_ > 0) {
        result = with_spots(result, direction, width);
    }
    return result;
}

V3f BallPaint::with_number(const V3f& below, const V3f& direction, float width) const {
    const float distance = std::sqrt(direction.y * direction.y + direction.z * direction.z);
    const float disc = inside_circle(distance, disc_radius_, width);
    if (disc <= 0) {
        return below;
    }
    // Seen from +x the right-hand side is +y, seen from -x it is -y.
    const float right = direction.x >= 0 ? direction.y : -direction.y;
    const float scale = 0.5f / disc_radius_;
    const float ink = number_->lookup(0.5f + right * scale, 0.5f - direction.z * scale,
                                      width * scale, Wrap::clamp, Wrap::clamp);
    return mix(below, mix(white_, kInk, ink), disc);
}

V3f BallPaint::with_spots(const V3f& below, const V3f& direction, float width) const {
    const V3f a{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    const float along = std::max({a.x, a.y, a.z});
    const float distance = std::sqrt(std::max(0.0f, 1.0f - along * along));
    return mix(below, kSpotColour, inside_circle(distance, kSpotRadius, width));
}

}  // namespace carom::render
