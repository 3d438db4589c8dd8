// Encodes sound in two channels with libavcodec.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/video/av_library.h"
#include "pipeline/video/output_settings.h"

namespace carom::pipeline {

/// The same samples, settings and library version give the same bytes, in whichever blocks they
/// come. For one thread at a time.
class AudioEncoder {
  public:
    /// Called with each packet, whose times are in samples. A codec that has a delay gives the
    /// first packet a negative time.
    using Take = std::function<void(AVPacket& packet)>;

    /// `bit_rate` in bit/s, or 0 for codecs without one. `global_header`: the container stores the
    /// codec's parameters in its own header. Errors name `path`. Throws Error.
    AudioEncoder(AudioCodec codec, double bit_rate, bool global_header, std::string path,
                 Take take);

    [[nodiscard]] const AVCodecContext& context() const { return *context_; }

    /// Adds samples in units of full scale: lossless codecs round them to 24 bits. Both spans have
    /// the same size. Throws Error.
    void add(std::span<const double> left, std::span<const double> right);

    /// Gives all packets that remain. Nothing may be added afterwards. Throws Error.
    void finish();

  private:
    /// Passes the samples in frame_ to the encoder.
    void encode();
    void receive();

    std::string path_;
    Take take_;
    AvPtr<AVCodecContext> context_;
    AvPtr<AVFrame> frame_;
    AvPtr<AVPacket> packet_;
    std::size_t block_ = 0;     // samples that the encoder takes at once
    std::size_t filled_ = 0;    // samples in frame_
    std::int64_t encoded_ = 0;  // samples before them
};

}  // namespace carom::pipeline
