// A structure over primitives, from an index that determines the order of the tests.
#pragma once

#include <utility>

#include "lab/structures/query.h"
#include "lab/structures/structure_options.h"
#include "lab/structures/test_counts.h"
#include "render/acceleration/acceleration_structure.h"
#include "render/acceleration/safe_ray.h"

namespace carom::render {

/// `Index(const Primitives&, const StructureSizes&)` orders the bounded primitives and has
///   template <class Query> void search(Query& query) const,
/// which passes every primitive whose box the ray enters before its t_max to `query`, until a test
/// ends the search, and `std::size_t bytes() const`.
template <class Index>
class PrimitiveStructure final : public AccelerationStructure {
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
    [[nodiscard]] std::size_t bytes() const { return index_.bytes(); }

  private:
    [[nodiscard]] Hit find(const Ray& ray, RayKind kind, bool any) const {
        if (!is_traceable(ray)) {
            return {};
        }
        return options_.counts != nullptr ? find_counting<true>(ray, kind, any)
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
            options_.counts->add_ray(kind, query.counts());
        }
        return query.found() ? query.best() : Hit{};
    }

    Primitives primitives_;
    StructureOptions options_;
    Index index_;
};

}  // namespace carom::render
