#include "sim/spatial/mesh_contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/spatial/convex_contacts.h"

namespace carom::sim {
namespace {

/// The contacts with one plane of one surface.
struct Group {
    std::uint32_t surface = 0;
    std::vector<Contact> contacts;
};

/// The triangle as a solid without thickness, with its centre as origin.
PlacedShape flat_solid(const StaticMesh::Triangle& triangle, std::optional<ConvexShape>& store) {
    const Vec3 middle = (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
    Polyhedron flat;
    for (const Vec3& corner : triangle.corners) {
        flat.vertices.push_back(corner - middle);
    }
    flat.faces = {{{0, 1, 2}, triangle.normal}, {{0, 2, 1}, -triangle.normal}};
    store = ConvexShape::hull(std::move(flat));
    return {&*store, {middle, Quat()}};
}

bool is_on_side(const Contact& contact, const StaticMesh::Triangle& triangle) {
    constexpr double kSame = 0.9998;  // 1.1 degrees
    return std::abs(contact.normal.dot(triangle.normal)) > kSame;
}

/// True if the contact lies in the plane of a flat side's contact, which already supports the
/// solid.
bool is_on_contact_plane(const Contact& edge, const std::vector<Group>& sides, double margin) {
    return std::any_of(sides.begin(), sides.end(), [&](const Group& side) {
        const Contact& on_side = side.contacts.front();
        return std::abs(on_side.normal.dot(edge.point - on_side.point)) < 4 * margin;
    });
}

void add_to(std::vector<Group>& groups, std::uint32_t surface,
            const std::vector<Contact>& contacts) {
    constexpr double kSamePlane = 0.9998;
    for (Group& group : groups) {
        if (group.surface == surface &&
            group.contacts.front().normal.dot(contacts.front().normal) > kSamePlane) {
            group.contacts.insert(group.contacts.end(), contacts.begin(), contacts.end());
            return;
        }
    }
    groups.push_back({surface, contacts});
}

}  // namespace

std::vector<SurfaceContact> mesh_contacts(const PlacedShape& solid, const StaticMesh& mesh,
                                          const Aabb& bounds, double margin) {
    std::vector<Group> sides;
    std::vector<Group> edges;
    std::vector<Contact> contacts;
    std::optional<ConvexShape> store;
    for (const StaticMesh::Triangle& triangle : mesh.triangles_near(bounds)) {
        // Most nearby triangles lie in planes that the solid does not touch.
        const double side = triangle.normal.dot(solid.pose.position - triangle.corners[0]);
        const Vec3 normal = side >= 0 ? triangle.normal : -triangle.normal;
        if (normal.dot(solid.support(-normal) - triangle.corners[0]) > margin) {
            continue;
        }
        convex_contacts(solid, flat_solid(triangle, store), margin, contacts);
        if (!contacts.empty()) {
            add_to(is_on_side(contacts.front(), triangle) ? sides : edges, triangle.surface,
                   contacts);
        }
    }
    for (Group& edge : edges) {
        std::erase_if(edge.contacts, [&](const Contact& contact) {
            return is_on_contact_plane(contact, sides, margin);
        });
        if (!edge.contacts.empty()) {
            sides.push_back(std::move(edge));
        }
    }
    std::vector<SurfaceContact> result;
    for (Group& group : sides) {
        reduce_contacts(group.contacts);
        for (const Contact& contact : group.contacts) {
            result.push_back({contact, group.surface});
        }
    }
    return result;
}

}  // namespace carom::sim
