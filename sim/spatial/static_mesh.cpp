#include "sim/spatial/static_mesh.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/length.h"
#include "sim/motion/time_of_impact.h"

namespace carom::sim {
namespace {

Aabb bounds_of(const MeshFeature& feature) {
    Aabb box{feature.points[0], feature.points[0]};
    if (feature.kind != MeshFeature::Kind::corner) {
        box.extend(feature.points[1]);
    }
    if (feature.kind == MeshFeature::Kind::face) {
        box.extend(feature.points[2]);
    }
    return box;
}

/// True if the foot of the perpendicular from `p` lies in the triangle or on its edges.
bool is_above(const MeshFeature& face, const Vec3& p) {
    constexpr double kRim = 1e-9;  // m
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 along = face.points[(i + 1) % 3] - face.points[i];
        const Vec3 inwards = face.direction.cross(along);
        if (inwards.dot(p - face.points[i]) < -kRim * length(along)) {
            return false;
        }
    }
    return true;
}

std::optional<double> face_impact_time(const MeshFeature& face, const MotionSegment& ball,
                                       double radius, double now, double until) {
    const double side = face.direction.dot(ball.position_at(now) - face.points[0]);
    const Vec3 normal = side >= 0 ? face.direction : -face.direction;
    const auto time = plane_impact_time(ball, face.points[0], normal, radius, now, until);
    return time && is_above(face, ball.position_at(*time)) ? time : std::nullopt;
}

std::optional<double> edge_impact_time(const MeshFeature& edge, const MotionSegment& ball,
                                       double radius, double now, double until) {
    const auto time = line_impact_time(ball, edge.points[0], edge.direction, radius, now, until);
    if (!time) {
        return time;
    }
    const double along = edge.direction.dot(ball.position_at(*time) - edge.points[0]);
    const double edge_length = edge.direction.dot(edge.points[1] - edge.points[0]);
    return along >= 0 && along <= edge_length ? time : std::nullopt;
}

std::optional<double> feature_impact_time(const MeshFeature& feature, const MotionSegment& ball,
                                          double radius, double now, double until) {
    switch (feature.kind) {
        case MeshFeature::Kind::face:
            return face_impact_time(feature, ball, radius, now, until);
        case MeshFeature::Kind::edge:
            return edge_impact_time(feature, ball, radius, now, until);
        case MeshFeature::Kind::corner:
            break;
    }
    return point_impact_time(ball, feature.points[0], radius, now, until);
}

SurfaceContact contact_at(const Vec3& point, const MeshFeature& feature, const Vec3& centre,
                          double radius) {
    SurfaceContact contact;
    contact.point = point;
    const Vec3 d = centre - contact.point;
    const double distance = length(d);
    contact.normal = distance > 1e-9 ? d / distance : feature.direction;
    contact.depth = radius - distance;
    return contact;
}

SurfaceContact contact_with(const MeshFeature& feature, const Vec3& centre, double radius) {
    return contact_at(nearest_point(feature, centre), feature, centre, radius);
}

}  // namespace

void StaticMesh::add(std::vector<Vec3> vertices, std::vector<MeshTriangle> triangles,
                     std::uint32_t surface) {
    if (triangles.empty()) {
        return;
    }
    const auto added = std::make_shared<Part>();
    Part& part = *added;
    part.bounds = {vertices[triangles[0][0]], vertices[triangles[0][0]]};
    for (const MeshTriangle& t : triangles) {
        for (const std::uint32_t index : t) {
            part.bounds.extend(vertices[index]);
        }
    }
    part.vertices = std::move(vertices);
    part.triangles = std::move(triangles);
    part.surface = surface;
    part.first_feature = next_feature_;
    next_feature_ += static_cast<std::uint32_t>(7 * part.triangles.size());
    parts_.push_back(added);
}

void StaticMesh::prepare(const Part& part) {
    std::call_once(part.is_prepared, [&] {
        part.features = mesh_features(part.vertices, part.triangles);
        std::vector<Aabb> boxes;
        boxes.reserve(part.features.size());
        for (const MeshFeature& feature : part.features) {
            boxes.push_back(bounds_of(feature));
        }
        part.tree = AabbTree(boxes);
    });
}

const StaticMesh::Part& StaticMesh::part_of(std::uint32_t feature) const {
    const auto next =
        std::upper_bound(parts_.begin(), parts_.end(), feature,
                         [](std::uint32_t f, const auto& part) { return f < part->first_feature; });
    return **std::prev(next);
}

