#include "render/sampling/sampler.h"

#include "core/splitmix.h"
#include "render/sampling/scalar_kernels.h"

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

CameraSample SampleStream::camera_sample() const {
    float u[5];
    scalar::SamplerOf<One>(pixel_hash_, reversed_sample_).get_camera_sample(u);
    return {V2f(u[0], u[1]), V2f(u[2], u[3]), u[4]};
}

std::array<float, 4> SampleStream::next_4d() {
    float u[4];
    scalar::SamplerOf<One>(pixel_hash_, reversed_sample_).get_4d(set_, u);
    set_ += 1;
    return {u[0], u[1], u[2], u[3]};
}

float SampleStream::get_1d(std::uint32_t set) const {
    return scalar::SamplerOf<One>(pixel_hash_, reversed_sample_).get_1d(set);
}

}  // namespace carom::render
