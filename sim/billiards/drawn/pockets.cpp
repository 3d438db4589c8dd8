#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "sim/billiards/drawn/drawn_parts.h"
#include "sim/billiards/drawn/profiles.h"
#include "sim/billiards/parts.h"
#include "sim/billiards/surface_builder.h"

namespace carom::sim::billiards {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRoll = 0.0024;         // radius of the leather's rolled edge, m
constexpr double kBelowMetal = 0.007;    // of the roll's top below a casting's, m
constexpr double kWall = 0.0014;         // of the leather's wall behind the roll's inner side, m
constexpr double kCollar = 0.019;        // width of the leather on a snooker table's wood, m
constexpr double kCollarProud = 0.0022;  // m
constexpr double kSlack = 0.0012;        // depth of the folds in a leather bag, m
constexpr int kFolds = 5;
constexpr double kBagCurve = 0.014;     // rounding between the wall and the floor of a bag, m
constexpr double kStitchPitch = 0.007;  // m
constexpr double kStitchLength = 0.0042;
constexpr double kStitchWidth = 0.0011;
constexpr double kThread = 0.0009;  // radius of a net's cord, m
constexpr int kCords = 14;          // of a net, in each of its two directions

/// A place on a pocket's circle and the directions there.
struct CirclePlace {
    Vec2 centre;
    double angle = 0;

    [[nodiscard]] Vec2 radial() const {
        const SinCos at = sin_cos(angle);
        return {at.cos, at.sin};
    }
    [[nodiscard]] Vec3 at(double radius, double z) const {
        const Vec2 place = centre + radius * radial();
        return {place.x, place.y, z};
    }
};

double angle_of(const Vec2& centre, const Vec2& place) {
    return arctangent2(place.y - centre.y, place.x - centre.x);
}

/// A circle as a profile, around a point inside the outline.
Profile roll_profile(ProfilePosition centre, double radius) {
    constexpr int kSteps = 8;
    Profile profile;
    for (int step = 0; step <= kSteps; ++step) {
        const SinCos at = sin_cos(kPi * (-0.75 + 1.5 * step / kSteps));
        profile.push_back({centre.inside - radius * at.cos, centre.z + radius * at.sin, at.cos,
                           at.sin, radius * 1.5 * kPi * step / kSteps});
    }
    return profile;
}

/// A stitch: half an ellipsoid on a surface with this normal.
void add_stitch(SurfaceBuilder& builder, const Vec3& at, const Vec3& along, const Vec3& normal) {
    constexpr std::array<double, 5> kPlaces{-1, -0.75, 0, 0.75, 1};
    constexpr int kAround = 3;
    const Vec3 across = normal.cross(along);
    std::vector<std::vector<SurfaceVertex>> rows;
    for (const double place : kPlaces) {
        const double size = std::sqrt(std::max(0.0, 1 - place * place));
        std::vector<SurfaceVertex>& row = rows.emplace_back();
        for (int step = 0; step <= kAround; ++step) {
            const SinCos angle = sin_cos(kPi * step / kAround);
            const Vec3 out = angle.cos * across + angle.sin * normal;
            const Vec3 facing = 0.25 * place * along + size * out;
            row.push_back(
                {at + 0.5 * kStitchLength * place * along + 0.5 * kStitchWidth * size * out,
                 (facing.length() > 1e-9 ? facing : along).normalized(),
                 {place, angle.cos}});
        }
    }
    builder.add_grid(rows);
}

/// Stitches along an arc around a pocket's centre, at this radius and height.
void add_seam(SurfaceBuilder& builder, const Vec2& centre, const PlanPath& arc, double radius,
              double z, bool is_on_top) {
    const double begin = angle_of(centre, arc.front().position);
    double turn = angle_of(centre, arc.back().position) - begin;
    turn += turn < 0 ? 2 * kPi : 0;
    const int count = static_cast<int>(turn * radius / kStitchPitch);
    for (int stitch = 0; stitch < count; ++stitch) {
        const CirclePlace place{centre, begin + turn * (stitch + 0.5) / count};
        const Vec2 radial = place.radial();
        const Vec3 along(-radial.y, radial.x, 0);
        const Vec3 normal = is_on_top ? Vec3(0, 0, 1) : Vec3(-radial.x, -radial.y, 0);
        add_stitch(builder, place.at(radius, z), along, normal);
    }
}

/// The bag under the bed: heights and distances from the hole's wall, outwards.
struct Bag {
    double top = 0;
    double bottom = 0;
    double bulge = 0.003;
    double floor = 0;  // width of the floor that belongs to the bag

    /// From here on down it is wider than the slate's hole.
    [[nodiscard]] double under_slate() const { return -std::min(1.2 * kSlateEdge, -0.5 * bottom); }

