// Work on all tiles of a frame, in parallel. Internal to this folder.
#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

#include "core/error.h"
#include "core/progress.h"
#include "render/acceleration/flush_denormals.h"
#include "render/film/film.h"
#include "render/threads/thread_arena.h"

namespace carom::render {

/// Counts finished tiles and calls the caller's function, one call at a time.
class TileProgress {
  public:
    TileProgress(const ProgressCallback& callback, int tiles)
        : callback_(callback), tiles_(tiles) {}

    void finish_tile() {
        if (!callback_) {
            return;
        }
        const std::lock_guard<std::mutex> lock(mutex_);
        finished_ += 1;
        callback_(static_cast<double>(finished_) / tiles_);
    }

  private:
    const ProgressCallback& callback_;
    int tiles_;
    int finished_ = 0;
    std::mutex mutex_;
};

/// Calls `render_tile` for each of 0 to `tiles` - 1 in parallel, and `tile_done` for each one that
/// was not stopped. The counts, of a stopped tile too, are added to `total` in this order. Throws
/// Stopped.
template <class RenderTile, class TileDone>
void for_all_tiles(int tiles, const WorkContext& context, RenderStatistics& total,
                   const RenderTile& render_tile, const TileDone& tile_done) {
    std::vector<RenderStatistics> counts(static_cast<std::size_t>(tiles));
    parallel_for(counts.size(), [&](std::size_t tile) {
        if (context.stop.stop_requested()) {
            return;
        }
        const FlushDenormals flush;
        counts[tile] = render_tile(static_cast<int>(tile));
        if (!context.stop.stop_requested()) {
            tile_done(static_cast<int>(tile));
        }
    });
    for (const RenderStatistics& count : counts) {
        total += count;
    }
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
}

}  // namespace carom::render
