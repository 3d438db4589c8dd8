#include "render/frame/far_panorama.h"

#include <algorithm>
#include <cstddef>

#include "render/geometry/constants.h"
#include "render/integrator/far_surfaces.h"
#include "render/integrator/wave/make_wave_scene.h"
#include "render/light/scalar_kernels.h"
#include "render/threads/thread_arena.h"

namespace carom::render {
namespace {

constexpr int kColumns = FarLight::kColumns;
constexpr int kRows = kColumns / 2;
constexpr int kRaysAcross = 4;  // a pixel: small lamps fill less than one
constexpr int kRaysOfPixel = kRaysAcross * kRaysAcross;

std::vector<V3f> places_above(const FarRegion& region) {
    constexpr float kPlaces[] = {0.15F, 0.5F, 0.85F};  // of the box
    constexpr float kHeight = 0.03F;                   // above it, m
    const V3f low(region.low), high(region.high);
    std::vector<V3f> places;
    for (const float x : kPlaces) {
        for (const float y : kPlaces) {
            places.emplace_back(low.x + x * (high.x - low.x), low.y + y * (high.y - low.y),
                                high.z + kHeight);
        }
    }
    return places;
}

/// Traces the rays of one row from one place after the other.
class RowTracer {
  public:
    RowTracer(const TransportScene& scene, const WaveScene& wave_scene, const FarSurfaces& surfaces)
        : scene_(scene),
          surfaces_(surfaces),
          hits_(scene, wave_scene, best_wave_kernels(), kColumns),
          numbers_(wave_scene.materials.varies ? std::size_t{kTexturedNumbers} : 0) {
        memory_.reserve(kColumns, rays_, found_, on_surfaces_);
        for (Floats& number : numbers_) {
            memory_.reserve(kColumns, number);
        }
        found_.numbers = numbers_.empty() ? nullptr : numbers_.data();
        rays_.count = kColumns;
        rays_.vertex = 0;  // they are traced against everything
    }

    void add(int row, const V3f& place, std::vector<V3f>& sums) {
        for (int k = 0; k < kRaysOfPixel; ++k) {
            begin(row, place, (static_cast<float>(k / kRaysAcross) + 0.5F) / kRaysAcross,
                  (static_cast<float>(k % kRaysAcross) + 0.5F) / kRaysAcross);
            add_rays(sums);
        }
    }

  private:
    void add_rays(std::vector<V3f>& sums) {
        const Hit* const hits = hits_.trace(rays_);
        on_surfaces_.count = 0;
        for (int i = 0; i < kColumns; ++i) {
            const V3f direction = rays_.direction.get(i);
            if (hits[i].object == kNoObject) {
                sums[static_cast<std::size_t>(i)] +=
                    scene_.lights.environment().radiance(direction);
                continue;
            }
            sums[static_cast<std::size_t>(i)] += emitted(rays_.origin.get(i), direction, hits[i]);
            if (surfaces_.is_far(rays_.origin.get(i), direction, hits[i], 0)) {
                on_surfaces_.add(i);
            }
        }
        hits_.find(rays_, on_surfaces_, found_);
        for (int i = 0; i < found_.count; ++i) {
            sums[static_cast<std::size_t>(found_.path.at[i])] += surfaces_.whole(found_, i);
        }
    }

    /// By what a ray hits.
    [[nodiscard]] V3f emitted(const V3f& origin, const V3f& direction, const Hit& hit) const {
        if (!scene_.far->grid().is_far(origin + direction * hit.t)) {
            return V3f(0);
        }
        if (scene_.is_light(hit)) {
            return scene_.lights.emitted(scene_.light_of(hit), origin + direction * hit.t,
                                         -direction);
        }
        const SurfacePoint point = scene_.frame.surface_at({origin, direction}, hit);
        const bool is_front = point.geometric_normal.dot(direction) < 0;
        return is_front ? scene_.materials[point.material].mean_emission() : V3f(0);
    }

