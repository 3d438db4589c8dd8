#include "pipeline/video/audio_encoder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/assert.h"
#include "core/error.h"
#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/sound_source.h"

namespace carom::pipeline {

namespace {

constexpr int kChannels = 2;

const AVCodec* find_encoder(AudioCodec codec, const std::string& path) {
    const std::string name(info(codec).encoder);
    const AVCodec* encoder = avcodec_find_encoder_by_name(name.c_str());
    if (encoder == nullptr) {
        throw Error("cannot write '" + path + "': this system's libavcodec has no encoder '" +
                    name + "'");
    }
    return encoder;
}

AVSampleFormat sample_format(AudioCodec codec) {
    switch (codec) {
        case AudioCodec::aac:
            return AV_SAMPLE_FMT_FLTP;
        case AudioCodec::opus:
            return AV_SAMPLE_FMT_FLT;
        case AudioCodec::flac:
        case AudioCodec::pcm:
        case AudioCodec::none:
            break;
    }
    return AV_SAMPLE_FMT_S32;
}

/// The upper 24 bits of 32, rounded to the nearest, halves to even. There is no dither, so that
/// silence is zero.
std::int32_t as_24_bits(double sample) {
    constexpr double kFullScale = 1 << 23;
    const double code =
        std::clamp(std::nearbyint(sample * kFullScale), -kFullScale, kFullScale - 1);
    return static_cast<std::int32_t>(code) * 256;
}

float as_float(double sample) {
    return static_cast<float>(std::clamp(sample, -1.0, 1.0));
}

/// Stores sample number `at` of one channel.
void store(AVFrame& frame, std::size_t at, int channel, double sample) {
    void* first = frame.data[0];
    void* own = frame.data[channel];  // of planar formats
    const std::size_t interleaved = at * kChannels + static_cast<std::size_t>(channel);
    switch (frame.format) {
        case AV_SAMPLE_FMT_FLTP:
            static_cast<float*>(own)[at] = as_float(sample);
            return;
        case AV_SAMPLE_FMT_FLT:
            static_cast<float*>(first)[interleaved] = as_float(sample);
            return;
        default:
            CAROM_ASSERT(frame.format == AV_SAMPLE_FMT_S32);
            static_cast<std::int32_t*>(first)[interleaved] = as_24_bits(sample);
    }
}

}  // namespace

AudioEncoder::AudioEncoder(AudioCodec codec, double bit_rate, bool global_header, std::string path,
                           Take take)
    : path_(std::move(path)), take_(std::move(take)) {
    const AVCodec* encoder = find_encoder(codec, path_);
    context_.reset(check_allocated(avcodec_alloc_context3(encoder), path_));
    context_->sample_fmt = sample_format(codec);
    context_->sample_rate = kSoundRate;
    context_->time_base = AVRational{1, kSoundRate};
    context_->bit_rate = std::llround(bit_rate);
    context_->thread_count = 1;
    context_->flags |= AV_CODEC_FLAG_BITEXACT;  // no version of libav in the stream
    context_->flags |= global_header ? AV_CODEC_FLAG_GLOBAL_HEADER : 0;
    if (context_->sample_fmt == AV_SAMPLE_FMT_S32) {
        context_->bits_per_raw_sample = 24;
    }
    av_channel_layout_default(&context_->ch_layout, kChannels);
    check_av(avcodec_open2(context_.get(), encoder, nullptr), "opening the encoder of the sound",
             path_);
    block_ =
        context_->frame_size > 0 ? static_cast<std::size_t>(context_->frame_size) : kSoundBlock;

    packet_.reset(check_allocated(av_packet_alloc(), path_));
    frame_.reset(check_allocated(av_frame_alloc(), path_));
    frame_->format = context_->sample_fmt;
    frame_->sample_rate = kSoundRate;
    frame_->nb_samples = static_cast<int>(block_);
    av_channel_layout_default(&frame_->ch_layout, kChannels);
    check_av(av_frame_get_buffer(frame_.get(), 0), "allocating a block of sound", path_);
}

void AudioEncoder::add(std::span<const double> left, std::span<const double> right) {
    CAROM_ASSERT(left.size() == right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (filled_ == 0) {
            // If the encoder still refers to the last block, this gives the frame a new buffer.
            frame_->nb_samples = static_cast<int>(block_);
            check_av(av_frame_make_writable(frame_.get()), "allocating a block of sound", path_);
        }
        store(*frame_, filled_, 0, left[i]);
        store(*frame_, filled_, 1, right[i]);
        if (++filled_ == block_) {
            encode();
        }
    }
}

void AudioEncoder::encode() {
    frame_->nb_samples = static_cast<int>(filled_);
    frame_->pts = encoded_;
    encoded_ += static_cast<std::int64_t>(std::exchange(filled_, 0));
    check_av(avcodec_send_frame(context_.get(), frame_.get()), "encoding the sound", path_);
    receive();
}

void AudioEncoder::receive() {
    for (;;) {
        const int code = avcodec_receive_packet(context_.get(), packet_.get());
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) {
            return;
        }
        check_av(code, "encoding the sound", path_);
        take_(*packet_);
        av_packet_unref(packet_.get());
    }
}

void AudioEncoder::finish() {
    if (filled_ > 0) {
        encode();
    }
    check_av(avcodec_send_frame(context_.get(), nullptr), "encoding the sound", path_);
    receive();
}

}  // namespace carom::pipeline
