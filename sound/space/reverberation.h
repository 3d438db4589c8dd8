// What a room adds after its first reflections: many that cannot be told apart.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sound/sound_scene.h"

namespace carom::sound {

/// A feedback delay network (Jot and Chaigne 1991, "Digital delay networks for designing artificial
/// reverberators", 90th Convention of the Audio Engineering Society): sixteen delay lines of prime
/// lengths from 21 to 53 ms, mixed by a Hadamard matrix, which keeps the energy, with one pole each
/// that makes all of them decay by 60 dB in the room's two times.
///
/// Its level follows from the room: a steady source of 1 Pa at 1 m has a reverberant pressure of
/// 1 / r_c in each channel, r_c = critical_distance(room). The channels are not correlated.
class Reverberation {
  public:
    /// For a room that is not a box, or whose time is below 20 ms, shorter than every line, this
    /// does nothing.
    explicit Reverberation(const RoomSettings& room);

    /// Adds the reverberation to both channels, which have the size of `source`: the sum of all
    /// sources as their pressures at 1 m, Pa, without delays. In order of time, in blocks of any
    /// size.
    void add(std::span<const double> source, std::span<double> left, std::span<double> right);

    /// Whether nothing would be added now if no source sounded any more.
    [[nodiscard]] bool is_silent() const { return quiet_for_ >= kLongest; }

  private:
    static constexpr std::size_t kLines = 16;
    static constexpr std::size_t kLongest = 2543;  // samples

    struct Line {
        std::size_t length = 0;  // samples
        std::size_t first = 0;   // of its samples in `memory_`
        std::size_t next = 0;    // of the sample that comes out next, below `length`
        double gain = 0;         // of a turn, at low frequencies
        double pole = 0;
        double state = 0;  // of the filter
    };

    std::vector<Line> lines_;
    std::vector<double> memory_;
    double level_ = 0;
    std::size_t quiet_for_ = kLongest;  // samples in which nothing has entered any line
};

}  // namespace carom::sound