    /// Rays from where they leave the near box; `down` and `across`: in the pixels.
    void begin(int row, const V3f& place, float down, float across) {
        const auto polar = scalar::sin_cos<scalar::One>(kPi * (static_cast<float>(row) + down) /
                                                        static_cast<float>(kRows));
        for (int column = 0; column < kColumns; ++column) {
            // As environment_uv (light/kernels/environment.h).
            const float u = (static_cast<float>(column) + across) / static_cast<float>(kColumns);
            const auto turn = scalar::sin_cos<scalar::One>(kTurn * (1.5F - u));
            const V3f direction =
                V3f(polar.sine * turn.cosine, polar.sine * turn.sine, polar.cosine).normalized();
            const float out = scene_.far->grid().way_out(place, direction);
            rays_.origin.set(column, place + direction * out);
            rays_.direction.set(column, direction);
            rays_.time.at[column] = 0;
            rays_.throughput.set(column, V3f(1));
            rays_.cone_width.at[column] = out * kPi / kRows;
            rays_.cone_spread.at[column] = kPi / kRows;
        }
    }

    const TransportScene& scene_;
    const FarSurfaces& surfaces_;
    HitSurfaces hits_;
    PathQueue rays_;
    SurfaceQueue found_;
    IndexList on_surfaces_;
    std::vector<Floats> numbers_;
    QueueMemory memory_;
};

/// As seen through a haze: lamps that are seen from nine places become one, and do not make rough
/// reflections noisy. With the kernel (cos a - cos kBlur)^2, whose standard deviation is about 5
/// degrees, in proportion to solid angles.
class Blur {
  public:
    Blur() {
        for (int row = 0; row < kRows; ++row) {
            const auto polar = scalar::sin_cos<scalar::One>(kPi * (static_cast<float>(row) + 0.5F) /
                                                            static_cast<float>(kRows));
            sine_.push_back(polar.sine);
            cosine_.push_back(polar.cosine);
        }
        for (int step = 0; step < kColumns; ++step) {
            turn_.push_back(scalar::sin_cos<scalar::One>(kTurn * static_cast<float>(step) /
                                                         static_cast<float>(kColumns))
                                .cosine);
        }
    }

    [[nodiscard]] V3f at(const std::vector<V3f>& picture, int row, int column) const {
        constexpr float kCosine = 0.9703F;  // of 14 degrees
        constexpr int kReach = kRows * 14 / 180 + 1;
        V3f sum(0);
        float weights = 0;
        for (int y = std::max(0, row - kReach); y <= std::min(kRows - 1, row + kReach); ++y) {
            for (int step = 0; step < kColumns; ++step) {
                const float cosine = cosine_of(row, y, step) - kCosine;
                if (cosine > 0) {
                    const float weight = cosine * cosine * sine_[static_cast<std::size_t>(y)];
                    sum += picture[static_cast<std::size_t>(y * kColumns +
                                                            (column + step) % kColumns)] *
                           weight;
                    weights += weight;
                }
            }
        }
        return sum / weights;
    }

  private:
    /// Of the angle between pixels of two rows, so many columns apart.
    [[nodiscard]] float cosine_of(int a, int b, int step) const {
        const auto i = static_cast<std::size_t>(a);
        const auto j = static_cast<std::size_t>(b);
        return sine_[i] * sine_[j] * turn_[static_cast<std::size_t>(step)] +
               cosine_[i] * cosine_[j];
    }

    std::vector<float> sine_, cosine_;  // of the rows' polar angles
    std::vector<float> turn_;           // cosines of columns' differences
};

}  // namespace

std::vector<SharedExponent> far_panorama(const TransportScene& scene, const FarRegion& region) {
    SceneArena arena;
    const WaveScene& wave_scene = make_wave_scene(
        scene, [](WaveScene&, SceneArena&) {}, arena);
    const FarSurfaces surfaces(scene);
    const std::vector<V3f> places = places_above(region);
    std::vector<V3f> seen(std::size_t{kColumns} * kRows);
    parallel_for(kRows, [&](std::size_t row) {
        RowTracer tracer(scene, wave_scene, surfaces);
        std::vector<V3f> sums(kColumns, V3f(0));
        for (const V3f& place : places) {
            tracer.add(static_cast<int>(row), place, sums);
        }
        for (std::size_t column = 0; column < kColumns; ++column) {
            seen[row * kColumns + column] =
                sums[column] / static_cast<float>(kRaysOfPixel * static_cast<int>(places.size()));
        }
    });
    const Blur blur;
    std::vector<SharedExponent> panorama(seen.size());
    parallel_for(kRows, [&](std::size_t row) {
        for (int column = 0; column < kColumns; ++column) {
            panorama[row * kColumns + static_cast<std::size_t>(column)] =
                SharedExponent(blur.at(seen, static_cast<int>(row), column));
        }
    });
    return panorama;
}

}  // namespace carom::render
