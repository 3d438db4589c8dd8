// x264's and x265's presets by name, and what other encoders have in their place.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace carom::pipeline {

struct EncoderPreset {
    std::string_view name;
    double av1 = 8;  // cpu-used of libaom
    double vp9 = 4;  // cpu-used of libvpx
};

inline constexpr std::array kEncoderPresets{
    EncoderPreset{"ultrafast", 8, 5}, EncoderPreset{"superfast", 8, 5},
    EncoderPreset{"veryfast", 8, 5},  EncoderPreset{"faster", 8, 5},
    EncoderPreset{"fast", 8, 5},      EncoderPreset{"medium", 8, 4},
    EncoderPreset{"slow", 6, 3},      EncoderPreset{"slower", 5, 2},
    EncoderPreset{"veryslow", 4, 1},  EncoderPreset{"placebo", 2, 0},
};

/// nullptr if there is none of that name.
constexpr const EncoderPreset* find_preset(std::string_view name) {
    const auto* const found =
        std::find_if(kEncoderPresets.begin(), kEncoderPresets.end(),
                     [name](const EncoderPreset& preset) { return preset.name == name; });
    return found == kEncoderPresets.end() ? nullptr : found;
}

/// Of a name that is known to be one.
constexpr const EncoderPreset& presets_of(std::string_view name) {
    return *find_preset(name);
}

}  // namespace carom::pipeline
