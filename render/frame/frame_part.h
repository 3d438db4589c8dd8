// Some pixels of a frame. Internal to this folder.
#pragma once

#include <functional>
#include <utility>
#include <vector>

namespace carom::render {

/// A picture of pixels that stand for the frame.
struct FramePart {
    std::vector<int> tiles;  // that are sampled
    int width = 0;
    int height = 0;
    std::function<std::pair<int, int>(int x, int y)> pixel;  // of the frame, in these tiles
};

}  // namespace carom::render
