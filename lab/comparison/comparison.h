// One frame rendered with each of several structures, and the costs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "lab/comparison/laboratory_scene.h"
#include "lab/structures/acceleration_names.h"
#include "lab/structures/structure_options.h"
#include "lab/structures/test_counts.h"
#include "lab/triangle/variant.h"

namespace carom::pipeline {

/// When a shadow ray ends.
enum class ShadowRays {
    any,     // at the first hit found
    closest  // only at the nearest one, as in the oldest ray tracers
};
/// "any" or "closest".
[[nodiscard]] const char* name_of(ShadowRays shadow_rays);

struct ComparisonOptions {
    std::vector<render::AccelerationKind> structures;  // at least one, in the order of the rows
    /// Each structure is measured with each of these triangle tests; all of them have a choice
    /// (has_triangle_tests). Empty: only with the renderer's.
    std::vector<render::triangle::KernelName> kernels;
    std::vector<ShadowRays> shadow_rays{ShadowRays::any};
    int threads = 0;  // 0: one per processor
    /// Upper bound on the tests of structures without an order; beyond it they are computed from
    /// the number of rays and a part of the picture.
    double most_tests = 1e9;
    render::StructureSizes sizes;
    /// Quick frames are repeated until this much CPU time was spent, s; 0: no repetition.
    double enough_seconds = 1;
};

/// What is known of a structure in every measurement.
struct StructureCost {
    std::string name;          // "bvh" or, of several variants, "bvh, wald" or "bvh, 8 lanes"
    double build_seconds = 0;  // CPU time
    std::size_t bytes = 0;     // without the shapes themselves
    bool is_counted = false;   // whether `tests` is valid
    render::TestCounts tests;  // by kind of ray
};

/// A row of the result.
struct ComparedStructure : StructureCost {
    ShadowRays shadow_rays = ShadowRays::any;
    double cpu_seconds = 0;    // of the frame, all threads, including shading, excluding the build
    bool is_computed = false;  // tests and CPU time are extrapolated from a part of the picture
};

struct Comparison {
    std::string name;
    std::string what;
    int width = 0, height = 0;  // pixels
    std::uint64_t shapes = 0;   // number that brute force tests for every ray
    render::TestCounts rays;    // only the numbers of rays
    std::vector<ComparedStructure> rows;
    bool is_whole = false;  // false: stopped before all rows were measured

    /// The row of brute force with the same shadow rays; null if it is missing.
    [[nodiscard]] const ComparedStructure* brute_force_row(const ComparedStructure& row) const;
};

/// `structure`: the current one; `fraction`: of all work, in [0, 1].
using ComparisonProgress = std::function<void(std::string_view structure, double fraction)>;

/// Every frame is rendered once with its tests counted, if they can be, and once or more for its
/// time, of which the least counts. If `stop` is triggered, the comparison ends with the rows
/// measured. Throws Error.
[[nodiscard]] Comparison compare_structures(const LaboratoryScene& scene,
                                            const ComparisonOptions& options,
                                            const ComparisonProgress& progress,
                                            const std::stop_token& stop);

/// Whether a ray's tests are as many as the shapes.
[[nodiscard]] bool is_linear(render::AccelerationKind kind);

/// "all", or a comma-separated list of names without repetition. Throws Error that names the
/// mistake and lists the names.
[[nodiscard]] std::vector<render::AccelerationKind> structures_from_text(const std::string& text);

/// Those of the structures whose triangle tests can be chosen, if `text` is "all"; otherwise all of
/// `text`. Throws Error if one of these has no choice.
[[nodiscard]] std::vector<render::AccelerationKind> structures_with_kernels(
    const std::string& text);

/// Likewise those that depend on the size.
[[nodiscard]] std::vector<render::AccelerationKind> structures_with_size(const std::string& text,
                                                                         render::VariedSize size);

}  // namespace carom::pipeline
