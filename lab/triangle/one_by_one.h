// Runs that take one ray after another.
#pragma once

#include <vector>

#include "lab/triangle/kernel_run.h"
#include "render/geometry/ray.h"

namespace carom::render::triangle {

/// T: of the hits. Run has Best nearest(std::size_t ray, std::size_t first_triangle) const.
template <class Run, Variant kVariant, class T>
class OneByOne : public KernelRun {
  public:
    explicit OneByOne(const TestSet& set)
        : rays_in_group_(set.rays_in_group),
          triangles_in_group_(set.triangles_in_group),
          best_(set.origins.size()) {}

    void run() final {
        for (std::size_t ray = 0; ray < best_.size(); ++ray) {
            const std::size_t group = ray / static_cast<unsigned>(rays_in_group_);
            best_[ray] = static_cast<const Run*>(this)->nearest(
                ray, group * static_cast<unsigned>(triangles_in_group_));
        }
    }

    [[nodiscard]] Packing packing() const final { return kVariant.packing; }

    [[nodiscard]] std::vector<NearestHit> hits() const final {
        std::vector<NearestHit> hits;
        for (const Best& best : best_) {
            hits.push_back({static_cast<double>(best.t), static_cast<double>(best.u),
                            static_cast<double>(best.v), best.triangle});
        }
        return hits;
    }

  protected:
    struct Best {
        T t = T(kInfinity);
        T u = 0, v = 0;
        std::int32_t triangle = -1;
    };

    [[nodiscard]] int triangles_in_group() const { return triangles_in_group_; }

  private:
    int rays_in_group_;
    int triangles_in_group_;
    std::vector<Best> best_;
};

}  // namespace carom::render::triangle
