#include "pipeline/export/painted_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pipeline/export/shape_mesh.h"

namespace carom::pipeline {

namespace {

// The spots of render/texture/kernels/ball_paint.h, in ball radii.
constexpr double kSpotRadius = 0.105;
const Vec3 kSpotColour(0.52, 0.02, 0.018);

constexpr double kNoCircle = 2;  // above the sphere, so that there is no circle

/// The height above the centre of a circle on the unit sphere, given its chord radius.
double height_of_circle(double chord_radius) {
    return std::sqrt(1 - chord_radius * chord_radius);
}

/// Cuts off both caps of the sphere about an axis.
void cut_caps(render::MeshShape& sphere, int axis, double height) {
    Vec3 normal(0, 0, 0);
    normal[axis] = 1;
    if (height < 1) {
        cut_unit_sphere(sphere, normal, height);
        cut_unit_sphere(sphere, normal, -height);
    }
}

}  // namespace

PaintedSphere painted_sphere(const render::BallTexture& paint) {
    const double band = paint.striped ? paint.band_width : kNoCircle;
    const double disc = paint.number != 0 ? height_of_circle(paint.disc_radius) : kNoCircle;
    const double spot = paint.spots != 0 ? height_of_circle(kSpotRadius) : kNoCircle;
    PaintedSphere result;
    render::MeshShape& sphere = result.mesh;
    sphere = unit_sphere_mesh();
    cut_caps(sphere, 2, band);
    cut_caps(sphere, 0, disc);
    for (const int axis : {0, 1, 2}) {
        cut_caps(sphere, axis, spot);
    }
    std::array<std::vector<std::array<std::uint32_t, 3>>, 3> fields;
    for (const auto& triangle : sphere.triangles) {
        const Vec3 p = (sphere.vertices[triangle[0]] + sphere.vertices[triangle[1]] +
                        sphere.vertices[triangle[2]])
                           .normalized();
        const Vec3 height(std::abs(p.x), std::abs(p.y), std::abs(p.z));
        const bool is_spot = std::max({height.x, height.y, height.z}) > spot;
        const bool is_white = height.x > disc || height.z > band;
        fields[is_spot ? 2 : is_white ? 1 : 0].push_back(triangle);
    }
    const std::array<std::pair<const char*, Vec3>, 3> colours{
        {{"", paint.colour}, {"white", paint.white}, {"spots", kSpotColour}}};
    sphere.triangles.clear();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (!fields[i].empty()) {
            result.fields.push_back({colours[i].first, colours[i].second, fields[i].size()});
            sphere.triangles.insert(sphere.triangles.end(), fields[i].begin(), fields[i].end());
        }
    }
    return result;
}

}  // namespace carom::pipeline
