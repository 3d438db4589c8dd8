// What sounds as long as it moves in contact: balls that roll and slide over cloth, bodies that
// scrape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sound/rolling/passage_block.h"
#include "sound/sound_scene.h"

namespace carom::sound {

struct RollingPlan;

/// A source of lasting sound. Its pressure is a surface's texture (texture.h), read out along the
/// way of the contact: a function of scene time, which therefore plays at any speed, backwards and
/// from any instant. Where the picture stands still, so does the way, and the source is silent. As
/// for impacts, a picture at another speed changes the pitch and not the pressure. How loud it is
/// says rolling_level.h, with the passage's dynamics.
///
/// Balls on cloth: one read-out along the way of the centre, and one along that of the lowest point
/// over the cloth (the slip). Lasting contacts of the timeline: one read-out along their slip, with
/// cloth as the texture if one of both is cloth or a cushion. Contacts of balls with cloth or floor
/// are left out, because that is the former. Where a blow changes a ball's speed, its sound changes
/// over the contact (ball_way.h). A stretch of contact fades in and out within 5 ms of
/// the scene, but not within more than a quarter of its duration.
class RollingSource {
  public:
    explicit RollingSource(RollingPlan plan);
    ~RollingSource();
    RollingSource(RollingSource&&) noexcept;
    RollingSource& operator=(RollingSource&&) noexcept;
    RollingSource(const RollingSource&) = delete;
    RollingSource& operator=(const RollingSource&) = delete;

    /// The name of the body whose place the sound comes from.
    [[nodiscard]] const std::string& body() const;

    /// The track of that body, or nullptr if it does not move.
    [[nodiscard]] const sim::Track* track() const;

    /// Where the sound comes from: the body's place at a scene time.
    [[nodiscard]] Vec3 place(double scene_time) const;

    /// Whether it may sound at some time of the scene from the earlier to the later one, which may
    /// be given in any order.
    [[nodiscard]] bool sounds(double from, double to) const;

    /// Adds the pressure at 1 m, Pa, to `pressure`, which has the block's size: without delay, gain
    /// or direction. Blocks of a passage come in order of film time; their size does not change the
    /// bits. After a gap, and at the beginning of a passage (call begin()), it starts anew, which
    /// is the same unless the pitch differs from the picture's speed.
    void add(const PassageBlock& block, std::span<double> pressure);

    /// Forgets where the last block ended.
    void begin();

  private:
    class Implementation;

    std::unique_ptr<Implementation> implementation_;
};

/// All such sources of a shot: one for each ball that ever rolls or slides, in the order of the
/// bodies, and then one for each pair of bodies with lasting contacts, in order of their first. The
/// timeline must outlive them. Each one has the times of all its stretches in memory, and the way
/// of one.
[[nodiscard]] std::vector<RollingSource> rolling_sources(const SoundShot& shot);

}  // namespace carom::sound
