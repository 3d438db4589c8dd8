// How the cost of a ray grows with the number of shapes.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "lab/comparison/comparison.h"

namespace carom::pipeline {

enum class GrowingScene {
    spheres,  // in a cube, of which they fill the same fraction for any number
    mesh,     // a torus knot of ever smaller triangles
    balls     // like the spheres; half of them move, each with an impact during the shutter
};

struct GrowingSceneFacts {
    GrowingScene scene;
    std::string_view name;
    std::string_view shapes;  // what it is made of
    std::string_view what;
    LaboratoryScene (*make)(std::size_t shapes);
};
[[nodiscard]] std::span<const GrowingSceneFacts> growing_scenes();
[[nodiscard]] const GrowingSceneFacts& facts(GrowingScene scene);

struct GrowthOptions {
    GrowingScene scene = GrowingScene::spheres;
    std::vector<render::AccelerationKind> structures;
    /// Numbers in a vector, which the machine has (LaneLimit): each structure is measured with each
    /// of them. Empty: only with the processor's.
    std::vector<int> lanes;
    std::size_t largest = 1'000'000;
    double most_tests = 1e9;       // brute force is left out beyond this number
    double enough_seconds = 0.15;  // CPU time spent on the rays of each kind, at least
};

/// One structure, with one size of vectors, for one scene. Arrays are by kind of ray, in the order
/// of render::RayKind.
struct GrowthPoint : StructureCost {
    std::size_t shapes = 0;
    std::array<double, 3> seconds_per_ray{};  // CPU time of intersection alone
    double seconds_per_ray_of_batch = 0;      // in batches of kBatchRays closest-hit queries
    double seconds_per_shadow_ray_of_batch = 0;
};

struct Growth {
    GrowingScene scene = GrowingScene::spheres;
    std::vector<std::string> structures;  // in their order
    std::vector<GrowthPoint> points;      // by number of shapes, then by structure
    bool is_whole = false;

    /// Numbers of shapes, ascending.
    [[nodiscard]] std::vector<std::size_t> sizes() const;
    /// Null if it was not measured.
    [[nodiscard]] const GrowthPoint* point(const std::string& name, std::size_t shapes) const;
};

/// From ten shapes on, with about two steps per factor of ten. Every structure gets the same rays:
/// from a camera, onwards from their hits, and from there to a light. If `stop` is triggered, the
/// points measured are returned. Throws Error.
[[nodiscard]] Growth measure_growth(const GrowthOptions& options,
                                    const ComparisonProgress& progress,
                                    const std::stop_token& stop);

}  // namespace carom::pipeline
