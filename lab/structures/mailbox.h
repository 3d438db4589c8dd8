// Mailboxing: remembers the last shapes that a ray was tested against if a shape may lie in several
// cells (Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray tracing", section 3; a
// small table per ray instead of a number per shape works for all threads: Benthin 2006, "Realtime
// ray tracing on current CPU architectures", section 4.3.4).
#pragma once

#include <array>
#include <cstdint>

namespace carom::render {

class Mailbox {
  public:
    Mailbox() { last_.fill(0xffffffffu); }

    /// Whether the shape is remembered; remembers it from now on.
    bool knows(std::uint32_t shape) {
        std::uint32_t& slot = last_[shape % last_.size()];
        const bool known = slot == shape;
        slot = shape;
        return known;
    }

  private:
    std::array<std::uint32_t, 64> last_;
};

}  // namespace carom::render
