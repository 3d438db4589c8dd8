#include "render/light/emissive_surface.h"

#include <algorithm>
#include <cmath>

#include <Imath/ImathBox.h>

#include "render/light/scalar_kernels.h"
#include "render/sampling/one_minus_epsilon.h"

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

std::optional<LightSample> EmissiveSurface::sample(const V3f& point, const V2f& u) const {
    const auto found = std::upper_bound(area_cdf_.begin(), area_cdf_.end() - 1, u.x);
    const auto index = static_cast<std::size_t>(found - area_cdf_.begin());
    const float before = index > 0 ? area_cdf_[index - 1] : 0.0f;
    const float fraction = area_cdf_[index] - before;
    const float rest =
        fraction > 0 ? std::clamp((u.x - before) / fraction, 0.0f, kOneMinusEpsilon) : 0.5f;
    // Uniform over the triangle (Turk 1990, "Generating random points in triangles").
    const float root = std::sqrt(rest);
    const Triangle& t = triangles_[index];
    const V3f place = t[0] * (1 - root) + t[1] * (root * (1 - u.y)) + t[2] * (root * u.y);
    const V3f to_light = place - point;
    const float distance = to_light.length();
    const V3f normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    if (!(distance > 1e-9f)) {
        return std::nullopt;
    }
    const float cosine = -to_light.dot(normal) / distance;
    if (cosine <= 0) {
        return std::nullopt;
    }
    return LightSample{to_light / distance, distance, pdf(distance, cosine), V2f(0, 0)};
}

float EmissiveSurface::importance(const V3f& point, const V3f& normal) const {
    return scalar::importance_of_object<scalar::One>(importance_, scalar::three(point),
                                                     scalar::three(normal));
}

}  // namespace carom::render
