// The metadata of written files.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/shot/shot.h"
#include "render/film/image_file.h"

namespace carom::pipeline {

/// The metadata of a stored frame: only what belongs to its key, since many films may share it,
/// with the rays by kind, if there are any.
[[nodiscard]] render::ImageMetadata stored_frame_metadata(
    const Shot& shot, const render::RenderStatistics& counts = {});

/// The metadata of an exported frame: with the shot, its number, camera and times, and the rays of
/// `film`, counted now or when it was stored.
[[nodiscard]] render::ImageMetadata exported_frame_metadata(const Shot& shot,
                                                            const sim::Timeline& timeline,
                                                            std::int64_t frame,
                                                            const render::Film& film = {});

/// The standard attributes of the same frame in an OpenEXR file: the camera of `planned` and the
/// film's frame rate.
[[nodiscard]] render::ExrStandardAttributes exr_standard_attributes(const Shot& shot,
                                                                    const PlannedFrame& planned);

/// The metadata of a video: the shot's name and the render settings.
[[nodiscard]] std::map<std::string, std::string> video_metadata(const Shot& shot);

}  // namespace carom::pipeline
