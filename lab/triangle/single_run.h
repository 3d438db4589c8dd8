// One ray against one triangle after another.
#pragma once

#include <memory>
#include <vector>

#include "lab/triangle/number_table.h"
#include "lab/triangle/one_by_one.h"
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
            store_numbers(Given::numbers(triangle), numbers_, i, Indices());
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
    [[gnu::always_inline]] void load(Numbers numbers, std::size_t index,
                                     std::index_sequence<kIndices...>) const {
        ((std::get<kIndices>(numbers) = *numbers_.place(index, kIndices)), ...);
    }

    NumberTable<typename L::Number, Indices::size(), 1, Technique::arrays> numbers_;
    std::vector<typename L::Axis> axes_;  // of kernels with an axis
};

/// T: of kVariant's precision, or long double.
template <Variant kVariant, class T>
class SingleRun final : public OneByOne<SingleRun<kVariant, T>, kVariant, T> {
    using Base = OneByOne<SingleRun, kVariant, T>;
    static constexpr Form kForm = kVariant.form;
    static constexpr Technique kTechnique = kVariant.technique;
    using Kernel = scalar::KernelOf<kForm.kernel>;
    using L = scalar::LanesOf<kTechnique, ScalarLanes<T>>;

  public:
    explicit SingleRun(const TestSet& set) : Base(set), triangles_(set.triangles) {
        for (std::size_t i = 0; i < set.origins.size(); ++i) {
            rays_.push_back({scalar::triple<T>(set.origins[i]),
                             scalar::triple<T>(set.directions[i]), T(0), T(kInfinity)});
        }
    }

    [[nodiscard]] typename Base::Best nearest(std::size_t ray_index,
                                              std::size_t first_triangle) const {
        scalar::TestedRay<kTechnique, L> ray(rays_[ray_index]);
        typename Base::Best best;
        for (int i = 0; i < this->triangles_in_group(); ++i) {
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

  private:
    std::vector<scalar::RayIn<L>> rays_;
    SingleTriangles<Kernel, kForm.input, kTechnique, L> triangles_;
};

}  // namespace carom::render::triangle
