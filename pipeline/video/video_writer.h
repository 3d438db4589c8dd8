// libavcodec and libavformat behind one class: frames in, a whole file out.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "pipeline/camera/rational.h"
#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

struct VideoFormat {
    int width = 0;  // pixels; even for h264 (check_video_format says so)
    int height = 0;
    Rational fps{24};
};

/// Empty, or a sentence that says what the codec cannot take and what to do about it.
[[nodiscard]] std::string check_video_format(const VideoFormat& format,
                                             const OutputSettings& output, const std::string& path);

/// Encodes into a temporary file beside `path`; finish() renames it. Destroyed before that, it
/// leaves nothing behind. Same frames, settings and library: the same bytes.
class VideoWriter {
  public:
    /// Throws Error with the library's own text.
    VideoWriter(const std::string& path, const VideoFormat& format, const OutputSettings& output,
                const std::map<std::string, std::string>& metadata = {});
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// The next frame: 16-bit sRGB-encoded RGB, width * height * 3, row by row from the top left.
    void write(std::span<const std::uint16_t> rgb);

    /// Flushes, writes the trailer and puts the file in its place.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::pipeline
