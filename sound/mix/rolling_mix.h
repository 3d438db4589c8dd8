// What rolls, slides and scrapes in one shot, as one of its clips hears it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sound/mix/shot_bus.h"
#include "sound/rolling/rolling_source.h"
#include "sound/sound_scene.h"
#include "sound/space/head.h"

namespace carom::sound {

/// Distance and direction are those at the edges of each block, and straight lines between them.
/// The dynamics are those of the sources, wherever they are heard from. Where one clip follows
/// another, both cross over within 5 ms. Rolling has no single reflections: it is noise, to which
/// they add nothing that the reverberation does not.
class RollingMix {
  public:
    /// Both must outlive it and not change.
    RollingMix(const Clip& clip, const std::vector<RollingSource>& sources);

    /// Whether the clip is heard before, or after, a film time (s).
    [[nodiscard]] static bool begins_before(const Clip& clip, double film_time);
    [[nodiscard]] bool is_heard_after(double film_time) const;

    /// Makes the block of kBlock samples that begins with `block` of the film, in order of time.
    /// Returns whether anything is heard in it.
    [[nodiscard]] bool make_block(std::int64_t block);

    /// Adds the block that was made.
    void add_to(ShotBus& bus) const;

  private:
    using BlockSamples = std::array<double, kBlock + 1>;  // the first is before the block

    /// A source at the edge of a block.
    struct Edge {
        struct Path {
            Ear ear;
            double delay = 0;  // samples
            double gain = 0;   // of the pressure at 1 m
        };
        double gain = 0;  // of the same, without distance
        Path left, right;
    };
    struct Source {
        explicit Source(const RollingSource& source);

        RollingVoice voice;
        std::vector<double> history;  // the pressure at 1 m, a ring by the film's sample
        std::optional<Edge> edge;     // at the beginning of the next block
        std::size_t silent_for;       // samples
    };

    void play(std::int64_t block);
    [[nodiscard]] Edge edge_at(const Source& source, std::int64_t sample) const;
    static void add_path(std::span<const double> history, std::int64_t block, Edge::Path begin,
                         Edge::Path end, std::span<double> samples);
    void mix(Source& source, std::int64_t block);

    const Clip* clip_;
    std::vector<Source> sources_;
    bool is_begun_ = false;
    BlockSamples left_{}, right_{}, room_{};
};

}  // namespace carom::sound
