#include "sim/billiards/drawn/profiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace carom::sim::billiards {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kBottom = -0.001;        // z, under the cloth, m
constexpr double kGrooveWidth = 0.0013;   // between the cloth and the wood, m
constexpr double kGrooveDepth = 0.0022;   // m
constexpr double kCrestRounding = 0.030;  // between the rising and the level top, m
constexpr double kLevel = 0.004;          // of the level top that belongs to the front, m
constexpr double kArcStep = 12 * kDegree;

// K-66 after Superior's and Artemis' drawings as a public generator of pool tables has them: the
// sides of the nose include 63.7 degrees and the back is tilted, so that the top rises by 8.9 and
// the face under the nose leans back by 35 (31 to 42) degrees, down to about 13 mm above the slate.
constexpr CushionShape kK66{0.0012, 35 * kDegree, 8.9 * kDegree, 0.013, 0};
// Carom: K-55, whose top of 1 1/4 in is longer; the nose is sharper. The angles are
// ours.
constexpr CushionShape kK55{0.0009, 36 * kDegree, 8 * kDegree, 0.013, 0};
// Snooker: the L profile has "not a tip but a small area" (Klematch), a flat face of 8 to 10 mm
// whose upper edge is at the nose's height. What lies below it is ours.
constexpr CushionShape kL{0.0012, 52 * kDegree, 8 * kDegree, 0.014, 0.0092};

struct Direction {
    double across = 0;  // outwards
    double rise = 0;
};

Direction direction_of(const ProfilePosition& from, const ProfilePosition& to) {
    const double across = to.inside - from.inside;
    const double rise = to.z - from.z;
    const double length = std::sqrt(across * across + rise * rise);
    return {across / length, rise / length};
}

double distance(const ProfilePosition& from, const ProfilePosition& to) {
    const double across = to.inside - from.inside;
    const double rise = to.z - from.z;
    return std::sqrt(across * across + rise * rise);
}

void add(Profile& profile, const ProfilePosition& at, const Direction& along) {
    const double length =
        profile.empty()
            ? 0
            : profile.back().length + distance({profile.back().inside, profile.back().z}, at);
    profile.push_back({at.inside, at.z, along.rise, along.across, length});
}

void add_rounding(Profile& profile, const ProfileCorner& corner, const Direction& before,
                  const Direction& after, double room) {
    const double turn = arctangent2(before.across * after.rise - before.rise * after.across,
                                    before.across * after.across + before.rise * after.rise);
    const double half = tangent(std::abs(turn) / 2);
    const double cut = std::min(corner.radius * half, room);
    const ProfilePosition& at = corner.at;
    if (cut < 1e-7) {
        add(profile, at, before);
        add(profile, at, after);
        return;
    }
    const double radius = cut / half;
    const ProfilePosition begin{at.inside - cut * before.across, at.z - cut * before.rise};
    const double side = turn > 0 ? 1 : -1;  // 1: the centre is on the left
    const ProfilePosition centre{begin.inside - side * radius * before.rise,
                                 begin.z + side * radius * before.across};
    const int count = std::max(2, static_cast<int>(std::ceil(std::abs(turn) / kArcStep)));
    for (int step = 0; step <= count; ++step) {
        const SinCos turned = sin_cos(turn * step / count);
        const Direction along{before.across * turned.cos - before.rise * turned.sin,
                              before.across * turned.sin + before.rise * turned.cos};
        add(profile,
            {centre.inside + side * radius * along.rise, centre.z - side * radius * along.across},
            step == count ? after : along);
    }
}

// The corner at which the lines meet that touch the nose's rounding from below and from above.
ProfilePosition nose_tip(const ProfilePosition& centre, double radius, double under, double top) {
    // Of a line at the distance `radius` from the centre with the outward normal (-open, up).
    const SinCos below = sin_cos(under);
    const SinCos above = sin_cos(top);
    const double open_a = below.cos;
    const double up_a = -below.sin;
    const double open_b = above.sin;
    const double up_b = above.cos;
    const double determinant = open_a * up_b - open_b * up_a;
    const double open = radius * (up_b - up_a) / determinant;
    const double up = radius * (open_a - open_b) / determinant;
    return {centre.inside - open, centre.z + up};
}

}  // namespace

Profile rounded_profile(std::span<const ProfileCorner> corners) {
    Profile profile;
    add(profile, corners[0].at, direction_of(corners[0].at, corners[1].at));
    for (std::size_t index = 1; index + 1 < corners.size(); ++index) {
        const ProfilePosition& at = corners[index].at;
        const ProfilePosition& last = corners[index - 1].at;
        const ProfilePosition& next = corners[index + 1].at;
        const double room = 0.49 * std::min(distance(last, at), distance(at, next));
        add_rounding(profile, corners[index], direction_of(last, at), direction_of(at, next), room);
    }
    add(profile, corners.back().at,
        direction_of(corners[corners.size() - 2].at, corners.back().at));
    return profile;
}

