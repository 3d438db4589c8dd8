#include "sim/path_occurrences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "sim/force_event.h"
#include "sim/numeric/polynomial.h"
#include "sim/numeric/tolerances.h"

namespace carom::sim {
namespace {

constexpr double kLeastSpin = 0.5;  // rad/s, of a visible motion

int sign(double value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The component of the Hermite curve along `axis` as a polynomial of the time since its start.
Quartic component(const PathSegment& segment, const Vec3& axis) {
    const double h = segment.end - segment.start;
    const double p0 = segment.p0.dot(axis);
    const double v0 = segment.v0.dot(axis);
    const double v1 = segment.v1.dot(axis);
    const double mean = (segment.p1.dot(axis) - p0) / h;
    return {p0, v0, (3 * mean - 2 * v0 - v1) / h, (v0 + v1 - 2 * mean) / (h * h), 0};
}

Quartic derivative(const Quartic& c) {
    return {c[1], 2 * c[2], 3 * c[3], 4 * c[4], 0};
}

/// Follows the sign of a function that is a polynomial on each segment, and calls `changed(segment,
/// time since its start, sign)` where it becomes positive or negative. `sign_of` returns the sign
/// of a value; the function keeps its sign while it is 0.
template <class Function, class SignOf, class Changed>
void follow_sign(const std::vector<PathSegment>& segments, const Function& function,
                 const SignOf& sign_of, const Changed& changed) {
    int last = 0;
    for (const PathSegment& segment : segments) {
        const double length = segment.end - segment.start;
        if (length <= 0) {
            continue;
        }
        const Quartic polynomial = function(segment);
        std::array<double, 4> roots{};
        const std::size_t count = sign_changes(polynomial, 0, length, roots);
        double from = 0;
        for (std::size_t i = 0; i <= count; ++i) {
            const double to = i < count ? roots[i] : length;
            const int now = sign_of(evaluate(polynomial, 0.5 * (from + to)));
            if (now != 0 && now != last) {
                changed(segment, from, now);
                last = now;
            }
            from = to;
        }
    }
}

std::vector<PathSegment> all_segments(const Track& track) {
    return track.segments(track.keys().front().time, track.keys().back().time);
}

/// A time during which an object moves.
struct Motion {
    double from = 0;
    double to = 0;  // infinite: until the end
};

bool is_still(const Vec3& velocity, const Vec3& angular_velocity) {
    return velocity == Vec3(0, 0, 0) && angular_velocity == Vec3(0, 0, 0);
}

/// Whether anything can be seen of the motion between two keys at which the object rests.
bool is_visible(std::span<const Key> keys, std::size_t first, std::size_t last) {
    if ((keys[last].position - keys[first].position).length() > kLeastDisplacement) {
        return true;
    }
    for (std::size_t i = first; i <= last; ++i) {
        const Key& key = keys[i];
        const double speed = std::max(i > first ? key.velocity_in.length() : 0,
                                      i < last ? key.velocity_out.length() : 0);
        const double spin = std::max(i > first ? key.angular_velocity_in.length() : 0,
                                     i < last ? key.angular_velocity_out.length() : 0);
        if (speed > kVisibleSpeed || spin > kLeastSpin) {
            return true;
        }
    }
    return false;
}

std::vector<Motion> motions(const Track& track) {
    const auto keys = track.keys();
    std::vector<Motion> all;
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::size_t start = kNone;  // the key at which the motion began
    const auto end_motion = [&](std::size_t last, double time) {
        if (start != kNone && is_visible(keys, start, last)) {
            all.push_back({keys[start].time, time});
        }
        start = kNone;
    };
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const bool rests = is_still(keys[i].velocity_out, keys[i].angular_velocity_out) &&
                           is_still(keys[i + 1].velocity_in, keys[i + 1].angular_velocity_in) &&
                           keys[i].position == keys[i + 1].position;
        // What waits for a rest may act at its instant, so that the rest has no duration.
        const bool stops_here =
            start != kNone && is_still(keys[i].velocity_in, keys[i].angular_velocity_in);
        if (rests || stops_here) {
            end_motion(i, keys[i].time);
        }
        if (!rests && start == kNone) {
            start = i;
        }
    }
    const bool stops = is_still(keys.back().velocity_out, keys.back().angular_velocity_out);
    end_motion(keys.size() - 1, stops ? keys.back().time : std::numeric_limits<double>::infinity());
    return all;
}

std::vector<double> ends(const std::vector<Motion>& motions) {
    std::vector<double> times;
    for (const Motion& motion : motions) {
        if (std::isfinite(motion.to)) {
            times.push_back(motion.to);
        }
    }
    return times;
}

}  // namespace

std::vector<double> line_crossings(const Track& track, const Vec2& from, const Vec2& to) {
    const Vec2 span = to - from;
    const double length = std::sqrt(span.dot(span));
    const Vec3 along(span.x / length, span.y / length, 0);
    const Vec3 across(-along.y, along.x, 0);
    const Vec3 origin(from.x, from.y, 0);
    std::vector<double> times;
    bool is_first = true;
    follow_sign(
        all_segments(track),
        [&](const PathSegment& segment) {
            Quartic distance = component(segment, across);
            distance[0] -= origin.dot(across);
            return distance;
        },
        [](double distance) { return std::abs(distance) < kOnLine ? 0 : sign(distance); },
        [&](const PathSegment& segment, double time, int /*side*/) {
            const double position = evaluate(component(segment, along), time) - origin.dot(along);
            if (!is_first && position >= 0 && position <= length) {
                times.push_back(segment.start + time);
            }
            is_first = false;
        });
    return times;
}

std::vector<double> apexes(const Track& track) {
    const Vec3 up(0, 0, 1);
    std::vector<double> times;
    double rises_from = std::numeric_limits<double>::infinity();
    follow_sign(
        all_segments(track),
        [&](const PathSegment& segment) { return derivative(component(segment, up)); },
        [](double speed) { return speed > 0 ? 1 : -1; },
        [&](const PathSegment& segment, double time, int direction) {
            const double height = evaluate(component(segment, up), time);
            if (direction > 0) {
                rises_from = height;
            } else if (height - rises_from >= kLeastRise) {
                times.push_back(segment.start + time);
            }
        });
    return times;
}

std::vector<double> rests(const Track& track) {
    return ends(motions(track));
}

std::vector<double> rests_of_all(const Timeline& timeline, const WorldDescription& world) {
    std::vector<Motion> all;
    for (const Body& body : world.bodies) {
        if (const Track* track = timeline.find(body.name)) {
            const std::vector<Motion> some = motions(*track);
            all.insert(all.end(), some.begin(), some.end());
        }
    }
    std::sort(all.begin(), all.end(),
              [](const Motion& a, const Motion& b) { return a.from < b.from; });
    std::vector<Motion> merged;
    for (const Motion& motion : all) {
        if (!merged.empty() && motion.from < merged.back().to) {
            merged.back().to = std::max(merged.back().to, motion.to);
        } else {
            merged.push_back(motion);
        }
    }
    return ends(merged);
}

}  // namespace carom::sim
