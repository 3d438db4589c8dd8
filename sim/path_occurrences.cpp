#include "sim/path_occurrences.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "sim/numeric/tolerances.h"
#include "sim/path_detectors.h"

namespace carom::sim {
namespace {

constexpr double kMinSpin = 0.5;  // rad/s, of a visible motion

/// The Hermite curve of the segment as a polynomial.
PathPiece piece_of(const PathSegment& segment) {
    const double h = segment.end - segment.start;
    const Vec3 mean = (segment.p1 - segment.p0) / h;
    return {h,
            {segment.p0, segment.v0, (mean * 3 - segment.v0 * 2 - segment.v1) / h,
             (segment.v0 + segment.v1 - mean * 2) / (h * h)}};
}

/// The scene times at which something happens on the track.
template <class Detector>
std::vector<double> times_on(const Track& track, Detector detector) {
    std::vector<double> times;
    for (const PathSegment& segment :
         track.segments(track.keys().front().time, track.keys().back().time)) {
        if (segment.end <= segment.start) {
            continue;
        }
        for (const double time : detector.follow(piece_of(segment))) {
            times.push_back(segment.start + time);
        }
    }
    return times;
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
    if ((keys[last].position - keys[first].position).length() > kMinDisplacement) {
        return true;
    }
    for (std::size_t i = first; i <= last; ++i) {
        const Key& key = keys[i];
        const double speed = std::max(i > first ? key.velocity_in.length() : 0,
                                      i < last ? key.velocity_out.length() : 0);
        const double spin = std::max(i > first ? key.angular_velocity_in.length() : 0,
                                     i < last ? key.angular_velocity_out.length() : 0);
        if (speed > kVisibleSpeed || spin > kMinSpin) {
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
    return times_on(track, LineDetector(from, to));
}

std::vector<double> apexes(const Track& track) {
    return times_on(track, ApexDetector());
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
