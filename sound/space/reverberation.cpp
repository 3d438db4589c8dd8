#include "sound/space/reverberation.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/assert.h"
#include "core/elementary.h"
#include "sound/space/room.h"

namespace carom::sound {
namespace {

/// Prime numbers of samples, about geometrically between 21 and 53 ms, so that few echoes of
/// different lines coincide.
constexpr std::array<std::size_t, 16> kLengths{1009, 1069, 1151, 1213, 1291, 1373, 1459, 1553,
                                               1657, 1759, 1867, 1987, 2113, 2251, 2393, 2543};

/// Smaller values (Pa) count as silence: 1e-30 of any audible sound, and far above the denormal
/// numbers with which processors are slow.
constexpr double kDenormalThreshold = 1e-30;

/// Rows of the Hadamard matrix with which the lines are heard left and right. Row i has the sign
/// (-1)^(number of common bits of i and the line).
constexpr unsigned kLeftRow = 0b0101;
constexpr unsigned kRightRow = 0b1010;

constexpr bool is_negative(unsigned row, unsigned line) {
    unsigned common = row & line;
    common ^= common >> 2U;
    common ^= common >> 1U;
    return (common & 1U) != 0;
}

/// Multiplies by the Hadamard matrix, without its factor 1/4.
void mix(std::array<double, 16>& values) {
    for (std::size_t half = 1; half < values.size(); half *= 2) {
        for (std::size_t start = 0; start < values.size(); start += 2 * half) {
            for (std::size_t i = start; i < start + half; ++i) {
                const double a = values[i];
                const double b = values[i + half];
                values[i] = a + b;
                values[i + half] = a - b;
            }
        }
    }
}

/// The factor of a sound that decays by 60 dB in `reverberation` (s), after so many samples.
double decay(std::size_t samples, double reverberation) {
    return exponential(-3 * std::numbers::ln10 * static_cast<double>(samples) /
                       (kSampleRate * reverberation));
}

}  // namespace

Reverberation::Reverberation(const RoomSettings& room) {
    constexpr double kShortest = 0.020;  // s
    if (room.kind != RoomSettings::Kind::box || room.reverberation_low < kShortest) {
        return;
    }
    std::size_t first = 0;
    double kept = 0;  // mean of the energy that is left after a turn through a line
    for (const std::size_t length : kLengths) {
        Line line;
        line.length = length;
        line.first = first;
        line.gain = decay(length, room.reverberation_low);
        line.pole = pole_for(decay(length, room.reverberation_high) / line.gain);
        lines_.push_back(line);
        first += length;
        kept += line.gain * line.gain / kLines;
    }
    memory_.assign(first, 0);
    // The matrix spreads the energy evenly over the lines, so an impulse of energy 1, which enters
    // through factors of 1/4, comes out of all lines with kept + kept^2 + ..., and is heard with
    // factors of +-1/4.
    const double heard = kept / (1 - kept) / kLines;
    level_ = 1 / (critical_distance(room) * std::sqrt(heard));
}

void Reverberation::add(std::span<const double> source, std::span<double> left,
                        std::span<double> right) {
    CAROM_ASSERT(left.size() == source.size() && right.size() == source.size());
    if (lines_.empty()) {
        return;
    }
    for (std::size_t n = 0; n < source.size(); ++n) {
        if (source[n] == 0 && is_silent()) {
            continue;
        }
        std::array<double, kLines> values{};
        for (std::size_t i = 0; i < kLines; ++i) {
            Line& line = lines_[i];
            const double out = memory_[line.first + line.next];
            const double state = (1 - line.pole) * line.gain * out + line.pole * line.state;
            line.state = std::abs(state) < kDenormalThreshold ? 0 : state;
            values[i] = line.state;
        }
        double heard_left = 0;
        double heard_right = 0;
        for (unsigned i = 0; i < kLines; ++i) {
            heard_left += is_negative(kLeftRow, i) ? -values[i] : values[i];
            heard_right += is_negative(kRightRow, i) ? -values[i] : values[i];
        }
        left[n] += level_ / 4 * heard_left;
        right[n] += level_ / 4 * heard_right;
        mix(values);
        bool is_quiet = true;
        for (std::size_t i = 0; i < kLines; ++i) {
            Line& line = lines_[i];
            const double in = (values[i] + source[n]) / 4;
            const bool is_nothing = std::abs(in) < kDenormalThreshold;
            memory_[line.first + line.next] = is_nothing ? 0 : in;
            is_quiet = is_quiet && is_nothing;
            line.next = line.next + 1 == line.length ? 0 : line.next + 1;
        }
        quiet_for_ = is_quiet ? quiet_for_ + 1 : 0;
    }
}

}  // namespace carom::sound
