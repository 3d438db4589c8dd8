#include "render/light/emissive_surface.h"

#include <Imath/ImathBox.h>

#include "render/light/scalar_kernels.h"

namespace carom::render {
namespace {

float area_of(const EmissiveSurface::Triangle& t) {
    return 0.5f * (t[1] - t[0]).cross(t[2] - t[0]).length();
}

}  // namespace

EmissiveSurface::EmissiveSurface(const std::vector<Triangle>& triangles, const V3f& radiance)
    : radiance_(radiance) {
    Imath::Box3f bounds;
    double sum = 0;
    std::vector<double> up_to;
    for (const Triangle& triangle : triangles) {
        const float area = area_of(triangle);
        if (!(area > 0)) {
            continue;
        }
        sum += static_cast<double>(area);
        triangles_.push_back(triangle);
        up_to.push_back(sum);
        for (const V3f& corner : triangle) {
            bounds.extendBy(corner);
        }
    }
    if (triangles_.empty()) {
        return;
    }
    for (const double area : up_to) {
        area_cdf_.push_back(static_cast<float>(area / sum));
    }
    area_cdf_.back() = 1;
    area_ = static_cast<float>(sum);
    // Half of the area, as the orientation is unknown.
    importance_ = {bounds.center(), 0.5f * bounds.size().length(),
                   luminance(radiance_) * area_ * 0.5f};
}

EmissiveSurfaceConstants EmissiveSurface::constants() const {
    static_assert(sizeof(Triangle) == 9 * sizeof(float));
    return {List<float>(triangles_.front().front().getValue(),
                        9 * static_cast<std::int64_t>(triangles_.size())),
            List<float>(area_cdf_), area_, radiance_, importance_};
}

}  // namespace carom::render
