// One impact in the mix, from its first sample to its last.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sound/mix/auralisation.h"
#include "sound/mix/shot_bus.h"
#include "sound/source/mode_bank.h"

namespace carom::sound {

/// The same sound may be heard several times: by two ears, from walls. It is computed anew for each
/// time of arrival, so that each is exact to a fraction of a sample, except for the modes'
/// reflections, which are delayed by whole samples.
class Voice {
  public:
    /// `heard` in a room. It lasts until it has fallen 60 dB below its peak, and fades out then.
    Voice(const AuralisedImpact& heard, const RoomSettings& room);

    /// The samples of the film, [first(), last()), outside of which it adds nothing.
    [[nodiscard]] std::int64_t first() const { return first_; }
    [[nodiscard]] std::int64_t last() const { return last_; }

    /// Adds the block of samples that begins with `block` of the film.
    void add(std::int64_t block, ShotBus& bus) const;

  private:
    struct Wave {
        double onset = 0;  // s, scene time
        ModeBank bank;
    };
    using Waves = std::vector<Wave>;

    /// Waves that arrive together, and where they go.
    struct Playing {
        std::size_t waves = 0;  // index in waves_
        double arrival = 0;     // s, film time of scene time 0
        std::int64_t first = 0;
        std::int64_t last = 0;
        std::vector<BusInput> outputs;
    };

    [[nodiscard]] std::size_t add_spheres(const std::vector<SphereWave>& spheres, double factor);
    [[nodiscard]] std::size_t add_modes(const DirectSound& sound, double factor);
    void play(std::size_t waves, double arrival, std::vector<BusInput> outputs);
    void play_at_ears(std::size_t waves, double arrival, const Ears& ears, bool is_reflected);
    void play_in_room(const AuralisedImpact& heard, const RoomSettings& room, std::size_t modes,
                      double factor);

    double rate_;          // scene time over film time; negative if it is mirrored
    double contact_time_;  // s
    PulseShape shape_;     // of the force
    double least_;         // Pa, below which it is not heard
    std::vector<Waves> waves_;
    std::vector<Playing> playing_;
    std::int64_t first_ = 0;
    std::int64_t last_ = 0;
};

}  // namespace carom::sound