PlanPath thinned(const PlanPath& path, int every) {
    PlanPath kept{path.front()};
    int skipped = 0;
    for (std::size_t index = 1; index + 1 < path.size(); ++index) {
        const PathPoint& point = path[index];
        const bool is_corner = (point.normal_in - point.normal_out).length() > 1e-6;
        const bool begins = (point.normal_out - path[index + 1].normal_in).length() > 1e-9;
        const bool ends = (path[index - 1].normal_out - point.normal_in).length() > 1e-9;
        const bool is_straight = !is_corner && !begins && !ends;
        const bool is_on_arc = !is_corner && begins && ends;
        if (is_straight || (is_on_arc && ++skipped % every != 0)) {
            continue;
        }
        kept.push_back(point);
    }
    kept.push_back(path.back());
    return kept;
}

Profile thinned(const Profile& profile) {
    Profile kept;
    for (std::size_t index = 0; index < profile.size(); ++index) {
        if (index % 2 == 0 || index + 1 == profile.size()) {
            kept.push_back(profile[index]);
        }
    }
    return kept;
}

TableBuild build_of(const TableMeasures& measures) {
    if (measures.kind == TableKind::snooker) {
        return TableBuild::snooker;
    }
    const bool has_pockets = measures.corner_pocket || measures.side_pocket;
    return has_pockets ? TableBuild::pool : TableBuild::carom;
}

double drawn_rail_top(const TableMeasures& measures) {
    // The rails' top is 38 to 39 mm above the bed of a snooker table (docs/tables.md).
    return build_of(measures) == TableBuild::snooker
               ? std::min(measures.rail_height, measures.nose_height + 0.00175)
               : measures.rail_height;
}

double cloth_end(const TableMeasures& measures) {
    return measures.cushion_width - std::min(kGrooveWidth, 0.1 * measures.cushion_width);
}

CushionShape cushion_shape(const TableLayout& layout) {
    const TableMeasures& measures = layout.measures;
    const double height = measures.nose_height;
    CushionShape shape = kK66;
    double drawn_for = 0.03629;  // the height of the nose to which `foot` and `face` belong
    if (build_of(measures) == TableBuild::snooker) {
        shape = kL;
        drawn_for = 0.03675;
    } else if (build_of(measures) == TableBuild::carom) {
        shape = kK55;
        drawn_for = 0.037;
    }
    const double rise = drawn_rail_top(measures) - height;
    shape.nose_radius = std::min(shape.nose_radius, 0.5 * rise);
    shape.under = std::max(shape.under, layout.undercut);
    shape.foot *= height / drawn_for;
    shape.face *= height / drawn_for;
    // The wood below begins within the cushion.
    const double deepest = 0.45 * measures.cushion_width;
    const double depth = (height - shape.face - shape.foot) * tangent(shape.under);
    if (depth > deepest) {
        shape.foot = height - shape.face - deepest / tangent(shape.under);
    }
    const double longest = 0.7 * measures.cushion_width;
    shape.top = std::max(shape.top, arctangent2(rise, longest));
    return shape;
}

CushionProfile cushion_profile(const TableLayout& layout) {
    const TableMeasures& measures = layout.measures;
    const CushionShape shape = cushion_shape(layout);
    const double rail_top = drawn_rail_top(measures);
    const double height = measures.nose_height;
    // A ball touches the simulation's nose at (0, height), in this direction below the horizontal.
    const double radius = shape.nose_radius;
    const double drawn_back = shape.face > 0 ? layout.nose_inset : 0;
    ProfilePosition upper;  // where the top begins
    ProfilePosition lower;  // where the face under the nose begins
    if (shape.face > 0) {
        // The flat face stands in the edge of the playing field, so that the ball's foremost point
        // touches it.
        upper = {drawn_back, height};
        lower = {drawn_back, height - shape.face};
    } else {
        const double ball = layout.ball_radius;
        const double sine = std::clamp(height / ball - 1, -0.9, 0.9);
        const ProfilePosition centre{radius * std::sqrt(1 - sine * sine), height + radius * sine};
        upper = lower = nose_tip(centre, radius, shape.under, shape.top);
    }
    const ProfilePosition foot{lower.inside + (lower.z - shape.foot) * tangent(shape.under),
                               shape.foot};
    const double end = cloth_end(measures);
    const double to_crest = (rail_top - upper.z) / tangent(shape.top);
    const ProfilePosition crest{std::min(upper.inside + to_crest, 0.85 * end), rail_top};

    std::vector<ProfileCorner> corners{{{foot.inside, kBottom}, 0}, {foot, 0}};
    if (shape.face > 0) {
        corners.push_back({lower, radius});
    }
    corners.push_back({upper, radius});
    corners.push_back({crest, kCrestRounding});
    const double level = std::min(crest.inside + kLevel, 0.5 * (crest.inside + end));
    corners.push_back({{level, rail_top}, 0});
    CushionProfile profile;
    profile.front = rounded_profile(corners);
    // With a point where the rounding at the cushion's ends begins to taper off.
    const double taper = level + 0.85 * (end - level);
    const std::array<ProfileCorner, 4> back{{{{level, rail_top}, 0},
                                             {{taper, rail_top}, 0},
                                             {{end, rail_top}, kGrooveEdge},
                                             {{end, rail_top - kGrooveDepth}, 0}}};
    profile.back = rounded_profile(back);
    return profile;
}

}  // namespace carom::sim::billiards
