// One frame rendered with each of several structures, and what that took.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "lab/comparison/laboratory_scene.h"
#include "render/acceleration/structure_cost.h"

namespace carom::pipeline {

/// When a shadow ray has been answered.
enum class ShadowRays {
    any,     // at the first hit that is found
    closest  // not before the nearest one is known, as the oldest ray tracers did it
};

struct ComparisonOptions {
    std::vector<render::AccelerationKind> structures;  // at least one, in the order of the rows
    std::vector<ShadowRays> shadow_rays{ShadowRays::any};
    int threads = 0;  // 0: as many as there are processors
    /// Brute force that would test more is computed from the number of rays and a part of the
    /// picture.
    double most_tests = 1e9;
    /// Quick frames are timed again until that long was spent on them, CPU time; 0: once.
    double enough_seconds = 1;
};

/// A row.
struct ComparedStructure {
    std::string name;
    ShadowRays shadow_rays = ShadowRays::any;
    double build_seconds = 0;  // CPU time
    std::size_t bytes = 0;     // without the shapes themselves
    double cpu_seconds = 0;    // of the frame, all threads, shading counted, building not
    bool is_counted = false;   // whether `tests` means anything
    bool is_computed = false;  // tests and CPU time come from a part of the picture
    render::TestCounts tests;  // by kind of ray
};

struct Comparison {
    std::string name;
    std::string what;
    int width = 0, height = 0;  // pixels
    std::uint64_t shapes = 0;   // that brute force tests for every ray
    render::TestCounts rays;    // only their numbers
    std::vector<ComparedStructure> rows;
    bool is_whole = false;  // false: stopped before all rows were there

    /// The row of brute force with the same shadow rays; null if there is none.
    [[nodiscard]] const ComparedStructure* yardstick(const ComparedStructure& row) const;
};

/// `doing`: the structure that is at work; `share` of everything that is done, in [0, 1].
using ComparisonProgress = std::function<void(std::string_view doing, double fraction)>;

/// Every frame is rendered with its tests counted, where they can be, and apart from that for its
/// time: several times if it is quick, of which the least counts. When
/// `stop` is triggered the comparison ends with the rows that are there. Throws Error.
[[nodiscard]] Comparison compare_structures(const LaboratoryScene& scene,
                                            const ComparisonOptions& options,
                                            const ComparisonProgress& progress,
                                            const std::stop_token& stop);

/// "kdtree"
[[nodiscard]] std::string_view name_of(render::AccelerationKind kind);

/// "all", or names with commas between them, each once. Throws Error that names what is wrong and
/// lists the names.
[[nodiscard]] std::vector<render::AccelerationKind> structures_from_text(const std::string& text);

}  // namespace carom::pipeline
