#include "pipeline/video/sound_stream.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace carom::pipeline {

namespace {

constexpr std::int64_t kMillisecond = kSoundRate / 1000;  // samples

bool wants_global_header(const AVFormatContext& container) {
    return (container.oformat->flags & AVFMT_GLOBALHEADER) != 0;
}

/// Opus gives 312 samples before the first one (RFC 7845, section 4.2), so that the encoder's first
/// packet has the time -312. Matroska states this number in the stream's header, and players
/// subtract it from the times of the packets (RFC 9559, section 5.1.4.1.28, CodecDelay). Therefore
/// it has to be added when they are written. libavformat does so only after version 59.30; before,
/// it moves all streams until no packet begins before zero. (Measured with 59.27: the first picture
/// is shown at 7 ms, and the sound is 6.5 ms early.)
std::int64_t shift_of(const AVFormatContext& container, const AVCodecContext& encoder) {
    const std::string_view muxer = container.oformat->name;
    constexpr unsigned kLastWithoutDelay = AV_VERSION_INT(59, 30, 100);
    const bool is_matroska = muxer == "matroska" || muxer == "webm";
    return is_matroska && encoder.codec_id == AV_CODEC_ID_OPUS &&
                   avformat_version() <= kLastWithoutDelay
               ? encoder.initial_padding
               : 0;
}

}  // namespace

SoundStream::SoundStream(AVFormatContext& container, AudioCodec codec, double bit_rate,
                         std::string path)
    : container_(container),
      path_(std::move(path)),
      encoder_(codec, bit_rate, wants_global_header(container), path_,
               [this](AVPacket& packet) { write(packet); }),
      stream_(check_allocated(avformat_new_stream(&container, nullptr), path_)),
      shift_(shift_of(container, encoder_.context())) {
    stream_->time_base = encoder_.context().time_base;
    check_av(avcodec_parameters_from_context(stream_->codecpar, &encoder_.context()),
             "describing the sound", path_);
}

void SoundStream::add_shift(AVPacket& packet) const {
    packet.pts += shift_;
    packet.duration -= shift_;
    if (is_ending_) {
        // The last packet may begin after the end, if only the codec's delay is in it, and the
        // container would state a film that is up to 6.5 ms too long. Matroska counts in
        // milliseconds, and libavformat replaces a duration of 0 by that of a whole block.
        packet.pts = std::max<std::int64_t>(std::min(packet.pts, samples_ - kMillisecond), 0);
        packet.duration = std::max(samples_ - packet.pts, kMillisecond);
    }
    packet.dts = packet.pts;
}

void SoundStream::write(AVPacket& packet) {
    if (shift_ > 0) {
        add_shift(packet);
    }
    packet.stream_index = stream_->index;
    av_packet_rescale_ts(&packet, encoder_.context().time_base, stream_->time_base);
    check_av(av_write_frame(&container_, &packet), "writing", path_);
}

void SoundStream::finish() {
    is_ending_ = true;
    encoder_.finish();
}

void write_sound(SoundSource& source, SoundStream& stream, std::int64_t samples) {
    std::array<double, kSoundBlock> left{};
    std::array<double, kSoundBlock> right{};
    while (stream.samples() < samples) {
        const auto wanted =
            std::min(static_cast<std::size_t>(samples - stream.samples()), kSoundBlock);
        std::size_t got =
            source.read(std::span(left).first(wanted), std::span(right).first(wanted));
        if (got == 0) {
            got = wanted;
            std::fill_n(left.begin(), got, 0.0);
            std::fill_n(right.begin(), got, 0.0);
        }
        stream.add(std::span(left).first(got), std::span(right).first(got));
    }
}

}  // namespace carom::pipeline
