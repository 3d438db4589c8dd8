// What sounds as long as it moves in contact: balls that roll and slide over cloth, bodies that
// scrape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "core/vectors.h"
#include "sim/timeline/timeline.h"
#include "sound/rolling/clip_block.h"
#include "sound/rolling/distance_curve.h"
#include "sound/rolling/texture_oscillator.h"
#include "sound/sound_scene.h"

namespace carom::sound {

/// An interval of scene time (s, from < to) of lasting contact.
struct Interval {
    double from = 0;
    double to = 0;

    bool operator==(const Interval&) const = default;
};

/// For each body, when it rolls or slides as a ball, in order of time and without overlaps: from
/// when the log has it sliding or rolling until it has it resting, spinning in place, airborne,
/// potted, off the table, taken away or put somewhere, or until the timeline ends. A ball that has
/// moved horizontally, and not vertically, before its first state in the log has been on the cloth
/// from the beginning. Bodies that are not balls, or have no track, have none.
[[nodiscard]] std::vector<std::vector<Interval>> rolling_intervals(
    const sim::Timeline& timeline, std::span<const SoundBody> bodies);

/// A ball on cloth.
struct RollingBall {
    double radius = 0;                  // m
    std::vector<ContactTime> contacts;  // with other things, in order of time
};

/// A source of lasting sound. Its pressure is a surface's texture (texture_oscillator.h), read out
/// along the distance travelled in contact: a function of scene time, which therefore plays at any
/// speed, backwards and from any instant. Where the picture stands still, so does the distance, and
/// the source is silent. As for impacts, a picture at another speed changes the pitch and not the
/// pressure. How loud it is says distance_curve.h, with the dynamics of the clip.
///
/// Balls on cloth: one oscillator along the distance of the centre, and one along that of the
/// lowest point over the cloth (the slip). Lasting contacts of the timeline: one oscillator along
/// their slip, with cloth as the texture if one of both is cloth or a cushion. Contacts of balls
/// with cloth or floor are left out, because that is the former. Where a blow changes a ball's
/// speed, its sound changes over the contact.
struct RollingSource {
    const sim::Track* track = nullptr;  // of the body; nullptr if it does not move
    Vec3 position{0, 0, 0};             // m, of a body without a track
    Texture texture;
    std::uint64_t seed = 0;
    std::vector<Interval> intervals{};  // in order of time, without overlaps
    std::variant<RollingBall, std::vector<Scrape>> motion{};

    /// Where the sound comes from: the body's place at a scene time.
    [[nodiscard]] Vec3 place(double scene_time) const;

    /// The first interval that ends after this time, or the end of the list.
    [[nodiscard]] std::vector<Interval>::const_iterator first_ending_after(double time) const;

    /// Whether it may sound at some time of the scene from the earlier to the later one, which may
    /// be given in any order.
    [[nodiscard]] bool sounds(double from, double to) const;

    /// The distances travelled in one of the intervals; for scrapes they are the second curve.
    [[nodiscard]] BallCurves curves(const Interval& interval) const;
};

/// All such sources of a shot: one for each ball that ever rolls or slides, in the order of the
/// bodies, and then one for each pair of bodies with lasting contacts, in order of their first. The
/// timeline must outlive them.
[[nodiscard]] std::vector<RollingSource> rolling_sources(const SoundShot& shot);

/// Plays one source in one clip. An interval of contact fades in and out within 5 ms of the
/// scene, but not within more than a quarter of its duration.
class RollingVoice {
  public:
    /// `source` must outlive it.
    explicit RollingVoice(const RollingSource& source);

    [[nodiscard]] const RollingSource& source() const { return *source_; }

    /// Adds the pressure at 1 m, Pa, to `pressure`, which has the block's size: without delay, gain
    /// or direction. Blocks come in order of film time; their size does not change the bits. After
    /// a gap it starts anew, which is the same unless the pitch differs from the picture's speed.
    void add(const ClipBlock& block, std::span<double> pressure);

  private:
    static constexpr auto kNone = static_cast<std::size_t>(-1);

    const Interval* interval_at(double time, double dynamics);

    const RollingSource* source_;
    TextureOscillator rolled_, slid_;
    std::size_t present_ = kNone;  // the interval whose curves the oscillators have
    std::int64_t next_sample_ = 0;
};

}  // namespace carom::sound
