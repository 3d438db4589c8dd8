// A kernel in one of its forms, ready to be run over rays and triangles.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "lab/triangle/test_set.h"
#include "lab/triangle/variant.h"

namespace carom::render::triangle {

/// t = infinity, triangle = -1: none.
struct NearestHit {
    double t = std::numeric_limits<double>::infinity();
    double u = 0, v = 0;         // weights of the second and third corner
    std::int64_t triangle = -1;  // counted within the group; of equally near ones the first
};

class KernelRun {
  public:
    KernelRun() = default;
    virtual ~KernelRun() = default;
    KernelRun(const KernelRun&) = delete;
    KernelRun& operator=(const KernelRun&) = delete;

    /// Tests every ray against every triangle of its group, in order; each keeps its nearest hit
    /// and asks only for nearer ones.
    virtual void run() = 0;

    /// How it tests: as asked.
    [[nodiscard]] virtual Packing packing() const = 0;

    /// Of every ray, after run().
    [[nodiscard]] virtual std::vector<NearestHit> hits() const = 0;
};

/// Has its own copies of the rays, and of the triangles in the input's form. The form is one of
/// all_forms().
[[nodiscard]] std::unique_ptr<KernelRun> make_run(const Variant& variant, const TestSet& set);

/// The measure of all: Möller and Trumbore's kernel in double precision; for double precision
/// itself, in long double.
[[nodiscard]] std::vector<NearestHit> reference_hits(Precision precision, const TestSet& set);

}  // namespace carom::render::triangle
