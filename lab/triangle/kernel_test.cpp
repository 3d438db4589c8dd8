#include "lab/triangle/kernel_test.h"

#include <utility>

#include "lab/triangle/scalar_kernels.h"

namespace carom::render::triangle {

namespace {

template <KernelName kName>
class KernelTest final : public TriangleTest {
    using Kernel = scalar::KernelOf<kName>;
    using L = ScalarLanes<float>;

  public:
    explicit KernelTest(const std::vector<std::array<V3f, 3>>& triangles) {
        for (const auto& [a, b, c] : triangles) {
            inputs_.push_back(scalar::make_input<Kernel, best_input(kName), L>({a, b, c}));
        }
    }

    [[nodiscard]] bool closest(std::size_t triangle, const Ray& ray, Hit& hit) const override {
        const auto found = Kernel::template intersect<Division::early>(
            scalar::RayIn<L>{scalar::triple<float>(ray.origin),
                             scalar::triple<float>(ray.direction), ray.t_min, ray.t_max},
            scalar::record_of<Kernel, L>(inputs_[triangle]));
        if (found.valid) {
            hit.t = found.t;
            hit.u = found.u;
            hit.v = found.v;
        }
        return found.valid;
    }

  private:
    std::vector<scalar::InputOf<Kernel, best_input(kName), L>> inputs_;
};

}  // namespace

TriangleTestMaker triangle_test(KernelName kernel) {
    return [kernel](const std::vector<std::array<V3f, 3>>& triangles) {
        std::shared_ptr<const TriangleTest> test;
        [&]<std::size_t... kIndices>(std::index_sequence<kIndices...>) {
            (void)((kernel == static_cast<KernelName>(kIndices) &&
                    (test =
                         std::make_shared<KernelTest<static_cast<KernelName>(kIndices)>>(triangles),
                     true)) ||
                   ...);
        }
        (std::make_index_sequence<kKernelCount>());
        return test;
    };
}

}  // namespace carom::render::triangle
