// A kernel in one of its forms, ready to run over rays and triangles.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "lab/triangle/test_set.h"
#include "lab/triangle/variant.h"

namespace carom::render::triangle {

/// t = infinity and triangle = -1: no hit.
struct NearestHit {
    double t = std::numeric_limits<double>::infinity();
    double u = 0, v = 0;         // weights of the second and third corner
    std::int64_t triangle = -1;  // index in the group; of equally near ones the first
};

class KernelRun {
  public:
    KernelRun() = default;
    virtual ~KernelRun() = default;
    KernelRun(const KernelRun&) = delete;
    KernelRun& operator=(const KernelRun&) = delete;

    /// Tests every ray against every triangle of its group, in order; each ray keeps its nearest
    /// hit and accepts only nearer ones.
    virtual void run() = 0;

    /// The packing in use.
    [[nodiscard]] virtual Packing packing() const = 0;

    /// The nearest hit of every ray, after run(); with Technique::any_hit the triangle of the first
    /// one found, and no numbers.
    [[nodiscard]] virtual std::vector<NearestHit> hits() const = 0;
};

/// The run has its own copies of the rays, and of the triangles in the input's form. Empty for a
/// variant that does not exist (variants.h).
[[nodiscard]] std::unique_ptr<KernelRun> make_run(const Variant& variant, const TestSet& set);

/// The reference for all kernels: Möller and Trumbore's kernel in double precision; for double
/// precision itself, in long double.
[[nodiscard]] std::vector<NearestHit> reference_hits(Precision precision, const TestSet& set);

}  // namespace carom::render::triangle
