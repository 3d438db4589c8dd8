// Channels of a frame as pictures for the page.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/film/film.h"

namespace carom::studio {

/// How a channel of the view is made.
struct ViewChannel {
    std::string aov;  // of the renderer (aov_planes.h)
    int samples = 0;  // that are enough for it; 0: as many as for the colours
};

/// Of "depth", "normal", "albedo", "roughness", "object_id", "material_id" or "noise". Throws Error
/// for others.
[[nodiscard]] ViewChannel view_channel(const std::string& name);

struct ChannelPicture {
    std::vector<std::uint8_t> rgba;  // 8 bits each, row by row from the top left
    std::string legend;              // a sentence on what the shades mean
};

/// `planes` are those of the channel's AOV; `colours` has the colours of the same samples. Depth is
/// bright where it is near, on a scale between the nearest and farthest hundredth of the pixels;
/// normals are 0.5 + 0.5 N in world axes; indices have colours of their own; noise is the standard
/// error of the mean luminance, divided by that luminance.
[[nodiscard]] ChannelPicture channel_picture(const std::string& name,
                                             const std::vector<render::Channel>& planes,
                                             const render::Film& colours);

}  // namespace carom::studio
