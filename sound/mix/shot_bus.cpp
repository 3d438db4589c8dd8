#include "sound/mix/shot_bus.h"

#include <algorithm>
#include <numbers>

#include "core/assert.h"
#include "core/vector_clones.h"
#include "sound/space/room.h"

namespace carom::sound {
namespace {

/// `samples` begins with the one before those that are added. `sums` overlaps nothing of it, which
/// lets the compiler use vectors.
CAROM_VECTOR_CLONES void add_filtered(const BusInput& input, const double* samples,
                                      std::span<double> sums) {
    double* __restrict sum = sums.data();
    for (std::size_t n = 0; n < sums.size(); ++n) {
        sum[n] += input.direct * samples[n + 1] + input.previous * samples[n];
    }
}

}  // namespace

ShotBus::ShotBus(const RoomSettings& room, bool is_mono)
    : is_mono_(is_mono), reverberation_(room), quiet_for_(kRing) {
    second_half_.a1 = ears_of(Stereo::sphere, Width::real, {}, {0, 1, 0}).left.a1;
    // All walls have the same filter (room.h).
    const auto reflections = reflections_of(room, room.floor_centre, room.floor_centre);
    const double pole = reflections.empty() ? 0 : reflections[0].pole;
    walls_.b0 = 1 - pole;
    walls_.a1 = -pole;
}

void ShotBus::add(const BusInput& input, std::span<const double> samples) {
    CAROM_ASSERT(samples.size() == kBlock + 1);
    if (input.delay > kLongestDelay) {
        return;
    }
    quiet_for_ = 0;
    if (input.to == BusInput::To::room) {
        for (std::size_t n = 0; n < kBlock; ++n) {
            room_[n] += input.direct * samples[n + 1];
        }
        return;
    }
    Line& line =
        lines_[(input.to == BusInput::To::right ? kRight : 0) |
               (input.is_reflected ? kReflected : 0) | (input.is_filtered ? kFiltered : 0)];
    if (line.ring.empty()) {
        line.ring.assign(kRing, 0);
    }
    const std::size_t place = (at_ + input.delay) % kRing;
    const std::size_t before_end = std::min(kBlock, kRing - place);
    const std::span<double> ring(line.ring);
    add_filtered(input, samples.data(), ring.subspan(place, before_end));
    add_filtered(input, samples.data() + before_end, ring.first(kBlock - before_end));
}

void ShotBus::take(unsigned index, std::span<double> channel) {
    Line& line = lines_[index];
    if (line.ring.empty()) {
        return;
    }
    static_assert(kRing % kBlock == 0, "a block does not reach over the ring's end");
    for (std::size_t n = 0; n < kBlock; ++n) {
        double sample = line.ring[at_ + n];
        line.ring[at_ + n] = 0;
        if ((index & kReflected) != 0) {
            sample = line.walls.run(walls_, sample);
        }
        if ((index & kFiltered) != 0) {
            sample = line.ear.run(second_half_, sample);
        }
        channel[n] += sample;
    }
}

void ShotBus::take(std::span<double> left, std::span<double> right) {
    CAROM_ASSERT(left.size() == kBlock && right.size() == kBlock);
    for (unsigned index = 0; index < lines_.size(); ++index) {
        take(index, (index & kRight) != 0 ? right : left);
    }
    if (is_mono_) {
        std::array<double, kBlock> first{};
        std::array<double, kBlock> second{};
        reverberation_.add(room_, first, second);
        for (std::size_t n = 0; n < kBlock; ++n) {
            const double both = (first[n] + second[n]) / std::numbers::sqrt2;
            left[n] += both;
            right[n] += both;
        }
    } else {
        reverberation_.add(room_, left, right);
    }
    room_.fill(0);
    at_ = (at_ + kBlock) % kRing;
    quiet_for_ = std::min(quiet_for_ + kBlock, 2 * kRing);
}

bool ShotBus::is_silent() const {
    return quiet_for_ > kRing && reverberation_.is_silent();
}

}  // namespace carom::sound
