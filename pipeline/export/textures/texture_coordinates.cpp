#include "pipeline/export/textures/texture_coordinates.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/assert.h"
#include "core/elementary.h"
#include "pipeline/export/textures/globe.h"
#include "pipeline/export/textures/split_vertices.h"
#include "pipeline/export/textures/uv_lengths.h"

namespace carom::pipeline {

namespace {

using render::Mapping;
using Corners = std::array<Vec2, 3>;

Vec3 flat_normal(const std::array<Vec3, 3>& p) {
    return (p[1] - p[0]).cross(p[2] - p[0]);
}

/// The two axes beside the one that the surface faces most: of z, x and y the first of the longest.
Corners on_box(const std::array<Vec3, 3>& p) {
    const Vec3 n = flat_normal(p);
    const Vec3 size(std::abs(n.x), std::abs(n.y), std::abs(n.z));
    const bool is_z = size.z >= size.x && size.z >= size.y;
    const bool is_x = !is_z && size.x >= size.y;
    Corners result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = {is_x ? p[i].y : p[i].x, is_z ? p[i].y : p[i].z};
    }
    return result;
}

/// All coordinates of a mesh, one place after the other.
class Coordinates {
  public:
    Coordinates(const render::TriangleMesh& mesh, const MeshOnObject& on)
        : mesh_(mesh), on_(on), metres_from_mesh_(on.object_from_mesh * on.metres_from_object) {}

    /// Of the triangle of that index.
    [[nodiscard]] Corners at(std::size_t triangle, const TexturePlace& place) {
        Corners c = laid_out(triangle, place);
        const double cosine = carom::cosine(place.rotation);
        const double sine = carom::sine(place.rotation);
        for (Vec2& at : c) {
            at = {cosine * at.x + sine * at.y, cosine * at.y - sine * at.x};
        }
        return c;
    }

  private:
    [[nodiscard]] Corners laid_out(std::size_t triangle, const TexturePlace& place) {
        if (place.mapping == Mapping::uv) {
            return times(uv(triangle), place.by_length ? lengths(triangle) : Vec2(1, 1));
        }
        const std::array<Vec3, 3> p = positions(triangle, metres_from_mesh_);
        if (place.mapping == Mapping::box) {
            return on_box(p);
        }
        Corners c;
        if (place.mapping == Mapping::planar) {
            const FlatAxes axes = flat_axes(place.facing);
            for (std::size_t i = 0; i < 3; ++i) {
                c[i] = {axes.u.dot(p[i]), axes.v.dot(p[i])};
            }
            return c;
        }
        const std::array<double, 3> u = longitudes(p);
        for (std::size_t i = 0; i < 3; ++i) {
            const double around = place.by_length ? 2 * std::numbers::pi * p[i].length() : 1;
            c[i] = Vec2(u[i], latitude(p[i])) * Vec2(around, place.by_length ? around / 2 : 1);
        }
        return c;
    }

    [[nodiscard]] std::array<Vec3, 3> positions(std::size_t triangle, const Mat44& map) const {
        std::array<Vec3, 3> result;
        for (std::size_t i = 0; i < 3; ++i) {
            result[i] = Vec3(mesh_.vertices[mesh_.triangles[triangle][i]]) * map;
        }
        return result;
    }

    [[nodiscard]] Corners uv(std::size_t triangle) const {
        if (mesh_.uv.empty()) {
            return {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
        }
        Corners result;
        for (std::size_t i = 0; i < 3; ++i) {
            result[i] = Vec2(mesh_.uv[mesh_.triangles[triangle][i]]);
        }
        return result;
    }

    [[nodiscard]] Vec2 lengths(std::size_t triangle) {
        if (!std::holds_alternative<render::MeshShape>(on_.shape)) {
            const Vec3 n = flat_normal(positions(triangle, on_.object_from_mesh));
            return uv_lengths(on_.shape, n, on_.metres_from_object);
        }
        if (length_of_mesh_ < 0) {
            length_of_mesh_ = mesh_.uv.empty() ? 0 : uv_length(mesh_);
        }
        return Vec2(length_of_mesh_);
    }

    static Corners times(Corners c, const Vec2& factor) {
        for (Vec2& at : c) {
            at *= factor;
        }
        return c;
    }

    const render::TriangleMesh& mesh_;
    const MeshOnObject& on_;
    Mat44 metres_from_mesh_;
    double length_of_mesh_ = -1;  // not yet computed
};

}  // namespace

FlatAxes flat_axes(const Vec3& facing) {
    constexpr double kLevel = 1e-6;  // of the axis z across the side, below which it has no up
    const Vec3 up = kUp - kUp.dot(facing) * facing;
    if (up.length() < kLevel) {
        return {{facing.z > 0 ? 1.0 : -1.0, 0, 0}, {0, 1, 0}};
    }
    const Vec3 v = up.normalized();
    return {v.cross(facing), v};
}

std::vector<std::vector<Imath::V2f>> texture_coordinates(render::TriangleMesh& mesh,
                                                         const std::vector<TexturePlace>& places,
                                                         const MeshOnObject& on) {
    using OfAllPlaces = std::array<Imath::V2f, kMostTexturePlaces>;
    CAROM_ASSERT(places.size() <= kMostTexturePlaces);
    std::vector<std::array<OfAllPlaces, 3>> corners(mesh.triangles.size());
    Coordinates coordinates(mesh, on);
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Corners c = coordinates.at(triangle, places[i]);
            for (std::size_t k = 0; k < 3; ++k) {
                corners[triangle][k][i] = Imath::V2f(c[k]);
            }
        }
    }
    const std::vector<OfAllPlaces> values = split_vertices(mesh, corners);
    std::vector<std::vector<Imath::V2f>> result(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (const OfAllPlaces& value : values) {
            result[i].push_back(value[i]);
        }
    }
    return result;
}

}  // namespace carom::pipeline