    /// Its wall and floor from the top down; the last point is on the floor.
    [[nodiscard]] std::vector<ProfileCorner> corners() const {
        const double depth = top - bottom;
        return {{{0, top}, 0},
                {{0, under_slate()}, 0.02},
                {{bulge, top - 0.55 * depth}, 0.05},
                {{0.001, bottom}, kBagCurve},
                {{-floor, bottom}, 0}};
    }
};

Bag bag_of(const PocketLayout& pocket) {
    const double drop = pocket.pocket.drop;
    const double floor = std::min(1.6 * kBagCurve, 0.45 * pocket.pocket.radius);
    return {-std::min(0.5 * kSlateEdge, 0.3 * drop), -drop, 0.003, floor};
}

// rounded_profile has the material on the right of its direction; this one looks at the inside of a
// bag from the top down.
Profile bag_profile(const Bag& bag) {
    std::vector<ProfileCorner> corners = bag.corners();
    std::reverse(corners.begin(), corners.end());
    Profile profile = rounded_profile(corners);
    // Inside a bag the floor looks up and the wall towards its axis.
    std::reverse(profile.begin(), profile.end());
    return profile;
}

/// Folds of the leather: outwards, none in front of the slate.
void slacken(SurfaceVertex& vertex, const Vec2& centre, const Bag& bag) {
    const Vec2 from_centre = Vec2(vertex.position.x, vertex.position.y) - centre;
    const double radius = from_centre.length();
    const double below = bag.under_slate() - vertex.position.z;
    const double down = std::clamp(below / (bag.under_slate() - bag.bottom), 0.0, 1.0);
    const double depth = kSlack * down * (down < 0.8 ? 1 : 5 * (1 - down));
    const double angle = kFolds * arctangent2(from_centre.y, from_centre.x) + 9 * centre.x;
    const SinCos at = sin_cos(angle);
    const Vec2 radial = from_centre / radius;
    const Vec2 tangential(-radial.y, radial.x);
    const Vec2 moved = depth * (1 + at.sin) * radial;
    const double slope = depth * kFolds * at.cos / radius;
    vertex.position += Vec3(moved.x, moved.y, 0);
    vertex.normal += slope * Vec3(tangential.x, tangential.y, 0);
    vertex.normal.normalize();
}

class PocketDrawing {
  public:
    PocketDrawing(const TableLayout& layout, const PocketLayout& pocket)
        : layout_(layout),
          pocket_(pocket),
          centre_(pocket.pocket.centre),
          radius_(pocket.pocket.radius - kLinerInset),
          opening_(pocket_opening(layout, pocket, radius_)),
          rail_top_(drawn_rail_top(layout.measures)) {}

    void draw(std::vector<Surface>& surfaces) {
        const bool is_snooker = build_of(layout_.measures) == TableBuild::snooker;
        SurfaceBuilder leather("pocket_liner_" + pocket_.pocket.name, SurfacePart::pocket_liner);
        SurfaceBuilder thread("stitches_" + pocket_.pocket.name, SurfacePart::stitch);
        if (is_snooker) {
            add_collar(leather, thread);
        } else {
            add_rolled_wall(leather, thread);
            add_bag(leather);
        }
        add_wings(leather, layout_, opening_);
        surfaces.push_back(std::move(leather).finish());
        Surface seam = std::move(thread).finish();
        if (!seam.triangles.empty()) {
            surfaces.push_back(std::move(seam));
        }
        surfaces.push_back(is_snooker ? net() : floor());
    }

  private:
    /// Leather in the wood, under the lip of a casting, with a rolled edge and a seam below it.
    void add_rolled_wall(SurfaceBuilder& leather, SurfaceBuilder& thread) const {
        const double top = std::max(0.3 * rail_top_, rail_top_ - kBelowMetal);
        const double bottom = bag_of(pocket_).top;
        // In front of the slate the wall is where balls touch it.
        const std::array<ProfileCorner, 4> wall{{{{0, bottom}, 0},
                                                 {{0, 0.001}, 0.01},
                                                 {{kWall, 0.4 * top}, 0.01},
                                                 {{kWall, top - kRoll}, 0}}};
        leather.sweep(opening_.arc, rounded_profile(wall));
        leather.sweep(opening_.arc, roll_profile({kRoll, top - kRoll}, kRoll));
        const double seam = top - 2 * kRoll - 0.004;
        if (seam > 0.002) {
            add_seam(thread, centre_, opening_.arc, radius_ + kWall, seam, false);
        }
    }

    /// Leather that is pulled over the edge of the wood and sewn down on it.
    void add_collar(SurfaceBuilder& leather, SurfaceBuilder& thread) const {
        const double top = rail_top_ + kCollarProud;
        const std::array<ProfileCorner, 4> corners{{{{0, -1.2 * kSlateEdge}, 0},
                                                    {{0, top}, 0.0035},
                                                    {{kCollar, top - 0.0008}, 0.0015},
                                                    {{kCollar, rail_top_ - 0.002}, 0}}};
        const Profile profile = rounded_profile(corners);
        leather.sweep(thinned(opening_.arc, 2), profile);
        for (const bool is_end : {false, true}) {
            const PathPoint& end = is_end ? opening_.arc.back() : opening_.arc.front();
            const Vec2 radial = (end.position - centre_).normalized();
            const double sign = is_end ? -1 : 1;
            leather.add_polygon(profile_at(end, std::span(&profile, 1)),
                                {sign * radial.y, -sign * radial.x, 0});
        }
        add_seam(thread, centre_, opening_.arc, radius_ + kCollar - 0.0035, top - 0.0007, true);
    }

