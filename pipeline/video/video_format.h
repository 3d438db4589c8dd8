// Size, rate and container of a film's file, and checks whether its codec supports them.
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
    int brightest_mean = 0;  // mean of one picture; 0: not known
};

struct VideoFormat {
    int width = 0;  // pixels; even if colour is subsampled (check_video_format)
    int height = 0;
    Rational fps{24};
    std::optional<LightLevels> light = {};  // for hdr10, if known
};

/// Empty, or a sentence that says what the codec does not support and what to do about it. It needs
/// no encoder: a shot is checked long before its film is written. The path of an image sequence
/// (image_sequence.h) is checked as such.
[[nodiscard]] std::string check_video_format(const VideoFormat& format,
                                             const OutputSettings& output, const std::string& path);

/// A setting that the film's codec does not support.
struct SettingProblem {
    std::vector<std::string> keys;  // of `output` that exclude each other, or the wrong one
    std::string sentence;           // empty: no problem
};

/// The part of check_video_format that concerns only the settings, not size, rate and path.
[[nodiscard]] SettingProblem find_setting_problem(const OutputSettings& output,
                                                  const std::string& path);

/// Empty, or the sentence of check_video_format about the size. The path must be valid.
[[nodiscard]] std::string check_film_size(const VideoFormat& format, const OutputSettings& output,
                                          const std::string& path);

/// The default extension of a film with these settings, with its dot: ".mp4". It is the codec's own
/// unless the film's sound needs another one.
[[nodiscard]] std::string default_extension(const OutputSettings& output);

}  // namespace carom::pipeline