std::optional<StaticMesh::FeatureImpact> StaticMesh::first_impact(const MotionSegment& ball,
                                                                  double radius, double now,
                                                                  double until) const {
    std::optional<FeatureImpact> first;
    Aabb bounds = swept_bounds(ball, now, until);
    const Vec3 middle = (bounds.low + bounds.high) * 0.5;
    const double reach = radius + 0.5 * length(bounds.high - bounds.low) + 1e-9;
    bounds.grow(radius + 1e-9);
    std::vector<std::uint32_t> near;
    for (const auto& each : parts_) {
        const Part& part = *each;
        if (!part.bounds.overlaps(bounds)) {
            continue;
        }
        prepare(part);
        part.tree.query(bounds, middle, reach, near);
        for (const std::uint32_t index : near) {
            const auto time = feature_impact_time(part.features[index], ball, radius, now,
                                                  first ? first->time : until);
            if (time && (!first || *time < first->time)) {
                first = FeatureImpact{*time, part.first_feature + index};
            }
        }
    }
    return first;
}

SurfaceContact StaticMesh::contact(std::uint32_t feature, const Vec3& centre, double radius) const {
    const Part& part = part_of(feature);
    SurfaceContact contact =
        contact_with(part.features[feature - part.first_feature], centre, radius);
    contact.surface = part.surface;
    return contact;
}

void StaticMesh::find_near(const Vec3& centre, double distance, NearFeatures& near) const {
    near.items.clear();
    near.centre = centre;
    std::vector<std::uint32_t> found;
    for (const auto& each : parts_) {
        const Part& part = *each;
        if (part.bounds.squared_distance(centre) > distance * distance) {
            continue;
        }
        prepare(part);
        part.tree.query(centre, distance, found);
        for (const std::uint32_t index : found) {
            const MeshFeature& feature = part.features[index];
            const Vec3 d = nearest_point(feature, centre) - centre;
            if (d.dot(d) <= distance * distance) {
                near.items.push_back({&part, index, bounds_of(feature)});
            }
        }
    }
}

std::vector<SurfaceContact> StaticMesh::contacts(const Vec3& centre, double radius, double margin,
                                                 NearFeatures& near) const {
    const double distance = (radius + margin) * (1 + 1e-12);
    if (!(length(centre - near.centre) <= near.slack)) {
        near.slack = 0.1 * radius;
        find_near(centre, distance + near.slack, near);
    }
    std::vector<SurfaceContact> found;
    for (const NearFeatures::Item& item : near.items) {
        if (item.box.squared_distance(centre) > distance * distance) {
            continue;
        }
        const MeshFeature& feature = item.part->features[item.index];
        const Vec3 point = nearest_point(feature, centre);
        const Vec3 d = centre - point;
        if (d.dot(d) > distance * distance) {
            continue;
        }
        SurfaceContact candidate = contact_at(point, feature, centre, radius);
        candidate.surface = item.part->surface;
        if (candidate.depth >= -margin) {
            found.push_back(candidate);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.depth > b.depth; });
    std::vector<SurfaceContact> kept;
    for (const SurfaceContact& candidate : found) {
        const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const auto& other) {
            return other.normal.dot(candidate.normal) > 0.98;  // within 11 degrees
        });
        if (is_new && kept.size() < 4) {
            kept.push_back(candidate);
        }
    }
    return kept;
}

std::vector<StaticMesh::Triangle> StaticMesh::triangles_near(const Aabb& bounds) const {
    std::vector<Triangle> found;
    std::vector<std::uint32_t> near;
    for (const auto& each : parts_) {
        const Part& part = *each;
        if (!part.bounds.overlaps(bounds)) {
            continue;
        }
        prepare(part);
        part.tree.query(bounds, near);
        for (const std::uint32_t index : near) {
            const MeshFeature& feature = part.features[index];
            if (feature.kind == MeshFeature::Kind::face) {
                found.push_back({feature.points, feature.direction, part.surface});
            }
        }
    }
    return found;
}

Aabb swept_bounds(const MotionSegment& ball, double from, double to) {
    const Vec3 p = ball.position_at(from);
    Aabb box{p, p};
    box.extend(ball.position_at(to));
    const Vec3 v = ball.velocity_at(from);
    for (int axis = 0; axis < 3; ++axis) {
        if (ball.acceleration[axis] == 0) {
            continue;
        }
        const double turning_time = from - v[axis] / ball.acceleration[axis];
        if (turning_time > from && turning_time < to) {
            box.extend(ball.position_at(turning_time));
        }
    }
    return box;
}

}  // namespace carom::sim
