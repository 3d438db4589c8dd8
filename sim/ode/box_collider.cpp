#include "sim/ode/box_collider.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <fmt/core.h>

#include "core/assert.h"
#include "core/error.h"
#include "core/rigid.h"
#include "sim/numeric/tolerances.h"
#include "sim/ode/handles.h"

namespace carom::sim::ode {
namespace {

struct GeomDeleter {
    void operator()(dGeomID geom) const { dGeomDestroy(geom); }
};
using Geom = std::unique_ptr<dxGeom, GeomDeleter>;

struct TriangleDataDeleter {
    void operator()(dTriMeshDataID data) const { dGeomTriMeshDataDestroy(data); }
};
using TriangleData = std::unique_ptr<dxTriMeshData, TriangleDataDeleter>;

/// Guards ODE's triangle code, the only mutable state of this file that threads share.
std::mutex& triangle_lock() {
    static std::mutex lock;
    return lock;
}

/// A box that is larger by `skin` on every side.
Geom make_box(const Vec3& size, const Pose& pose, double skin) {
    CAROM_ASSERT(size.x > 0 && size.y > 0 && size.z > 0);
    Geom geom(dCreateBox(nullptr, size.x + 2 * skin, size.y + 2 * skin, size.z + 2 * skin));
    dGeomSetPosition(geom.get(), pose.position.x, pose.position.y, pose.position.z);
    const Quat& o = pose.orientation;
    const dQuaternion q = {o.r, o.v.x, o.v.y, o.v.z};
    dGeomSetQuaternion(geom.get(), q);
    return geom;
}

/// `skins`: by which the two are larger together.
void collide(dGeomID a, dGeomID b, double skins, int most, std::vector<Contact>& contacts) {
    std::array<dContactGeom, 8> found{};
    const int count = dCollide(a, b, most, found.data(), sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
        const dContactGeom& contact = found[static_cast<std::size_t>(i)];
        contacts.push_back({to_vec3(contact.pos), to_vec3(contact.normal), contact.depth - skins});
    }
}

/// How far a box reaches along a unit vector, m.
double extent(const Vec3& size, const Pose& pose, const Vec3& direction) {
    const Vec3 own = to_body(pose.orientation, direction);
    return 0.5 * (std::abs(own.x) * size.x + std::abs(own.y) * size.y + std::abs(own.z) * size.z);
}

}  // namespace

/// ODE's points lie on one of the two boxes. Half-way between both they do not depend on the order.
void collide_boxes(const Vec3& size_a, const Pose& a, const Vec3& size_b, const Pose& b,
                   double margin, std::vector<Contact>& contacts) {
    const Geom first = make_box(size_a, a, 0.5 * margin);
    const Geom second = make_box(size_b, b, 0.5 * margin);
    const std::size_t count = contacts.size();
    collide(first.get(), second.get(), margin, 4, contacts);
    for (std::size_t i = count; i < contacts.size(); ++i) {
        Contact& contact = contacts[i];
        const double beyond_a =
            (a.position - contact.point).dot(contact.normal) - extent(size_a, a, contact.normal);
        contact.point += contact.normal * (beyond_a + 0.5 * contact.depth);
    }
}

// Members are destroyed in reverse order: the geom before its data.
struct TriangleSurface::State {
    std::vector<double> vertices;
    std::vector<dTriIndex> indices;
    TriangleData data;
    Geom geom;
};

TriangleSurface::TriangleSurface(const std::vector<Vec3>& vertices,
                                 const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : state_(std::make_unique<State>()) {
    for (const Vec3& v : vertices) {
        state_->vertices.insert(state_->vertices.end(), {v.x, v.y, v.z});
    }
    for (const auto& t : triangles) {
        state_->indices.insert(state_->indices.end(), {t[0], t[1], t[2]});
    }
    const std::scoped_lock lock(triangle_lock());
    state_->data.reset(dGeomTriMeshDataCreate());
    dGeomTriMeshDataBuildDouble(state_->data.get(), state_->vertices.data(), 3 * sizeof(double),
                                static_cast<int>(vertices.size()), state_->indices.data(),
                                static_cast<int>(state_->indices.size()), 3 * sizeof(dTriIndex));
    if (dGeomTriMeshDataPreprocess2(state_->data.get(), 1U << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES,
                                    nullptr) == 0) {
        throw Error(fmt::format("ODE could not prepare a surface of {} triangles for collisions",
                                triangles.size()));
    }
    state_->geom.reset(dCreateTriMesh(nullptr, state_->data.get(), nullptr, nullptr, nullptr));
}

TriangleSurface::~TriangleSurface() {
    if (state_ == nullptr) {
        return;
    }
    const std::scoped_lock lock(triangle_lock());
    state_.reset();
}

TriangleSurface::TriangleSurface(TriangleSurface&&) noexcept = default;

void TriangleSurface::collide(const Vec3& size, const Pose& box,
                              std::vector<Contact>& contacts) const {
    const Geom geom = make_box(size, box, kSolidMargin);
    const std::scoped_lock lock(triangle_lock());
    ode::collide(geom.get(), state_->geom.get(), kSolidMargin, 8, contacts);
}

}  // namespace carom::sim::ode
