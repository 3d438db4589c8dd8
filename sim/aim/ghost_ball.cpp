#include "sim/aim/ghost_ball.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "sim/billiards/layout.h"

namespace carom::sim {
namespace {

constexpr double kPi = std::numbers::pi;

double length_of(const Vec2& v) {
    return std::sqrt(v.dot(v));
}

/// The z component of the cross product: positive if `b` is to the left of `a`.
double leftness(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

PocketMouth& nearest_mouth(std::vector<PocketMouth>& mouths, const Vec2& point) {
    return *std::min_element(mouths.begin(), mouths.end(),
                             [&](const PocketMouth& a, const PocketMouth& b) {
                                 return length_of(a.middle - point) < length_of(b.middle - point);
                             });
}

void add_end(std::vector<PocketMouth>& mouths, const Vec2& centre, double nearest) {
    PocketMouth& mouth = nearest_mouth(mouths, centre);
    const std::size_t side = leftness(mouth.axis, centre - mouth.middle) > 0 ? 0 : 1;
    mouth.ends[side] = centre;
    mouth.nearest[side] = nearest;
}

}  // namespace

double angle_of(const Vec2& vector) {
    return arctangent2(vector.y, vector.x);
}

Vec2 unit_at(double angle) {
    const SinCos at = sin_cos(angle);
    return {at.cos, at.sin};
}

double wrapped(double angle) {
    return angle - 2 * kPi * std::ceil((angle - kPi) / (2 * kPi));
}

double touching_distance(double radius, double other_radius) {
    return 2 * std::sqrt(radius * other_radius);
}

std::optional<double> passing_direction(const Vec2& from, const Vec2& to, double offset) {
    const double distance = length_of(to - from);
    if (std::abs(offset) >= distance) {
        return std::nullopt;
    }
    return wrapped(angle_of(to - from) + arcsine(offset / distance));
}

std::vector<PocketMouth> pocket_mouths(const billiards::TableMeasures& table, double ball_radius) {
    std::vector<PocketMouth> mouths;
    if (!table.has_cushions) {
        return mouths;
    }
    const billiards::TableLayout layout = billiards::make_layout(table, ball_radius);
    for (const billiards::PocketLayout& pocket : layout.pockets) {
        mouths.push_back(
            {pocket.pocket.name, pocket.pocket.centre, pocket.mouth, pocket.axis, {}, {}});
    }
    // The nose is drawn inside of the line that the ball's foremost point touches.
    const double reach = ball_radius - layout.nose_inset;
    for (const billiards::CushionLayout& cushion : layout.cushions) {
        if (cushion.jaw_from) {
            const double u = cushion.from + cushion.jaw_from->lip_tangent_length;
            add_end(mouths, cushion.side.at(u, cushion.lip_radius_from),
                    cushion.lip_radius_from + reach);
        }
        if (cushion.jaw_to) {
            const double u = cushion.to - cushion.jaw_to->lip_tangent_length;
            add_end(mouths, cushion.side.at(u, cushion.lip_radius_to),
                    cushion.lip_radius_to + reach);
        }
    }
    return mouths;
}

PocketWindow window_of(const PocketMouth& pocket, const Vec2& from) {
    if ((pocket.middle - from).dot(pocket.axis) <= 0) {  // it lies in the mouth
        return {angle_of(pocket.centre - from), kPi};
    }
    const double towards = angle_of(pocket.middle - from);
    std::array<double, 2> limits{};
    for (std::size_t side = 0; side < 2; ++side) {
        const Vec2 end = pocket.ends[side] - from;
        const double turn = arcsine(std::min(pocket.nearest[side] / length_of(end), 1.0));
        limits[side] = wrapped(angle_of(end) - towards) + (side == 0 ? -turn : turn);
    }
    return {wrapped(towards + 0.5 * (limits[0] + limits[1])), limits[0] - limits[1]};
}

const billiards::LyingBall* first_in_way(const std::vector<billiards::LyingBall>& balls,
                                         const Vec2& from, const Vec2& to, double radius,
                                         const std::vector<std::string_view>& except) {
    const double length = length_of(to - from);
    if (!(length > 0)) {
        return nullptr;
    }
    const Vec2 direction = (to - from) / length;
    const billiards::LyingBall* first = nullptr;
    double first_along = std::numeric_limits<double>::infinity();
    for (const billiards::LyingBall& ball : balls) {
        if (std::find(except.begin(), except.end(), ball.name) != except.end()) {
            continue;
        }
        const double along = std::clamp((ball.place - from).dot(direction), 0.0, length);
        // A ball that it touches at its start and leaves is not in the way.
        const bool is_left = along == 0;
        const double distance = length_of(ball.place - (from + direction * along));
        if (!is_left && distance < touching_distance(radius, ball.radius) && along < first_along) {
            first = &ball;
            first_along = along;
        }
    }
    return first;
}

}  // namespace carom::sim
