#include "sound/space/reverberation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/splitmix.h"
#include "tests/sound/named_room.h"

namespace carom::sound {
namespace {

struct Channels {
    std::vector<double> left, right;
};

Channels reverberated(const RoomSettings& room, const std::vector<double>& source) {
    Channels channels{std::vector<double>(source.size()), std::vector<double>(source.size())};
    Reverberation reverberation(room);
    reverberation.add(source, channels.left, channels.right);
    return channels;
}

std::vector<double> impulse(double duration) {
    std::vector<double> samples(static_cast<std::size_t>(duration * kSampleRate));
    samples[0] = 1;
    return samples;
}

/// Noise, evenly distributed, with a root mean square of 1.
std::vector<double> noise(std::size_t count) {
    SplitMix64 random(5);
    std::vector<double> samples(count);
    for (double& sample : samples) {
        sample = random.between(-std::sqrt(3.0), std::sqrt(3.0));
    }
    return samples;
}

double mean_square(const std::vector<double>& samples, std::size_t first) {
    double sum = 0;
    for (std::size_t n = first; n < samples.size(); ++n) {
        sum += samples[n] * samples[n];
    }
    return sum / static_cast<double>(samples.size() - first);
}

/// The time of a decay of 60 dB in a band of 400 Hz around a frequency: from where the energy that
/// remains (Schroeder 1965) falls by 30 dB.
double decay_time(const Channels& response, double frequency) {
    std::vector<double> energy(response.left.size());
    for (const std::vector<double>* channel : {&response.left, &response.right}) {
        std::complex<double> once, twice;
        for (std::size_t n = 0; n < energy.size(); ++n) {
            const double angle =
                2 * std::numbers::pi * frequency * static_cast<double>(n) / kSampleRate;
            once += ((*channel)[n] * std::polar(1.0, -angle) - once) * 0.026;
            twice += (once - twice) * 0.026;
            energy[n] += std::norm(twice);
        }
    }
    for (std::size_t n = energy.size() - 1; n-- > 0;) {
        energy[n] += energy[n + 1];
    }
    // The line of least squares through the decibels from -5 to -35.
    double count = 0, time = 0, level = 0, time2 = 0, product = 0;
    for (std::size_t n = 0; n < energy.size(); ++n) {
        const double decibels = 10 * std::log10(energy[n] / energy[0]);
        if (decibels < -5 && decibels > -35) {
            const double t = static_cast<double>(n) / kSampleRate;
            count += 1;
            time += t;
            level += decibels;
            time2 += t * t;
            product += t * decibels;
        }
    }
    return -60 * (count * time2 - time * time) / (count * product - time * level);
}

TEST(Reverberation, Decay_TakesTheTimesOfTheRoom) {
    for (const RoomSettings& room :
         {room_named("studio"), room_named("club"), room_named("hall")}) {
        SCOPED_TRACE(room.reverberation_low);
        const Channels channels = reverberated(room, impulse(2 * room.reverberation_low));
        EXPECT_NEAR(decay_time(channels, 200) / room.reverberation_low, 1, 0.05);
        EXPECT_NEAR(decay_time(channels, kHighFrequency) / room.reverberation_high, 1, 0.05);
    }
}

TEST(Reverberation, SteadySource_IsAsLoudAsItsDirectSoundAtTheCriticalDistance) {
    for (RoomSettings room : {room_named("studio"), room_named("club"), room_named("hall")}) {
        room.reverberation_high = room.reverberation_low;
        const std::vector<double> source = noise(6 * kSampleRate);
        const Channels channels = reverberated(room, source);
        const double distance = critical_distance(room);
        for (const std::vector<double>& channel : {channels.left, channels.right}) {
            const double ratio = mean_square(channel, 3 * kSampleRate) * distance * distance /
                                 mean_square(source, 0);
            EXPECT_NEAR(10 * std::log10(ratio), 0, 0.5);
        }
    }
}

TEST(Reverberation, Channels_AreNotCorrelated) {
    const Channels channels = reverberated(room_named("club"), noise(4 * kSampleRate));
    double product = 0;
    for (std::size_t n = 0; n < channels.left.size(); ++n) {
        product += channels.left[n] * channels.right[n];
    }
    product /= static_cast<double>(channels.left.size());
    const double power = std::sqrt(mean_square(channels.left, 0) * mean_square(channels.right, 0));
    EXPECT_LT(std::abs(product / power), 0.1);
}

TEST(Reverberation, FirstEcho_ComesAfter21Milliseconds) {
    const Channels channels = reverberated(room_named("club"), impulse(0.1));
    for (std::size_t n = 0; n < 1009; ++n) {
        ASSERT_EQ(channels.left[n], 0);
    }
    EXPECT_NE(channels.left[1009], 0);
}

TEST(Reverberation, LongAfterTheSource_IsExactlySilent) {
    Reverberation reverberation(room_named("studio"));
    EXPECT_TRUE(reverberation.is_silent());
    std::vector<double> source(1024);
    source[3] = 1;
    std::vector<double> left(1024);
    std::vector<double> right(1024);
    reverberation.add(source, left, right);
    EXPECT_FALSE(reverberation.is_silent());
    source[3] = 0;
    int blocks = 0;
    while (!reverberation.is_silent() && blocks < 1000) {
        std::fill(left.begin(), left.end(), 0);
        reverberation.add(source, left, right);
        for (const double sample : left) {
            ASSERT_TRUE(sample == 0 || std::abs(sample) > 1e-300) << "denormal";
        }
        ++blocks;
    }
    // 60 dB in 0.25 s make 600 dB in 2.5 s, and the source's last echo has to leave the lines.
    EXPECT_LT(blocks, 3.5 * kSampleRate / 1024);
    std::fill(left.begin(), left.end(), 0);
    reverberation.add(source, left, right);
    EXPECT_EQ(left, std::vector<double>(1024));
}

TEST(Reverberation, BlockSize_ChangesNoBit) {
    std::vector<double> source = noise(20000);
    std::fill(source.begin() + 3000, source.end() - 2000, 0);
    const Channels whole = reverberated(room_named("club"), source);
    for (const std::size_t size : {1U, 64U, 1024U, 4096U}) {
        Channels parts{std::vector<double>(source.size()), std::vector<double>(source.size())};
        Reverberation reverberation(room_named("club"));
        for (std::size_t first = 0; first < source.size(); first += size) {
            const std::size_t count = std::min(size, source.size() - first);
            reverberation.add(std::span(source).subspan(first, count),
                              std::span(parts.left).subspan(first, count),
                              std::span(parts.right).subspan(first, count));
        }
        EXPECT_EQ(parts.left, whole.left) << size;
        EXPECT_EQ(parts.right, whole.right) << size;
    }
}

TEST(Reverberation, NoBoxOrDeadRoom_AddsNothing) {
    RoomSettings dead = room_named("club");
    dead.reverberation_low = dead.reverberation_high = 0.001;
    for (const RoomSettings& room : {room_named("outdoors"), room_named("none"), dead}) {
        const Channels channels = reverberated(room, noise(5000));
        EXPECT_EQ(channels.left, std::vector<double>(5000));
    }
}

}  // namespace
}  // namespace carom::sound
