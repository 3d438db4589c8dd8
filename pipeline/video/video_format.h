// What a film's file is: size, rate and container, and whether its codec can take them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/camera/rational.h"
#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

/// The light of a whole film, cd/m^2, as HDR10 states it (CTA-861.3: MaxCLL and MaxFALL).
struct LightLevels {
    int brightest = 0;       // pixel
    int brightest_mean = 0;  // of a picture; 0: not known
};

struct VideoFormat {
    int width = 0;  // pixels; even where colour is subsampled (check_video_format says so)
    int height = 0;
    Rational fps{24};
    std::optional<LightLevels> light = {};  // for hdr10; if it is known
};

/// Empty, or a sentence that says what the codec cannot take and what to do about it. Needs no
/// encoder: a shot is checked with it long before its film is written. A path that is an image
/// sequence's (image_sequence.h) is checked as one.
[[nodiscard]] std::string check_video_format(const VideoFormat& format,
                                             const OutputSettings& output, const std::string& path);

/// A setting that the film's codec cannot take.
struct SettingProblem {
    std::vector<std::string> keys;  // of `output` that cannot stand together, or the one at fault
    std::string sentence;           // empty: all is well
};

/// The part of check_video_format that is about the settings alone, not about size, rate and path.
[[nodiscard]] SettingProblem find_setting_problem(const OutputSettings& output,
                                                  const std::string& path);

/// Empty, or what check_video_format says of the size alone. The path must be one that it accepts.
[[nodiscard]] std::string check_film_size(const VideoFormat& format, const OutputSettings& output,
                                          const std::string& path);

/// The extension that a film of these settings has unless told otherwise, with its dot: ".mp4".
[[nodiscard]] std::string default_extension(const OutputSettings& output);

}  // namespace carom::pipeline
