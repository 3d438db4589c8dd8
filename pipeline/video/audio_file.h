// Writes sound to a file of its own with libavcodec and libavformat.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace carom::pipeline {

/// Empty, or a sentence that says that AudioFileWriter does not write files with the path's
/// extension, and which it does.
[[nodiscard]] std::string check_audio_path(const std::string& path);

/// Encodes two channels at kSoundRate (sound_source.h) into a temporary file beside `path`;
/// finish() renames it. If the writer is destroyed before that, it leaves no file, and an existing
/// file at `path` is unchanged. The same samples and library version give the same bytes, in
/// whichever blocks they come. The extension decides the codec: .flac and .mka are lossless, with
/// 24 bits a sample; .m4a is AAC, .opus is Opus. For one thread at a time.
class AudioFileWriter {
  public:
    /// `bit_rate` in bit/s, from 32 to 512 kbit/s; empty: the codec's own (audio_codec_info.h).
    /// Lossless codecs ignore it. `metadata`: tags such as "title". Throws Error with the text of
    /// the library or of check_audio_path.
    explicit AudioFileWriter(const std::string& path, std::optional<double> bit_rate = {},
                             const std::map<std::string, std::string>& metadata = {});
    ~AudioFileWriter();
    AudioFileWriter(const AudioFileWriter&) = delete;
    AudioFileWriter& operator=(const AudioFileWriter&) = delete;

    /// Adds samples in units of full scale; what exceeds [-1, 1] is cut off. Both spans have the
    /// same size. Throws Error.
    void write(std::span<const double> left, std::span<const double> right);

    /// Flushes the encoder, writes the trailer and renames the file. Throws Error, also if no
    /// sample was written. The writer must not be used afterwards, even after an Error.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::pipeline
