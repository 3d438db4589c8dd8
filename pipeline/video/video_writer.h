// libavcodec and libavformat behind one class: frames in, a whole file out.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "pipeline/video/video_format.h"

namespace carom::pipeline {

/// Encodes into a temporary file beside `path`; finish() renames it. Destroyed before that, it
/// leaves nothing behind, and a file that stood at `path` is still there. Same frames, settings and
/// library: the same bytes. For one thread at a time; several writers may work at once.
///
/// h264 (x264, profile High, yuv420p): BT.709, limited range; moov before mdat in .mp4 and .mov.
/// ffv1 (.mkv): the 16-bit RGB without loss. Frame n has the time n / fps, exactly in .mp4 and
/// .mov, rounded to Matroska's milliseconds in .mkv.
class VideoWriter {
  public:
    /// `metadata`: keys that containers know ("title", "artist", "date", "description" ...) are
    /// written under their own names, others gathered in "comment" as "key=value; key=value".
    /// Throws Error with the library's own text, or with check_video_format's.
    VideoWriter(const std::string& path, const VideoFormat& format, const OutputSettings& output,
                const std::map<std::string, std::string>& metadata = {});
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// The next frame: 16-bit sRGB-encoded RGB, width * height * 3, row by row from the top left.
    void write(std::span<const std::uint16_t> rgb);

    /// Flushes, writes the trailer and puts the file in its place. Throws Error, also if no frame
    /// was written. The writer is spent then, whatever happened.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::pipeline
