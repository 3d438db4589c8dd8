#include "pipeline/picture/track_line.h"

#include <algorithm>
#include <cmath>

#include "sim/timeline/hermite.h"

namespace carom::pipeline {
namespace {

constexpr double kTolerance = 0.0004;  // m
constexpr int kMaxPieces = 64;         // of a segment

Vec3 point_of(const sim::PathSegment& segment, double u) {
    return sim::hermite_position(segment, segment.start + (segment.end - segment.start) * u);
}

/// The distance from the chord: pieces of a curve deviate by the square of their number less.
int pieces_of(const sim::PathSegment& segment) {
    double deviation = 0;
    for (const double u : {0.25, 0.5, 0.75}) {
        const Vec3 chord = segment.p0 + (segment.p1 - segment.p0) * u;
        deviation = std::max(deviation, (point_of(segment, u) - chord).length());
    }
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(deviation / kTolerance))), 1,
                      kMaxPieces);
}

}  // namespace

std::vector<LinePoint> track_line(const sim::Track& track, double from, double to) {
    std::vector<LinePoint> line;
    for (const sim::PathSegment& segment : track.segments(from, to)) {
        if (line.empty()) {
            line.push_back({segment.p0, segment.start});
        }
        const int pieces = pieces_of(segment);
        for (int i = 1; i <= pieces; ++i) {
            const double u = static_cast<double>(i) / pieces;
            line.push_back(
                {point_of(segment, u), segment.start + (segment.end - segment.start) * u});
        }
    }
    return line;
}

}  // namespace carom::pipeline
