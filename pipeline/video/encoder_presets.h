// The presets of x264 and x265 by name, and the corresponding settings of other encoders.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace carom::pipeline {

struct EncoderPreset {
    std::string_view name;
    double av1 = 8;          // cpu-used of libaom
    double vp9 = 4;          // cpu-used of libvpx
    double h264_memory = 0;  // of x264, bytes per pixel at 8 bits (docs/reliability.md)
    double hevc_memory = 0;  // the same of x265
};

inline constexpr std::array kEncoderPresets{
    EncoderPreset{"ultrafast", 8, 5, 10, 150}, EncoderPreset{"superfast", 8, 5, 50, 160},
    EncoderPreset{"veryfast", 8, 5, 75, 165},  EncoderPreset{"faster", 8, 5, 100, 170},
    EncoderPreset{"fast", 8, 5, 130, 180},     EncoderPreset{"medium", 8, 4, 170, 190},
    EncoderPreset{"slow", 6, 3, 200, 215},     EncoderPreset{"slower", 5, 2, 225, 250},
    EncoderPreset{"veryslow", 4, 1, 270, 280}, EncoderPreset{"placebo", 2, 0, 280, 290},
};

/// The preset of that name, or nullptr.
constexpr const EncoderPreset* find_preset(std::string_view name) {
    const auto* const found =
        std::find_if(kEncoderPresets.begin(), kEncoderPresets.end(),
                     [name](const EncoderPreset& preset) { return preset.name == name; });
    return found == kEncoderPresets.end() ? nullptr : found;
}

/// The preset of that name, which must exist.
constexpr const EncoderPreset& presets_of(std::string_view name) {
    return *find_preset(name);
}

}  // namespace carom::pipeline
