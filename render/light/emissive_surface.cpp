#include "render/light/emissive_surface.h"

#include "render/light/scalar_kernels.h"

namespace carom::render {
namespace {

/// So many faces at most are sampled by area; shapes other than meshes have fewer.
constexpr std::size_t kFewTriangles = 32;

float area_of(const EmissiveSurface::Triangle& t) {
    return 0.5f * (t[1] - t[0]).cross(t[2] - t[0]).length();
}

}  // namespace

EmissiveSurface::EmissiveSurface(const std::vector<Triangle>& triangles, const V3f& radiance)
    : triangles_(triangles), radiance_(radiance) {
    double sum = 0;
    std::vector<double> up_to;
    std::vector<LightBounds> faces;
    for (const Triangle& triangle : triangles) {
        LightBounds& face = faces.emplace_back();
        const float area = area_of(triangle);
        if (area > 0) {
            sum += static_cast<double>(area);
            for (const V3f& corner : triangle) {
                face.box.extendBy(corner);
            }
            face.axis = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
            face.spread = 0;
            face.strength = luminance(radiance) * area;
            bounds_ = bounds_.with(face);
        }
        up_to.push_back(sum);
    }
    if (!(sum > 0)) {
        return;
    }
    for (const double area : up_to) {
        // Also 1 after the last one that has an area.
        area_cdf_.push_back(area < sum ? static_cast<float>(area / sum) : 1.0F);
    }
    area_ = static_cast<float>(sum);
    // Half of the area, as the orientation is unknown.
    importance_ = {bounds_.box.center(), 0.5f * bounds_.box.size().length(),
                   luminance(radiance_) * area_ * 0.5f};
    if (triangles.size() > kFewTriangles) {
        tree_ = LightTree(faces);
    }
}

EmissiveSurfaceConstants EmissiveSurface::constants() const {
    static_assert(sizeof(Triangle) == 9 * sizeof(float));
    return {List<float>(triangles_.front().front().getValue(),
                        9 * static_cast<std::int64_t>(triangles_.size())),
            List<float>(area_cdf_),
            area_,
            radiance_,
            importance_,
            tree_.data()};
}

}  // namespace carom::render
