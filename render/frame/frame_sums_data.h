// The content of FrameSums. Internal to this folder.
#pragma once

#include <cstddef>
#include <vector>

#include "render/film/film.h"
#include "render/frame/frame_sums.h"
#include "render/frame/tile_sums.h"

namespace carom::render {

struct FrameSums::Data {
    std::size_t pixels = 0;       // of the frame; 0 before it is begun
    std::vector<TileSums> tiles;  // of the frame; those without samples are empty
    bool has_plan = false;        // in all tiles, with adaptive sampling once it has first samples
    std::vector<float> seconds;   // CPU time that the first samples of each tile took
    RenderStatistics statistics;  // of all rays
};

}  // namespace carom::render
