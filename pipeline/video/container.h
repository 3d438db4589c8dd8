// Which containers there are, and what each of them may hold.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

struct Container {
    std::string_view extension;  // ".mp4"
    std::string_view muxer;      // libavformat's name of it
    bool holds_h264 = false;
    bool holds_ffv1 = false;

    [[nodiscard]] bool holds(Codec codec) const {
        return codec == Codec::h264 ? holds_h264 : holds_ffv1;
    }
};

[[nodiscard]] std::span<const Container> containers();

/// The container that the path's extension names (in any case), or nullptr.
[[nodiscard]] const Container* find_container(const std::string& path);

/// "h264: .mp4, .mov, .mkv; ffv1: .mkv"
[[nodiscard]] std::string list_containers();

}  // namespace carom::pipeline
