// Measures a few small blocks of a frame's pixels, from which the cost of the whole frame follows.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/progress.h"
#include "render/film/film.h"
#include "render/frame/frame.h"

namespace carom::render {

/// What the pixels cost that were measured so far. CPU time, of all threads.
struct ProbeCost {
    double seconds = 0;  // as if every sample of these pixels had been taken
    double pixels = 0;
    std::vector<double> per_pixel{};  // the same of each block, s
};

/// Renders blocks of a frame with all of their samples, exactly as render_frame does, in an order
/// that spreads them over the frame. With adaptive sampling all blocks measured so far stand for
/// the frame when samples are planned. For one thread at a time; work runs in the arena of the
/// caller.
class FrameProbe {
  public:
    static constexpr int kSmallestBlock = 16;  // pixels a side: one tile

    /// `block_size`: a multiple of the smallest. `scene` must outlive it; the other arguments need
    /// not. Throws as render_frame does.
    FrameProbe(const PreparedScene& scene, std::span<const sim::Track> tracks,
               const FrameInput& frame, const RenderSettings& settings, int block_size);
    ~FrameProbe();
    FrameProbe(FrameProbe&&) noexcept;
    FrameProbe& operator=(FrameProbe&&) noexcept;
    FrameProbe(const FrameProbe&) = delete;
    FrameProbe& operator=(const FrameProbe&) = delete;

    /// Renders the next `count` blocks, or all that are left if these are fewer, and returns their
    /// pictures with the channels of the settings. A block beyond the frame's edge is filled with
    /// the pixels at the edge. If a stop is requested, it returns nothing soon, and what was
    /// rendered by then counts as a part of these blocks' cost.
    [[nodiscard]] std::vector<Film> render_blocks(int count, const WorkContext& context);

    [[nodiscard]] int blocks_left() const;
    [[nodiscard]] const ProbeCost& cost() const;

    /// CPU time of the whole frame: the preparation, all pixels, and the images of lights, of which
    /// a few are measured. Needs at least one pixel of cost().
    [[nodiscard]] double frame_seconds() const;
    /// The part of it that does not depend on the number of pixels.
    [[nodiscard]] double preparation_seconds() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace carom::render
