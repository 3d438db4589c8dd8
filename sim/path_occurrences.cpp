#include "sim/path_occurrences.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/length.h"
#include "sim/path_detectors.h"

namespace carom::sim {
namespace {

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

std::vector<Motion> motions(const Track& track) {
    const auto keys = track.keys();
    std::vector<Motion> all;
    RestDetector detector;
    const Key* start = nullptr;  // at which the motion began; null: it rests
    const auto rest = [&](double time) {
        if (detector.rest()) {
            all.push_back({start->time, time});
        }
        start = nullptr;
    };
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const Key& from = keys[i];
        const Key& to = keys[i + 1];
        const bool rests = is_still(from.velocity_out, from.angular_velocity_out) &&
                           is_still(to.velocity_in, to.angular_velocity_in) &&
                           from.position == to.position;
        // What waits for a rest may act at its instant, so that the rest has no duration.
        if (rests || is_still(from.velocity_in, from.angular_velocity_in)) {
            rest(from.time);
        }
        if (!rests) {
            start = start != nullptr ? start : &from;
            detector.move(is_visible(
                length(to.position - start->position),
                std::max(length(from.velocity_out), length(to.velocity_in)),
                std::max(length(from.angular_velocity_out), length(to.angular_velocity_in))));
        }
    }
    const bool stops = is_still(keys.back().velocity_out, keys.back().angular_velocity_out);
    rest(stops ? keys.back().time : std::numeric_limits<double>::infinity());
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
