// How the cost of a ray grows with the number of shapes.
#pragma once

#include <array>
#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "lab/comparison/comparison.h"

namespace carom::pipeline {

enum class GrowingScene {
    spheres,  // in a cube, which they fill to the same part whatever their number
    mesh,     // a torus knot, of ever smaller triangles
    balls     // like the spheres, but half of them move, each with an impact within the shutter
};

struct GrowthOptions {
    GrowingScene scene = GrowingScene::spheres;
    std::vector<render::AccelerationKind> structures;
    std::size_t largest = 1'000'000;
    double most_tests = 1e9;       // brute force is left out where it would take more
    double enough_seconds = 0.15;  // CPU time for which the rays of a kind are asked, at least
};

/// One structure over one scene. By kind of ray, as render::RayKind has them.
struct GrowthPoint {
    std::string name;
    std::size_t shapes = 0;
    double build_seconds = 0;  // CPU time
    std::size_t bytes = 0;
    std::array<double, 3> seconds_per_ray{};  // CPU time of finding hits, nothing else
    double seconds_per_ray_of_batch = 0;      // nearest hits of kBatchRays rays at a time
    bool is_counted = false;
    render::TestCounts tests;
};

struct Growth {
    GrowingScene scene = GrowingScene::spheres;
    std::vector<std::string> structures;  // in their order
    std::vector<GrowthPoint> points;      // by number of shapes, then by structure
    bool is_whole = false;

    /// Numbers of shapes, ascending.
    [[nodiscard]] std::vector<std::size_t> sizes() const;
    /// Null if it is not there.
    [[nodiscard]] const GrowthPoint* point(const std::string& name, std::size_t shapes) const;
};

/// From ten shapes on, about two steps to a factor of ten. The same rays for every structure: from
/// a camera, onwards from where those end, and from there to a light. When `stop` is triggered the
/// points that are there remain. Throws Error.
[[nodiscard]] Growth measure_growth(const GrowthOptions& options,
                                    const ComparisonProgress& progress,
                                    const std::stop_token& stop);

}  // namespace carom::pipeline
