#include "render/frame/feature_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace carom::render {
namespace {

/// Rays of a pixel after each round. Aligned runs of 4^k samples are well distributed.
constexpr std::array<int, 3> kRounds{4, 16, 64};
constexpr int kLastOfFewSamples = 32;  // instead of 64, for less than kFewSamples
constexpr int kFewSamples = 8;
constexpr int kLastOfManySamples = 128;  // from kManySamples on
constexpr int kManySamples = 32;

/// A pixel gets the rays of a round if a feature's range among its samples and rays is larger than
/// this. Features are of the order of 1; lights count in proportion, and normals a quarter, because
/// the weave of cloth turns them by more than it changes what is seen.
constexpr std::array<float, 3> kDifferent{1.0F / 64, 1.0F / 32, 1.0F / 8};
/// With fewer samples the ranges count less, in proportion: what few samples leave of the noise is
/// more than what few rays add.
constexpr int kEnoughSamples = 11;
constexpr float kWeightOfNormal = 0.25F;

/// Before the first round a pixel counts as seeing what pixels within this distance see, because
/// its halves may agree by chance; then this is true of lights only, because a few rays easily miss
/// a small bright one out of focus, and of all else within kNear.
constexpr int kReach = 2;
constexpr int kNear = 1;

/// How much a sample counts against a camera ray. Samples have means of their own that are worth
/// more than 4 rays where little varies, and with many samples than 64. If all of their noise went
/// into the exact features, the comparison with these could not take it out of the colours. Half
/// was best for 2 to 128 samples of the nine-ball break, the jump shot and the benchmark scene.
constexpr float kWeightOfSample = 0.5F;

constexpr std::uint64_t kOwnNumbers = 0xd1b54a32d192ed03;  // so that no sample has the same ones

/// By pixel of a rectangle, the range of a feature that decides about more rays.
class Ranges {
  public:
    [[nodiscard]] float& at(int x, int y) { return values_[index(x) + kRow * index(y)]; }

    /// Each value becomes the largest one within `kDistance`, in rows and in columns.
    template <int kDistance>
    void widen() {
        static_assert(kDistance <= kReach);
        Values wider{};
        for (const std::ptrdiff_t step : {std::ptrdiff_t{1}, static_cast<std::ptrdiff_t>(kRow)}) {
            for (std::size_t y = kReach; y < kReach + kSide; ++y) {
                for (std::size_t x = 0; x < kSide; ++x) {
                    const float* value = &values_[kRow * y + kReach + x];
                    float largest = 0;
                    for (std::ptrdiff_t k = -kDistance; k <= kDistance; ++k) {
                        largest = std::max(largest, value[k * step]);
                    }
                    wider[kRow * y + kReach + x] = largest;
                }
            }
            std::swap(values_, wider);
        }
    }

  private:
    static constexpr std::size_t kSide = FeatureTracer::kMostSide;
    static constexpr std::size_t kRow = kSide + std::size_t{2} * kReach;  // with zeros around
    using Values = std::array<float, kRow * kRow>;

    [[nodiscard]] static std::size_t index(int i) { return static_cast<std::size_t>(i) + kReach; }

    Values values_{};
};

}  // namespace

/// What a pixel's samples and rays saw up to now.
struct FeatureTracer::Sums {
    PixelFeatures sum{};  // of rays
    PixelFeatures least{};
    PixelFeatures most{};
    int rays = 0;

    explicit Sums(const PixelFeatures (&halves)[2]) : least(halves[0]), most(halves[0]) {
        include(halves[1]);
    }
    void add(const RadianceSample& sample) {
        sum += PixelFeatures::of(sample);
        rays += 1;
    }
    void include(const PixelFeatures& value) {
        for (std::size_t i = 0; i < PixelFeatures::kPadded; ++i) {
            least.values[i] = std::min(least[i], value[i]);
            most.values[i] = std::max(most[i], value[i]);
        }
    }
    /// The largest ranges of albedo and normal, and of light.
    [[nodiscard]] std::pair<float, float> ranges() const {
        std::array<float, PixelFeatures::kCount> range{};
        for (std::size_t i = 0; i < range.size(); ++i) {
            const float size = std::max(1.0F, std::max(most[i], -least[i]));
            const bool is_normal = i >= PixelFeatures::kNormal && i < PixelFeatures::kLight;
            const float all = (is_normal ? kWeightOfNormal : 1.0F) * (most[i] - least[i]);
            range[i] = size > 1 ? all / size : all;  // most sizes are 1, and divisions are slow
        }
        const auto light = range.begin() + PixelFeatures::kLight;
        return {*std::max_element(range.begin(), light), *std::max_element(light, range.end())};
    }
};

/// Collects rays and hands their results to the pixels in the order of the requests.
class FeatureTracer::Queue {
  public:
    explicit Queue(const FeatureTracer& tracer) : tracer_(tracer), workspace_(tracer.workspaces_) {
        sums_.reserve(results_.size());
    }

    bool is_last_round = false;  // after which no ranges are asked for

