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

/// The range of a feature among a pixel's rays from which on it gets another round. Features are of
/// the order of 1; those of lights count in proportion.
constexpr std::array<float, 2> kNegligible{1.0F / 32, 1.0F / 8};

/// A pixel counts as seeing what the pixels within this distance see, because a few rays easily
/// miss a small bright light out of focus.
constexpr int kReach = 2;

/// How much a sample counts against a camera ray. Samples have means of their own that are worth
/// more than 4 rays where little varies, and with many samples than 64. If all of their noise went
/// into the exact features, the comparison with these could not take it out of the colours. Half
/// was best for 2 to 128 samples of the nine-ball break, the jump shot and the benchmark scene.
constexpr float kWeightOfSample = 0.5F;

constexpr std::uint64_t kOwnNumbers = 0xd1b54a32d192ed03;  // so that no sample has the same ones

/// The largest value within `kReach`, for pixels of a rectangle.
std::vector<float> widened(std::span<const FeaturePixel> pixels, const std::vector<float>& values) {
    int left = pixels.front().x;
    int top = pixels.front().y;
    int right = left;
    int bottom = top;
    for (const FeaturePixel& pixel : pixels) {
        left = std::min(left, pixel.x);
        right = std::max(right, pixel.x);
        top = std::min(top, pixel.y);
        bottom = std::max(bottom, pixel.y);
    }
    const int width = right - left + 1;
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>((y - top) * width + x - left);
    };
    std::vector<float> grid(index(right, bottom) + 1, 0.0F);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        grid[index(pixels[i].x, pixels[i].y)] = values[i];
    }
    std::vector<float> result(values.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto [x, y] = std::pair(pixels[i].x, pixels[i].y);
        for (int v = std::max(top, y - kReach); v <= std::min(bottom, y + kReach); ++v) {
            for (int u = std::max(left, x - kReach); u <= std::min(right, x + kReach); ++u) {
                result[i] = std::max(result[i], grid[index(u, v)]);
            }
        }
    }
    return result;
}

}  // namespace

/// What a pixel's rays saw up to now.
struct FeatureTracer::Sums {
    PixelFeatures sum{};
    std::array<float, PixelFeatures::kCount> least{};
    std::array<float, PixelFeatures::kCount> most{};
    int rays = 0;

    void include(const PixelFeatures& value) {
        for (int i = 0; i < PixelFeatures::kCount; ++i) {
            const auto k = static_cast<std::size_t>(i);
            least[k] = std::min(least[k], value[i]);
            most[k] = std::max(most[k], value[i]);
        }
    }
    void add(const RadianceSample& sample) {
        PixelFeatures value;
        value.add(sample);
        if (rays == 0) {
            for (int i = 0; i < PixelFeatures::kCount; ++i) {
                least[static_cast<std::size_t>(i)] = most[static_cast<std::size_t>(i)] = value[i];
            }
        }
        include(value);
        sum.add(sample);
        rays += 1;
    }
    /// The largest range of a feature.
    [[nodiscard]] float range() const {
        float result = 0;
        for (std::size_t i = 0; i < least.size(); ++i) {
            const float size = std::max(1.0F, std::max(std::abs(most[i]), std::abs(least[i])));
            result = std::max(result, (most[i] - least[i]) / size);
        }
        return result;
    }
};

/// Collects rays and hands their results to the pixels in the order of the requests.
class FeatureTracer::Queue {
  public:
    explicit Queue(const FeatureTracer& tracer) : tracer_(tracer), workspace_(tracer.workspaces_) {
        sums_.reserve(kSize);
        tasks_.reserve(kSize);
    }

    void add(const FeaturePixel& pixel, const SampleStream& stream, Sums& sums) {
        const std::size_t i = sums_.size();
        batch_->x[i] = pixel.x;
        batch_->y[i] = pixel.y;
        batch_->pixel_hash[i] = static_cast<std::int32_t>(stream.pixel_hash());
        batch_->reversed_sample[i] = static_cast<std::int32_t>(stream.reversed_sample());
        sums_.push_back(&sums);
        tasks_.push_back({Ray{}, stream, {pixel.x, pixel.y, 0}});
        if (sums_.size() == kSize) {
            flush();
        }
    }

    void flush() {
        batch_->count = static_cast<int>(sums_.size());
        make_rays(tracer_.camera_, tracer_.fixings_, *batch_);
        for (std::size_t i = 0; i < tasks_.size(); ++i) {
            tasks_[i].ray = batch_->ray(static_cast<int>(i));
        }
        tracer_.integrator_.look(tasks_, tracer_.pixel_spread_, results_, workspace_.get());
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            sums_[i]->add(results_[i]);
        }
        sums_.clear();
        tasks_.clear();
    }

  private:
    static constexpr std::size_t kSize = CameraBatch::kMost;

    const FeatureTracer& tracer_;
    WorkspacePool::Loan workspace_;
    std::unique_ptr<CameraBatch> batch_ = std::make_unique<CameraBatch>();
    std::vector<Sums*> sums_;
    std::vector<CameraTask> tasks_;
    std::vector<RadianceSample> results_ = std::vector<RadianceSample>(kSize);
};

FeatureTracer::FeatureTracer(const Integrator& integrator, WorkspacePool& workspaces,
                             const ThinLensCamera& camera, const CameraFixings& fixings,
                             float pixel_spread, std::uint64_t seed)
    : integrator_(integrator),
      workspaces_(workspaces),
      camera_(camera),
      fixings_(fixings),
      pixel_spread_(pixel_spread),
      seed_(seed ^ kOwnNumbers) {}

void FeatureTracer::trace(std::span<FeaturePixel> pixels) const {
    std::vector<Sums> sums(pixels.size());
    std::vector<float> ranges(pixels.size());
    Queue queue(*this);
    for (std::size_t round = 0; round < kRounds.size(); ++round) {
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (round > 0 && ranges[i] <= kNegligible[round - 1]) {
                continue;
            }
            const SampleStream first(seed_, static_cast<std::uint32_t>(pixels[i].x),
                                     static_cast<std::uint32_t>(pixels[i].y), 0);
            for (int ray = sums[i].rays; ray < kRounds[round]; ++ray) {
                queue.add(pixels[i], first.of_sample(static_cast<std::uint32_t>(ray)), sums[i]);
            }
        }
        queue.flush();
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            sums[i].include(pixels[i].halves[0]);
            sums[i].include(pixels[i].halves[1]);
            ranges[i] = sums[i].range();
        }
        ranges = widened(pixels, ranges);
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
    return total * (1.0F / (static_cast<float>(rays) + weight));
}

float TracedFeatures::share_of_samples(int samples) const {
    const float weight = kWeightOfSample * static_cast<float>(samples);
    return weight / (static_cast<float>(rays) + weight);
}

}  // namespace carom::render
