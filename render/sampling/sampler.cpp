#include "render/sampling/sampler.h"

#include "core/splitmix.h"
#include "render/sampling/scalar_kernels.h"
#include "render/sampling/sobol_point.h"

namespace carom::render {
namespace {

using scalar::One;

std::uint64_t mix64(std::uint64_t z) {
    return split_mix(z + kSplitMixStep);
}

}  // namespace

SampleStream::SampleStream(std::uint64_t seed, std::uint32_t pixel_x, std::uint32_t pixel_y,
                           std::uint32_t sample)
    : reversed_sample_(detail::reverse_bits(sample)) {
    const std::uint64_t pixel = (static_cast<std::uint64_t>(pixel_y) << 32) | pixel_x;
    pixel_hash_ = static_cast<std::uint32_t>(mix64(mix64(seed) ^ pixel) >> 32);
}

SampleStream SampleStream::of_sample(std::uint32_t sample) const {
    SampleStream other = *this;
    other.reversed_sample_ = detail::reverse_bits(sample);
    other.set_ = 0;
    return other;
}

CameraSample camera_sample(std::uint32_t pixel_hash, std::uint32_t reversed_sample) {
    // The index is not shuffled here; the sets of the bounces are, each in a different order.
    const std::uint32_t set_hash = scalar::hash_of_set<One>(pixel_hash, detail::kCameraSet);
    const std::array<float, 4> point = detail::sobol_point(reversed_sample, set_hash);
    const float fifth = detail::sobol_fifth(reversed_sample, set_hash);
    return {V2f(point[0], point[1]), V2f(point[2], point[3]), fifth};
}

std::array<float, 4> SampleStream::next_4d() {
    const std::uint32_t set_hash = scalar::hash_of_set<One>(pixel_hash_, set_);
    set_ += 1;
    return detail::sobol_point(scalar::shuffled_index<One>(reversed_sample_, set_hash), set_hash);
}

std::array<V2f, 4> SampleStream::get_2d_block(std::uint32_t set) const {
    const std::uint32_t set_hash = scalar::hash_of_set<One>(pixel_hash_, set);
    const std::uint32_t shuffled = scalar::shuffled_index<One>(reversed_sample_, set_hash);
    // The index is 4 i: all four points are taken, so their order within the block does not matter.
    const std::array<float, 8> u = detail::sobol_block(shuffled >> 2, set_hash);
    return {V2f(u[0], u[4]), V2f(u[1], u[5]), V2f(u[2], u[6]), V2f(u[3], u[7])};
}

float SampleStream::get_1d(std::uint32_t set) const {
    return scalar::independent_number<One>(scalar::hash_of_set<One>(pixel_hash_, set),
                                           reversed_sample_);
}

}  // namespace carom::render
