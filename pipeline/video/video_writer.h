// Writes frames to a video file with libavcodec and libavformat.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "pipeline/video/sound_source.h"
#include "pipeline/video/video_format.h"

namespace carom::pipeline {

/// Encodes into a temporary file beside `path`; finish() renames it. If the writer is destroyed
/// before that, it leaves no file, and an existing file at `path` is unchanged. The same frames,
/// settings and library version give the same bytes. A writer may be used by one thread at a time;
/// several writers may work in parallel.
///
/// h264, hevc, av1, vp9: 4:2:0 in 8 or 10 bits; prores: profile 422 HQ; all of them BT.709 in
/// limited range, or BT.2020 with PQ for hdr10 (limited to its peak: peak_limit.h). ffv1: lossless
/// 16-bit RGB. In .mp4 and .mov moov comes before mdat, and HEVC is tagged hvc1. Frame n has the
/// time n / fps, exactly in .mp4 and .mov, rounded to milliseconds in .mkv and .webm.
///
/// The sound is in the codec of audio_codec_for(output, path). Its first sample is heard when the
/// first picture is shown, and it is as long as the pictures: first_sample() of their number
/// (sound_length.h). The writer reads it up to the pictures that it has written, so that memory
/// does not grow, and a source that ends before is followed by silence.
class VideoWriter {
  public:
    /// `metadata`: keys that containers know ("title", "artist", "date", "description" ...) are
    /// written as tags of these names, others are collected in "comment" as "key=value; key=value".
    /// `sound`: null for a film without sound; it is not used if `output` wants none, either.
    /// Throws Error with the text of the library or of check_video_format.
    VideoWriter(const std::string& path, const VideoFormat& format, const OutputSettings& output,
                const std::map<std::string, std::string>& metadata = {},
                std::unique_ptr<SoundSource> sound = nullptr);
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// Adds the next frame: 16-bit display values (sRGB-encoded, or for hdr10 PQ with BT.2020
    /// primaries), RGB, width * height * 3, row by row from the top left. Throws Error, and what
    /// the sound throws.
    void write(std::span<const std::uint16_t> rgb);

    /// Stores the poster, which file lists show as the film's preview: 8-bit sRGB-encoded RGB,
    /// stored as a JPEG in the film's file. Requires has_poster(). May be called once, before
    /// finish().
    void set_poster(std::span<const std::uint8_t> rgb);
    /// Whether the settings ask for a poster and the container supports it (.mp4).
    [[nodiscard]] bool has_poster() const;

    /// Flushes the encoders, writes the trailer and renames the file. Throws Error, also if no
    /// frame was written, and what the sound throws. The writer must not be used afterwards, even
    /// after an Error.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::pipeline