    void add(const FeaturePixel& pixel, const SampleStream& stream, Sums& sums) {
        batch_.add(stream, {pixel.x, pixel.y, 0});
        sums_.push_back(&sums);
        if (batch_.count == batch_.capacity) {
            flush();
        }
    }

    void flush() {
        make_rays(tracer_.camera_, tracer_.fixings_, batch_);
        tracer_.integrator_.trace_first_hits(CameraRun::all(batch_), tracer_.pixel_spread_,
                                             results_.data(), workspace_.get());
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            if (tracer_.camera_.has_weights()) {
                results_[i].weigh(batch_.weight[i]);
            }
            sums_[i]->add(results_[i]);
            if (!is_last_round) {
                sums_[i]->include(PixelFeatures::of(results_[i]));
            }
        }
        sums_.clear();
        batch_.count = 0;
    }

  private:
    const FeatureTracer& tracer_;
    WorkspacePool::Loan workspace_;
    CameraBatch batch_;
    std::vector<Sums*> sums_;
    std::vector<RadianceSample> results_ =
        std::vector<RadianceSample>(static_cast<std::size_t>(batch_.capacity));
};

FeatureTracer::FeatureTracer(const Integrator& integrator, WorkspacePool& workspaces,
                             const ThinLensCamera& camera, const CameraFixings& fixings,
                             float pixel_spread, int samples, std::uint64_t seed)
    : integrator_(integrator),
      workspaces_(workspaces),
      camera_(camera),
      fixings_(fixings),
      pixel_spread_(pixel_spread),
      seed_(seed ^ kOwnNumbers) {
    const float scale =
        std::max(1.0F, static_cast<float>(kEnoughSamples) / static_cast<float>(samples));
    for (std::size_t round = 0; round < kRounds.size(); ++round) {
        rounds_[round] = {kRounds[round], scale * kDifferent[round]};
    }
    if (samples < kFewSamples) {
        rounds_.back().rays = kLastOfFewSamples;
    }
    if (samples >= kManySamples) {
        rounds_.back().rays = kLastOfManySamples;
    }
}

namespace {

/// The pixels that see different things, in order. `ranges`: of albedo and normal, and of light.
std::vector<std::size_t> choose(std::span<const FeaturePixel> pixels,
                                std::span<const std::pair<float, float>> ranges, float negligible,
                                bool is_first_round) {
    Ranges near;
    Ranges far;
    const int left = pixels.front().x;
    const int top = pixels.front().y;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto [range, of_light] = ranges[i];
        const int x = pixels[i].x - left;
        const int y = pixels[i].y - top;
        near.at(x, y) = range;
        far.at(x, y) = is_first_round ? std::max(range, of_light) : of_light;
    }
    near.widen<kNear>();
    far.widen<kReach>();
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const int x = pixels[i].x - left;
        const int y = pixels[i].y - top;
        if (std::max(near.at(x, y), far.at(x, y)) > negligible) {
            chosen.push_back(i);
        }
    }
    return chosen;
}

}  // namespace

void FeatureTracer::trace(std::span<FeaturePixel> pixels) const {
    std::vector<Sums> sums;
    sums.reserve(pixels.size());
    for (const FeaturePixel& pixel : pixels) {
        sums.emplace_back(pixel.halves);
    }
    Queue queue(*this);
    std::vector<int> known(pixels.size(), -1);  // rays that the ranges are those of
    std::vector<std::pair<float, float>> ranges(pixels.size());
    for (const Round& round : rounds_) {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (known[i] != sums[i].rays) {
                known[i] = sums[i].rays;
                ranges[i] = sums[i].ranges();
            }
        }
        queue.is_last_round = &round == &rounds_.back();
        const std::vector<std::size_t> chosen =
            choose(pixels, ranges, round.negligible, &round == &rounds_.front());
        if (chosen.empty()) {
            break;  // the next rounds ask for more
        }
        for (const std::size_t i : chosen) {
            const SampleStream first(seed_, static_cast<std::uint32_t>(pixels[i].x),
                                     static_cast<std::uint32_t>(pixels[i].y), 0);
            for (int ray = sums[i].rays; ray < round.rays; ++ray) {
                queue.add(pixels[i], first.of_sample(static_cast<std::uint32_t>(ray)), sums[i]);
            }
        }
        queue.flush();
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i].traced = {sums[i].sum, sums[i].rays};
    }
}

PixelFeatures TracedFeatures::with_samples(const PixelFeatures (&halves)[2], int samples) const {
    const float weight = kWeightOfSample * static_cast<float>(samples);
    PixelFeatures total = sum;
    for (const PixelFeatures& half : halves) {
        total += half * (0.5F * weight);
    }
    const float all = static_cast<float>(rays) + weight;
    return all > 0 ? total * (1.0F / all) : PixelFeatures();
}

float TracedFeatures::share_of_samples(int samples) const {
    const float weight = kWeightOfSample * static_cast<float>(samples);
    return weight > 0 ? weight / (static_cast<float>(rays) + weight) : 0.0F;
}

}  // namespace carom::render
