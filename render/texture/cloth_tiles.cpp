#include "render/texture/cloth_tiles.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <span>
#include <thread>
#include <vector>

#include "render/texture/noise_grid.h"

namespace carom::render {
namespace {

constexpr int kTexelsPerThread = 8;
constexpr int kThreads = ClothCells::kThreads;
constexpr int kSize = kThreads * kTexelsPerThread;
constexpr int kNoiseSize = 256;  // texels along a side of nap and wear: four per finest cell

constexpr std::uint32_t kWanderSeed = 0x38495ab5u;
constexpr std::uint32_t kFuzzSeed = 0x51ed270bu;
constexpr std::uint32_t kNapSeed = 0x2545f491u;
constexpr std::uint32_t kWearSeed = 0x8f1bbcdcu;

// Chosen by eye against photographs of worsted cloth.
constexpr float kWander = 0.40f;  // of the threads' courses, in threads
constexpr float kWeaveHeight = 0.55f;
constexpr float kFuzzHeight = 0.60f;

// Rounded: 0 at both edges of a thread, 1 in its middle, without creases.
float thread_profile(float fraction) {
    const float x = 4.0f * fraction * (1.0f - fraction);
    return x * x * (3.0f - 2.0f * x);
}

// Height in [0, 1] of a plain weave with one thread per unit, alternating over and under.
float weave_height(const V2f& p) {
    const float floor_x = std::floor(p.x);
    const float floor_y = std::floor(p.y);
    const float x = thread_profile(p.x - floor_x);
    const float y = thread_profile(p.y - floor_y);
    const bool warp_is_above =
        ((static_cast<std::int64_t>(floor_x) + static_cast<std::int64_t>(floor_y)) & 1) != 0;
    return warp_is_above ? x * (0.25f + 0.75f * y) : y * (0.25f + 0.75f * x);
}

NoiseGrid weave_noise(int cells_x, int cells_y, std::uint32_t seed) {
    return {kSize, cells_x, cells_y, seed};
}

/// The heights of the weave's texels.
class Relief {
  public:
    Relief() {
        for (std::uint32_t octave = 0; octave < kOctaves; ++octave) {
            const int fine = 40 << octave;
            const int along = 17 << octave;
            fuzz_.push_back(weave_noise(fine, along, kFuzzSeed + 2 * octave));
            fuzz_.push_back(weave_noise(along, fine, kFuzzSeed + 2 * octave + 1));
        }
    }

    void row(int y, std::span<float> heights) const {
        std::vector<float> first(kSize);
        std::vector<float> second(kSize);
        // Threads are spun from wool: their courses wander by a good part of their width.
        wander_x_.row(y, first);
        wander_y_.row(y, second);
        for (std::size_t x = 0; x < kSize; ++x) {
            const V2f p((static_cast<float>(x) + 0.5f) / kTexelsPerThread,
                        (static_cast<float>(y) + 0.5f) / kTexelsPerThread);
            heights[x] = kWeaveHeight * weave_height(p + V2f(first[x], second[x]) * kWander);
        }
        // Loose fibres: short streaks along both directions, in octaves.
        float amplitude = kFuzzHeight;
        for (std::size_t octave = 0; octave < kOctaves; ++octave) {
            fuzz_[2 * octave].row(y, first);
            fuzz_[2 * octave + 1].row(y, second);
            for (std::size_t x = 0; x < kSize; ++x) {
                heights[x] += amplitude * 0.5f * (first[x] + second[x]);
            }
            amplitude *= 0.7f;
        }
    }

  private:
    static constexpr std::uint32_t kOctaves = 3;

    NoiseGrid wander_x_ = weave_noise(45, 45, kWanderSeed);
    NoiseGrid wander_y_ = weave_noise(45, 45, kWanderSeed + 1);
    std::vector<NoiseGrid> fuzz_;
};

std::size_t place(int x, int y) {
    return static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x);
}

// Rows [0, count) on several threads, because a frame waits until the tiles are made.
template <class Work>
void for_rows(int count, const Work& work) {
    const int parts = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 16);
    std::vector<std::future<void>> running;
    running.reserve(static_cast<std::size_t>(parts));
    for (int part = 0; part < parts; ++part) {
        running.push_back(std::async(std::launch::async, [=, &work] {
            for (int row = count * part / parts; row < count * (part + 1) / parts; ++row) {
                work(row);
            }
        }));
    }
    for (std::future<void>& one : running) {
        one.get();
    }
}

ColourPyramid make_weave() {
    std::vector<float> heights(static_cast<std::size_t>(kSize) * kSize);
    const Relief relief;
    for_rows(kSize, [&](int y) { relief.row(y, std::span(heights).subspan(place(0, y), kSize)); });
    double sum = 0;
    for (const float height : heights) {
        sum += height;
    }
    const float mean = static_cast<float>(sum / (kSize * kSize));
    const auto at = [&](int x, int y) {
        return heights[place((x + kSize) % kSize, (y + kSize) % kSize)];
    };
    std::vector<HalfColourCodec::Texel> texels;
    texels.reserve(heights.size());
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            texels.push_back(HalfColourCodec::encode(
                {at(x, y) - mean, (at(x + 1, y) - at(x - 1, y)) * 0.5f * kTexelsPerThread,
                 (at(x, y + 1) - at(x, y - 1)) * 0.5f * kTexelsPerThread, 1}));
        }
    }
    return ColourPyramid(kSize, kSize, texels, Wrap::repeat);
}

// Noise with `cells` cells along a side, and `octaves` - 1 finer octaves of half the amplitude
// each.
SignedPyramid make_noise(int cells, int octaves, std::uint32_t seed) {
    std::vector<float> sums(static_cast<std::size_t>(kNoiseSize) * kNoiseSize);
    std::vector<float> values(kNoiseSize);
    float amplitude = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        const NoiseGrid noise(kNoiseSize, cells << octave, cells << octave,
                              seed + static_cast<std::uint32_t>(octave));
        for (std::size_t y = 0; y < kNoiseSize; ++y) {
            noise.row(static_cast<int>(y), values);
            for (std::size_t x = 0; x < kNoiseSize; ++x) {
                sums[y * kNoiseSize + x] += amplitude * values[x];
            }
        }
        amplitude *= 0.5f;
    }
    std::vector<SignedCodec::Texel> texels(sums.size());
    std::transform(sums.begin(), sums.end(), texels.begin(), SignedCodec::encode);
    return SignedPyramid(kNoiseSize, kNoiseSize, texels, Wrap::repeat);
}

}  // namespace

std::shared_ptr<const ClothTiles> make_cloth_tiles() {
    return std::make_shared<const ClothTiles>(
        ClothTiles{make_weave(), make_noise(ClothCells::kNap, 1, kNapSeed),
                   make_noise(ClothCells::kWear, 3, kWearSeed)});
}

}  // namespace carom::render
