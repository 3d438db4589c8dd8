// What files say about how they were made.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/shot/shot.h"
#include "render/film/image_file.h"

namespace carom::pipeline {

/// Of a stored frame: only what belongs to its key, since many films may share it. With the
/// rays by kind, if there are any.
[[nodiscard]] render::ImageMetadata stored_frame_metadata(
    const Shot& shot, const render::RenderStatistics& counts = {});

/// Of a frame written for its own sake: with the shot, its number, camera and times, and the rays
/// that made `film`, now or when it was stored.
[[nodiscard]] render::ImageMetadata exported_frame_metadata(const Shot& shot,
                                                            const sim::Timeline& timeline,
                                                            std::int64_t frame,
                                                            const render::Film& film = {});

/// Of the same frame, for an OpenEXR file: the camera of `planned` and the film's frame rate.
[[nodiscard]] render::ExrStandardAttributes exr_standard_attributes(const Shot& shot,
                                                                    const PlannedFrame& planned);

/// Of a video: the shot's name and the settings that a viewer may ask about.
[[nodiscard]] std::map<std::string, std::string> video_metadata(const Shot& shot);

}  // namespace carom::pipeline