    void add_bag(SurfaceBuilder& leather) const {
        const Bag bag = bag_of(pocket_);
        std::vector<std::vector<SurfaceVertex>> rows;
        const PlanPath circle = thinned(circle_path(centre_, radius_), 2);
        for (const ProfilePoint& point : bag_profile(bag)) {
            rows.push_back(row_along(circle, point, [&](const PathPoint&, SurfaceVertex& vertex) {
                slacken(vertex, centre_, bag);
            }));
        }
        leather.add_grid(rows);
    }

    [[nodiscard]] Surface floor() const {
        SurfaceBuilder builder("pocket_floor_" + pocket_.pocket.name, SurfacePart::pocket_floor);
        const Loop rim =
            inside_outline(thinned(circle_path(centre_, radius_), 2), -bag_of(pocket_).floor);
        builder.add_level(std::span(&rim, 1), -pocket_.pocket.drop, true, HUGE_VAL);
        return std::move(builder).finish();
    }

    /// A net of cords that cross each other, under the bed.
    [[nodiscard]] Surface net() const {
        SurfaceBuilder builder("net_" + pocket_.pocket.name, SurfacePart::net);
        const Bag bag = bag_of(pocket_);
        Profile profile = bag_profile(bag);
        for (int cord = 0; cord < kCords; ++cord) {
            for (const double twist : {1.9, -1.9}) {
                add_cord(builder, profile, 2 * kPi * cord / kCords, twist);
            }
        }
        return std::move(builder).finish();
    }

    void add_cord(SurfaceBuilder& builder, const Profile& profile, double angle,
                  double twist) const {
        constexpr int kPieces = 8;
        constexpr int kSides = 3;
        const double length = std::abs(profile.back().length - profile.front().length);
        std::vector<Vec3> places;
        std::vector<Vec3> normals;  // of the bag, inwards
        for (int piece = 0; piece <= kPieces; ++piece) {
            const double fraction = double(piece) / kPieces;
            const ProfilePoint point = point_along(profile, fraction * length);
            const CirclePlace place{centre_, angle + twist * fraction};
            const Vec2 open = -point.normal_open * place.radial();
            places.push_back(place.at(radius_ + point.inside + kThread, point.z - 1.2 * kThread));
            normals.emplace_back(open.x, open.y, point.normal_up);
        }
        std::vector<std::vector<SurfaceVertex>> rows;
        for (std::size_t index = 0; index < places.size(); ++index) {
            const Vec3 along = (places[std::min(index + 1, places.size() - 1)] -
                                places[index == 0 ? 0 : index - 1])
                                   .normalized();
            const Vec3 side = along.cross(normals[index]).normalized();
            const Vec3 up = side.cross(along);
            std::vector<SurfaceVertex>& row = rows.emplace_back();
            for (int step = 0; step <= kSides; ++step) {
                const SinCos at = sin_cos(2 * kPi * (step % kSides) / kSides);
                const Vec3 out = at.cos * side + at.sin * up;
                row.push_back({places[index] + kThread * out, out, {0, 0}});
            }
        }
        builder.add_grid(rows);
    }

    /// The point of a profile at this length from its beginning.
    [[nodiscard]] static ProfilePoint point_along(const Profile& profile, double length) {
        std::size_t index = 1;
        const double begin = profile.front().length;
        while (index + 1 < profile.size() && std::abs(profile[index].length - begin) < length) {
            ++index;
        }
        const ProfilePoint& a = profile[index - 1];
        const ProfilePoint& b = profile[index];
        const double span = std::abs(b.length - a.length);
        const double part =
            span > 0 ? std::clamp((length - std::abs(a.length - begin)) / span, 0.0, 1.0) : 0;
        return {a.inside + part * (b.inside - a.inside), a.z + part * (b.z - a.z),
                a.normal_open + part * (b.normal_open - a.normal_open),
                a.normal_up + part * (b.normal_up - a.normal_up), length};
    }

    const TableLayout& layout_;
    const PocketLayout& pocket_;
    Vec2 centre_;
    double radius_;
    PocketOpening opening_;
    double rail_top_;
};

}  // namespace

void draw_pocket(const TableLayout& layout, const PocketLayout& pocket,
                 std::vector<Surface>& surfaces) {
    PocketDrawing(layout, pocket).draw(surfaces);
}

}  // namespace carom::sim::billiards
