#include <tuple>

#include "core/assert.h"
#include "lab/triangle/kernel_run.h"
#include "lab/triangle/run_factories.h"
#include "lab/triangle/scalar_kernels.h"

namespace carom::render::triangle {

namespace scalar {

#define CAROM_KERNEL [[gnu::always_inline]] inline
#include "lab/triangle/kernels/forms.h"
#undef CAROM_KERNEL

}  // namespace scalar

namespace {

template <class T>
struct Best {
    T t = kInfinity;
    T u = 0, v = 0;
    std::int32_t triangle = -1;
};

template <class Kernel, Input kInput, Division kDivision, class T>
class SingleRun final : public KernelRun {
    using L = ScalarLanes<T>;

  public:
    explicit SingleRun(const TestSet& set)
        : rays_in_group_(set.rays_in_group), triangles_in_group_(set.triangles_in_group) {
        for (std::size_t i = 0; i < set.origins.size(); ++i) {
            rays_.push_back({scalar::triple<T>(set.origins[i]),
                             scalar::triple<T>(set.directions[i]), T(0), T(kInfinity)});
        }
        for (const TriangleCorners& triangle : set.triangles) {
            triangles_.push_back(scalar::make_input<Kernel, kInput, T>(triangle));
        }
        best_.resize(rays_.size());
    }

    void run() override {
        const std::size_t groups = triangles_.size() / static_cast<unsigned>(triangles_in_group_);
        for (std::size_t group = 0; group < groups; ++group) {
            const auto* triangles = &triangles_[group * static_cast<unsigned>(triangles_in_group_)];
            const std::size_t first = group * static_cast<unsigned>(rays_in_group_);
            for (int i = 0; i < rays_in_group_; ++i) {
                best_[first + static_cast<unsigned>(i)] =
                    nearest(rays_[first + static_cast<unsigned>(i)], triangles);
            }
        }
    }

    [[nodiscard]] Packing packing() const override { return Packing::single; }

    [[nodiscard]] std::vector<NearestHit> hits() const override {
        std::vector<NearestHit> hits;
        for (const Best<T>& best : best_) {
            hits.push_back({static_cast<double>(best.t), static_cast<double>(best.u),
                            static_cast<double>(best.v), best.triangle});
        }
        return hits;
    }

  private:
    using Triangle = scalar::InputOf<Kernel, kInput, L>;

    Best<T> nearest(scalar::RayIn<L> ray, const Triangle* triangles) const {
        Best<T> best;
        for (int i = 0; i < triangles_in_group_; ++i) {
            const auto hit = Kernel::template intersect<kDivision>(
                ray, scalar::record_of<Kernel, L>(triangles[i]));
            if (hit.valid) {
                best = {hit.t, hit.u, hit.v, i};
                ray.t_max = hit.t;
            }
        }
        return best;
    }

    int rays_in_group_;
    int triangles_in_group_;
    std::vector<scalar::RayIn<L>> rays_;
    std::vector<Triangle> triangles_;
    std::vector<Best<T>> best_;
};

}  // namespace

std::unique_ptr<KernelRun> make_single_run(const Form& form, Precision precision,
                                           const TestSet& set) {
    if (precision == Precision::single_precision) {
        return scalar::make_in_form<SingleRun, float>(form, set);
    }
    return scalar::make_in_form<SingleRun, double>(form, set);
}

std::unique_ptr<KernelRun> make_run(const Variant& variant, const TestSet& set) {
    CAROM_ASSERT(set.rays_in_group % 8 == 0);
    CAROM_ASSERT(set.triangles_in_group % 8 == 0);
    switch (variant.packing) {
        case Packing::single:
            break;
        case Packing::four_rays:
            return make_rays_run(variant.form, variant.precision, 4, set);
        case Packing::eight_rays:
            return make_rays_run(variant.form, variant.precision, 8, set);
        case Packing::four_triangles:
            return make_triangles_run(variant.form, variant.precision, 4, set);
        case Packing::eight_triangles:
            return make_triangles_run(variant.form, variant.precision, 8, set);
    }
    return make_single_run(variant.form, variant.precision, set);
}

std::vector<NearestHit> reference_hits(Precision precision, const TestSet& set) {
    using scalar::MollerTrumbore;
    constexpr Division kEarly = Division::early;
    std::unique_ptr<KernelRun> run;
    if (precision == Precision::single_precision) {
        run = std::make_unique<SingleRun<MollerTrumbore, Input::corners, kEarly, double>>(set);
    } else {
        run = std::make_unique<SingleRun<MollerTrumbore, Input::corners, kEarly, long double>>(set);
    }
    run->run();
    return run->hits();
}

}  // namespace carom::render::triangle
