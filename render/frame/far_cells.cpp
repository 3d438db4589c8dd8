#include "render/frame/far_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "core/error.h"
#include "core/splitmix.h"
#include "render/geometry/constants.h"
#include "render/light/scalar_kernels.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

constexpr int kRounds = 8;
constexpr std::size_t kWalkers = 64;  // in a round
constexpr int kSteps = 96;            // of a walker
constexpr int kStepsOfWalk = 8;       // then it starts anew
constexpr int kRows = 8;              // of rays at a step, and as many columns
constexpr int kRays = kRows * kRows;
constexpr float kLongestStep = 20;  // m

struct Found {
    std::uint64_t key;
    FarPoint point;
};

class Walker {
  public:
    Walker(const TransportScene& scene, const FarGrid& grid, const V3f& start,
           const std::vector<std::int32_t>& numbers, std::uint64_t seed)
        : scene_(scene),
          grid_(grid),
          start_(start),
          numbers_(numbers),
          random_(seed * kSplitMixStep) {}

    std::vector<Found> walk() {
        for (int step = 0; step < kSteps; ++step) {
            if (step % kStepsOfWalk == 0) {
                place_ = start_;
            }
            look_around();
            move();
        }
        return std::move(found_);
    }

  private:
    static constexpr std::size_t kSize = kRays + RayBatch::kBeyond;

    /// A random number in [0, 1).
    float next() { return static_cast<float>(random_.next() >> 40U) * 0x1p-24F; }

    /// Uniformly in all directions.
    void look_around() {
        for (int ray = 0; ray < kRays; ++ray) {
            const float across = (static_cast<float>(ray % kRows) + next()) / kRows;
            const float z = 1 - 2 * (static_cast<float>(ray / kRows) + next()) / kRows;
            const float r = std::sqrt(std::max(0.0F, 1 - z * z));
            const auto turn = scalar::sin_cos<scalar::One>(kTurn * across);
            const V3f direction = V3f(r * turn.cosine, r * turn.sine, z).normalized();
            const auto at = static_cast<std::size_t>(ray);
            for (int axis = 0; axis < 3; ++axis) {
                origins_[static_cast<std::size_t>(axis)][at] = place_[axis];
                directions_[static_cast<std::size_t>(axis)][at] = direction[axis];
            }
        }
        batch_ = {kRays,
                  {origins_[0].data(), origins_[1].data(), origins_[2].data()},
                  {directions_[0].data(), directions_[1].data(), directions_[2].data()},
                  times_.data()};
        scene_.frame.structure().closest_hits(batch_, hits_.data());
        for (int ray = 0; ray < kRays; ++ray) {
            note(batch_.ray(ray, kInfinity), hits_[static_cast<std::size_t>(ray)]);
        }
    }

    void note(const Ray& ray, const Hit& hit) {
        if (hit.object >= numbers_.size() || numbers_[hit.object] < 0) {
            return;
        }
        const SurfacePoint surface = scene_.frame.surface_at(ray, hit);
        const float distance = grid_.distance(surface.position);
        const float margin = 1.5F * grid_.side(grid_.level(distance));
        const Imath::Box3f& near = grid_.near();
        const V3f in = V3f(margin) + V3f(FarGrid::kBand, FarGrid::kBand, 0);
        if (Imath::Box3f(near.min + in, near.max - in).intersects(surface.position)) {
            return;
        }
        const V3f& normal = surface.geometric_normal;
        const FarPoint point{surface.position, normal.dot(ray.direction) > 0 ? -normal : normal};
        const int least = grid_.level(distance - margin);
        const int most = grid_.level(distance + margin);
        for (int level = least; level <= most; ++level) {
            found_.push_back({FarGrid::key(static_cast<std::uint32_t>(numbers_[hit.object]),
                                           FarGrid::face(point.normal), level,
                                           grid_.place(point.position, level)),
                              point});
        }
    }

    /// Some way along one of the rays.
    void move() {
        const auto ray = std::min(static_cast<int>(next() * kRays), kRays - 1);
        const float free = std::min(hits_[static_cast<std::size_t>(ray)].t, kLongestStep);
        place_ += batch_.ray(ray, 0).direction * (free * (0.05F + 0.9F * next()));
    }

    const TransportScene& scene_;
    const FarGrid& grid_;
    V3f start_, place_{0, 0, 0};
    const std::vector<std::int32_t>& numbers_;
    SplitMix64 random_;
    std::array<std::array<float, kSize>, 3> origins_{}, directions_{};
    std::array<float, kSize> times_{};
    std::array<Hit, kSize> hits_{};
    RayBatch batch_;
    std::vector<Found> found_;
};

using Cells = std::unordered_map<std::uint64_t, FarPoints>;

void add(const Found& found, Cells& cells) {
    FarPoints& cell = cells[found.key];
    cell.key = found.key;
    if (cell.count < FarPoints::kMost) {
        cell.points[cell.count++] = found.point;
    }
}

}  // namespace

std::vector<FarPoints> find_far_cells(const TransportScene& scene, const FarGrid& grid,
                                      const V3f& start, const std::vector<std::int32_t>& numbers,
                                      const WorkContext& context) {
    Cells cells;
    for (std::uint64_t round = 0; round < kRounds; ++round) {
        std::vector<std::vector<Found>> found(kWalkers);
        parallel_for(kWalkers, [&](std::size_t walker) {
            if (!context.stop.stop_requested()) {
                found[walker] =
                    Walker(scene, grid, start, numbers, round * kWalkers + walker).walk();
            }
        });
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        // In the order of the walkers, so that the points do not depend on threads.
        for (const std::vector<Found>& of_walker : found) {
            for (const Found& point : of_walker) {
                add(point, cells);
            }
        }
    }
    std::vector<FarPoints> sorted;
    sorted.reserve(cells.size());
    for (const auto& [key, cell] : cells) {
        // One alone is at an edge of the surface, or hardly anybody sees it: its neighbours do.
        if (cell.count > 1) {
            sorted.push_back(cell);
        }
    }
    std::ranges::sort(sorted, {}, &FarPoints::key);
    return sorted;
}

}  // namespace carom::render
