#include "sound/level/loudness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>

#include <ebur128.h>

#include "core/assert.h"
#include "sound/sound_scene.h"

namespace carom::sound {

struct LoudnessMeter::State {
    State() : meter(ebur128_init(2, kSampleRate, EBUR128_MODE_I)) {
        if (meter == nullptr) {
            throw std::bad_alloc();
        }
    }
    ~State() { ebur128_destroy(&meter); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    ebur128_state* meter;
};

LoudnessMeter::LoudnessMeter() : state_(std::make_unique<State>()) {}
LoudnessMeter::~LoudnessMeter() = default;
LoudnessMeter::LoudnessMeter(LoudnessMeter&&) noexcept = default;
LoudnessMeter& LoudnessMeter::operator=(LoudnessMeter&&) noexcept = default;

void LoudnessMeter::add(std::span<const double> left, std::span<const double> right) {
    CAROM_ASSERT(left.size() == right.size());
    left_.add(left);
    right_.add(right);
    constexpr std::size_t kFrames = 512;
    std::array<double, 2 * kFrames> frames{};
    for (std::size_t first = 0; first < left.size(); first += kFrames) {
        const std::size_t count = std::min(kFrames, left.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            frames[2 * i] = left[first + i];
            frames[2 * i + 1] = right[first + i];
        }
        if (ebur128_add_frames_double(state_->meter, frames.data(), count) != EBUR128_SUCCESS) {
            throw std::bad_alloc();  // its only reason
        }
    }
}

double LoudnessMeter::integrated() const {
    double loudness = 0;
    if (ebur128_loudness_global(state_->meter, &loudness) != EBUR128_SUCCESS ||
        !std::isfinite(loudness)) {
        return -std::numeric_limits<double>::infinity();
    }
    return std::round(loudness * 100) / 100;
}

double LoudnessMeter::true_peak() const {
    return std::max(left_.peak(), right_.peak());
}

}  // namespace carom::sound
