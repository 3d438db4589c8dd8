// One ray against one triangle after another.
#pragma once

#include <memory>
#include <vector>

#include "lab/triangle/kernel_run.h"
#include "lab/triangle/number_table.h"
#include "lab/triangle/scalar_kernels.h"

namespace carom::render::triangle {

/// The triangles of a run, side by side, or with one array for each number.
template <class Kernel, Input kInput, Technique kTechnique, class L>
class SingleTriangles {
    using Stored = scalar::StoredTriangle<kTechnique, scalar::InputOf<Kernel, kInput, L>>;

  public:
    explicit SingleTriangles(const std::vector<TriangleCorners>& triangles) {
        for (const TriangleCorners& triangle : triangles) {
            triangles_.push_back(scalar::stored_triangle<Kernel, kInput, kTechnique, L>(triangle));
        }
    }
    [[nodiscard]] const Stored& at(std::size_t index) const { return triangles_[index]; }

  private:
    std::vector<Stored> triangles_;
};

template <class Kernel, Input kInput, class L>
class SingleTriangles<Kernel, kInput, Technique::arrays, L> {
    using Given = scalar::InputOf<Kernel, kInput, L>;
    using Stored = scalar::StoredTriangle<Technique::arrays, Given>;
    using Indices = scalar::NumberIndices<Given>;

  public:
    explicit SingleTriangles(const std::vector<TriangleCorners>& triangles)
        : numbers_(triangles.size()) {
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const auto triangle = scalar::make_input<Kernel, kInput, L>(triangles[i]);
            store(Given::numbers(triangle), i, Indices());
            if constexpr (Given::kHasAxis) {
                axes_.push_back(triangle.axis);
            }
        }
    }
    [[nodiscard, gnu::always_inline]] Stored at(std::size_t index) const {
        Stored triangle;
        load(Given::numbers(triangle.input), index, Indices());
        if constexpr (Given::kHasAxis) {
            triangle.input.axis = axes_[index];
        }
        return triangle;
    }

  private:
    template <class Numbers, std::size_t... kIndices>
    void store(Numbers numbers, std::size_t index, std::index_sequence<kIndices...>) {
        ((*numbers_.place(index, kIndices) = std::get<kIndices>(numbers)), ...);
    }
    template <class Numbers, std::size_t... kIndices>
    [[gnu::always_inline]] void load(Numbers numbers, std::size_t index,
                                     std::index_sequence<kIndices...>) const {
        ((std::get<kIndices>(numbers) = *numbers_.place(index, kIndices)), ...);
    }

    NumberTable<typename L::Number, Indices::size(), 1, Technique::arrays> numbers_;
    std::vector<typename L::Axis> axes_;  // of kernels with an axis
};

/// T: of kVariant's precision, or long double.
template <Variant kVariant, class T>
class SingleRun final : public KernelRun {
    static constexpr Form kForm = kVariant.form;
    static constexpr Technique kTechnique = kVariant.technique;
    using Kernel = scalar::KernelOf<kForm.kernel>;
    using L = scalar::LanesOf<kTechnique, ScalarLanes<T>>;
    using Ray = scalar::TestedRay<kTechnique, L>;

  public:
    explicit SingleRun(const TestSet& set)
        : rays_in_group_(set.rays_in_group),
          triangles_in_group_(set.triangles_in_group),
          triangles_(set.triangles) {
        for (std::size_t i = 0; i < set.origins.size(); ++i) {
            rays_.push_back({scalar::triple<T>(set.origins[i]),
                             scalar::triple<T>(set.directions[i]), T(0), T(kInfinity)});
        }
        best_.resize(rays_.size());
    }

    void run() override {
        for (std::size_t ray = 0; ray < rays_.size(); ++ray) {
            const std::size_t group = ray / static_cast<unsigned>(rays_in_group_);
            best_[ray] =
                nearest(Ray(rays_[ray]), group * static_cast<unsigned>(triangles_in_group_));
        }
    }

    [[nodiscard]] Packing packing() const override { return Packing::single; }

    [[nodiscard]] std::vector<NearestHit> hits() const override {
        std::vector<NearestHit> hits;
        for (const Best& best : best_) {
            hits.push_back({static_cast<double>(best.t), static_cast<double>(best.u),
                            static_cast<double>(best.v), best.triangle});
        }
        return hits;
    }

  private:
    struct Best {
        T t = kInfinity;
        T u = 0, v = 0;
        std::int32_t triangle = -1;
    };

    Best nearest(Ray ray, std::size_t first_triangle) const {
        Best best;
        for (int i = 0; i < triangles_in_group_; ++i) {
            const auto& triangle = triangles_.at(first_triangle + static_cast<unsigned>(i));
            const auto hit = ray.template test<Kernel, kForm.division>(
                scalar::record_of<Kernel, L>(triangle.input), triangle.first);
            if (!hit.valid) {
                continue;
            }
            if constexpr (kTechnique == Technique::any_hit) {
                best.triangle = i;
                return best;
            }
            best = {hit.t, hit.u, hit.v, i};
            ray.set_t_max(hit.t);
        }
        return best;
    }

    int rays_in_group_;
    int triangles_in_group_;
    std::vector<scalar::RayIn<L>> rays_;
    SingleTriangles<Kernel, kForm.input, kTechnique, L> triangles_;
    std::vector<Best> best_;
};

}  // namespace carom::render::triangle
