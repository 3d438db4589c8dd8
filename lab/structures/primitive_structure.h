// A structure over primitives, from an index that determines the order of the tests.
#pragma once

#include <utility>

#include "lab/structures/query.h"
#include "render/acceleration/measured_structure.h"
#include "render/acceleration/safe_ray.h"
#include "render/acceleration/shared_counts.h"
#include "render/acceleration/structure_options.h"

namespace carom::render {

/// `Index(const Primitives&, const StructureSizes&)` orders the bounded primitives and has
///   template <class Query> void search(Query& query) const,
/// which passes every primitive whose box the ray enters before its t_max to `query`, until a test
/// ends the search, and `std::size_t bytes() const`.
template <class Index>
class PrimitiveStructure final : public MeasuredStructure {
  public:
    PrimitiveStructure(Primitives primitives, const StructureOptions& options)
        : primitives_(std::move(primitives)),
          options_(options),
          index_(primitives_, options.sizes) {}

    [[nodiscard]] bool closest_hit(const Ray& ray, Hit& hit) const override {
        const Hit best = find(ray, ray.kind, false);
        if (best.object == kNoObject) {
            return false;
        }
        hit = best;
        return true;
    }
    [[nodiscard]] bool any_hit(const Ray& ray) const override {
        return find(ray, RayKind::shadow, options_.shadow_rays_stop).object != kNoObject;
    }
    [[nodiscard]] std::size_t bytes() const override { return index_.bytes(); }
    [[nodiscard]] TestCounts counts() const override { return counts_.current(); }

  private:
    [[nodiscard]] Hit find(const Ray& ray, RayKind kind, bool any) const {
        if (!is_traceable(ray)) {
            return {};
        }
        return options_.counts ? find_counting<true>(ray, kind, any)
                               : find_counting<false>(ray, kind, any);
    }

    template <bool Counting>
    [[nodiscard]] Hit find_counting(const Ray& ray, RayKind kind, bool any) const {
        Query<Counting> query(primitives_, made_safe(ray), any);
        bool over = false;
        for (const Primitive& plane : primitives_.planes()) {
            over = over || query.test(plane);
        }
        if (!over) {
            index_.search(query);
        }
        if constexpr (Counting) {
            counts_.add_ray(kind, query.counts());
        }
        return query.found() ? query.best() : Hit{};
    }

    Primitives primitives_;
    StructureOptions options_;
    Index index_;
    mutable SharedCounts counts_;
};

}  // namespace carom::render
