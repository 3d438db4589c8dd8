// The kernels of textures in vector lanes, called for arrays: for tests and benchmarks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "render/texture/scalar_kernels.h"
#include "render/texture/texture_data.h"

namespace carom::test {

/// As many numbers as the widest lanes have, or a multiple of it.
constexpr std::size_t kLaneMultiple = 16;

/// The numbers of TexturePointOf, a list for each. All lists have the same size, a multiple of
/// kLaneMultiple.
struct PointLists {
    static constexpr std::size_t kNumbers =
        sizeof(render::scalar::TexturePointOf<render::scalar::One>) / sizeof(float);

    std::array<std::vector<float>, kNumbers> numbers;

    [[nodiscard]] std::size_t size() const { return numbers[0].size(); }
    void add(const render::SurfacePoint& point, float width);
};

struct TextureLanes {
    /// Of every point: the colour by channel.
    void (*colours)(const render::TextureData& texture, const PointLists& points,
                    float* const colour[3]);
    /// Of every point of a cloth: the colour and the shift of the normal by axis.
    void (*reliefs)(const render::TextureData& texture, const PointLists& points,
                    float* const colour[3], float* const shift[3]);
    /// The value of the half float in the lower 16 bits of each word.
    void (*halves)(const std::vector<std::uint32_t>& words, float* values);
    std::string_view target;  // "AVX2" ...
};

/// Calls `use` with the kernels of each instruction set of this machine, also those above AVX2.
void for_every_target(const std::function<void(const TextureLanes& lanes)>& use);

/// Those of the best one.
[[nodiscard]] const TextureLanes& best_texture_lanes();

}  // namespace carom::test
