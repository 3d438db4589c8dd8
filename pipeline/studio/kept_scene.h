// The prepared scene of the picture, while only balls and cameras move.
#pragma once

#include <cstdint>
#include <memory>

#include "core/hash.h"
#include "pipeline/shot/shot.h"
#include "render/frame/progressive_frame.h"

namespace carom::studio {

/// For one thread.
class KeptScene {
  public:
    /// The scene of a shot, which is prepared if it is not the last one. `scene_hash`: hash_scene()
    /// of the shot. Throws Error.
    [[nodiscard]] std::shared_ptr<const render::PreparedScene> of(const pipeline::Shot& shot,
                                                                  const Hash128& scene_hash);

    /// How many were prepared.
    [[nodiscard]] std::uint64_t count() const { return count_; }

  private:
    std::shared_ptr<const render::PreparedScene> scene_;
    Hash128 key_{};
    std::uint64_t count_ = 0;
};

}  // namespace carom::studio
