// Where all sounds of one shot come together: both ears, the room's first reflections and its
// reverberation.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sound/sound_scene.h"
#include "sound/space/head.h"
#include "sound/space/reverberation.h"

namespace carom::sound {

/// Samples that are mixed at a time, 5 ms. The mix does not depend on what a caller reads at a
/// time.
inline constexpr std::size_t kBlock = 240;

/// What is added to the bus. The samples are x[-1], x[0] ... of the current block, kBlock + 1 of
/// them, and what is heard is direct x[n] + previous x[n-1], `delay` samples later: the first half
/// of an ear's filter (head.h). The bus does the second, which is the same for all directions.
struct BusInput {
    enum class To { left, right, room };
    To to = To::left;
    bool is_reflected = false;  // passes through the walls' filter, too
    bool is_filtered = false;   // has an ear with a second half
    double direct = 1;
    double previous = 0;
    std::size_t delay = 0;  // samples; later than kLongestDelay is left out

    bool operator==(const BusInput&) const = default;
};

class ShotBus {
  public:
    /// Of a shot's room. `is_mono`: both channels get the same reverberation.
    ShotBus(const RoomSettings& room, bool is_mono);

    static constexpr std::size_t kLongestDelay = 24'000;  // samples, 170 m

    void add(const BusInput& input, std::span<const double> samples);

    /// Adds what is heard in the current block, of kBlock samples, and continues with the next one.
    void take(std::span<double> left, std::span<double> right);

    /// Whether nothing more comes if nothing more is added.
    [[nodiscard]] bool is_silent() const;

  private:
    static constexpr std::size_t kRing = kLongestDelay + 2 * kBlock;

    /// Sounds of one ear, with the filters that they share.
    struct Line {
        std::vector<double> ring;  // empty until something is added
        EarFilter walls, ear;
    };
    // The properties of a line are the bits of its index.
    static constexpr unsigned kRight = 1, kReflected = 2, kFiltered = 4;

    void take(unsigned index, std::span<double> channel);

    Ear second_half_;  // of an ear's filter
    Ear walls_;
    bool is_mono_;
    std::array<Line, 8> lines_;
    std::array<double, kBlock> room_{};
    Reverberation reverberation_;
    std::size_t at_ = 0;         // of the current block in the rings
    std::size_t quiet_for_ = 0;  // samples since something was added
};

}  // namespace carom::sound
