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
/// h264, hevc, av1, vp9: 4:2:0 in 8 or 10 bits; prores: profile 422 HQ; all of them BT.709 in
/// limited range, or BT.2020 with PQ for hdr10 (nothing beyond its peak: peak_limit.h). ffv1: the
/// 16-bit RGB without loss. In .mp4 and .mov moov comes before mdat, and HEVC is tagged hvc1. Frame
/// n has the time n / fps, exactly in .mp4 and .mov, rounded to Matroska's milliseconds in .mkv and
/// .webm.
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

    /// The next frame: 16-bit RGB as a display takes it (sRGB-encoded, or for hdr10 PQ on BT.2020),
    /// width * height * 3, row by row from the top left.
    void write(std::span<const std::uint16_t> rgb);

    /// The picture that stands for the film where files are listed: 8-bit sRGB-encoded RGB, kept as
    /// a JPEG in the film's own file. At most once, any time before finish(), if has_poster().
    void set_poster(std::span<const std::uint8_t> rgb);
    /// Whether the settings ask for a poster and the container has a place for it (.mp4).
    [[nodiscard]] bool has_poster() const;

    /// Flushes, writes the trailer and puts the file in its place. Throws Error, also if no frame
    /// was written. The writer is spent then, whatever happened.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::pipeline
