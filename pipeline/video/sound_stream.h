// The sound of a container that libavformat writes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "pipeline/video/audio_encoder.h"
#include "pipeline/video/output_settings.h"
#include "pipeline/video/sound_source.h"

namespace carom::pipeline {

/// Adds a stream to a container, and writes as much sound into it as the caller asks for, so that
/// neither of them collects packets. What a codec adds before the first sample is described such
/// that the first sample is heard at time 0: by an edit list in .mp4, .m4a and .mov, and by the
/// codec's own delay in .mkv, .webm and .opus. For one thread at a time.
class SoundStream {
  public:
    /// To be called before the container's header is written. Refers to `container`. `codec` must
    /// not be AudioCodec::none; `bit_rate` as in AudioEncoder. Errors name `path`. Throws Error.
    SoundStream(AVFormatContext& container, AudioCodec codec, double bit_rate, std::string path);
    ~SoundStream() = default;
    SoundStream(const SoundStream&) = delete;
    SoundStream& operator=(const SoundStream&) = delete;

    /// Adds samples (AudioEncoder::add) and writes the packets that become complete. Throws Error.
    void add(std::span<const double> left, std::span<const double> right) {
        encoder_.add(left, right);
        samples_ += static_cast<std::int64_t>(left.size());
    }

    /// How many samples were added.
    [[nodiscard]] std::int64_t samples() const { return samples_; }

    /// Writes what the encoder still has, to be called before the trailer is written. Throws Error.
    void finish();

  private:
    void write(AVPacket& packet);
    void add_shift(AVPacket& packet) const;

    AVFormatContext& container_;
    std::string path_;
    AudioEncoder encoder_;
    AVStream* stream_ = nullptr;  // owned by the container
    std::int64_t shift_ = 0;      // samples that are added to the times of all packets
    std::int64_t samples_ = 0;
    bool is_ending_ = false;
};

/// Reads from the source and adds to the stream until the stream has `samples` samples. Where the
/// source ends before, silence follows. Throws Error, Stopped.
void write_sound(SoundSource& source, SoundStream& stream, std::int64_t samples);

}  // namespace carom::pipeline
