#include "pipeline/video/sound_decoder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

extern "C" {
#include <libswresample/swresample.h>
}

#include "core/error.h"
#include "pipeline/video/av_library.h"

namespace carom::pipeline {

namespace {

constexpr int kChannels = 2;
constexpr double kFullScale = 2147483648.0;  // of 32-bit samples

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error("cannot read the sound of '" + path + "': " + why);
}

void require(int code, const std::string& path) {
    if (code < 0) {
        refuse(path, av_error_text(code));
    }
}

struct InputDeleter {
    void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
    void operator()(SwrContext* context) const { swr_free(&context); }
};

template <class T>
double plain_sample(const void* data, std::size_t at, double zero, double scale) {
    return (static_cast<double>(static_cast<const T*>(data)[at]) - zero) / scale;
}

/// Sample number `at` of a channel, in units of full scale.
double sample_of(const AVFrame& frame, int channel, int at) {
    const auto format = static_cast<AVSampleFormat>(frame.format);
    const bool is_planar = av_sample_fmt_is_planar(format) != 0;
    const void* data = frame.extended_data[is_planar ? channel : 0];
    const auto index =
        static_cast<std::size_t>(is_planar ? at : at * frame.ch_layout.nb_channels + channel);
    switch (av_get_packed_sample_fmt(format)) {
        case AV_SAMPLE_FMT_U8:
            return plain_sample<std::uint8_t>(data, index, 128, 128);
        case AV_SAMPLE_FMT_S16:
            return plain_sample<std::int16_t>(data, index, 0, 32768);
        case AV_SAMPLE_FMT_S32:
            return plain_sample<std::int32_t>(data, index, 0, kFullScale);
        case AV_SAMPLE_FMT_S64:
            return plain_sample<std::int64_t>(data, index, 0, kFullScale * kFullScale * 2);
        case AV_SAMPLE_FMT_FLT:
            return plain_sample<float>(data, index, 0, 1);
        case AV_SAMPLE_FMT_DBL:
            return plain_sample<double>(data, index, 0, 1);
        default:
            return 0;
    }
}

/// Damaged files may give samples that are not numbers.
std::int32_t as_32_bits(double sample) {
    const double code = std::nearbyint(sample * kFullScale);
    return std::isfinite(code)
               ? static_cast<std::int32_t>(std::clamp(code, -kFullScale, kFullScale - 1))
               : 0;
}

}  // namespace

struct SoundDecoder::State {
    explicit State(std::string file);
    ~State() { av_channel_layout_uninit(&converted_layout); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void open_decoder();
    /// Decodes until `ready` has samples. False at the end.
    [[nodiscard]] bool fill();
    void take_frame();
    /// Passes samples to the converter, or, at the end, takes out what it still has.
    void convert(const std::vector<std::int32_t>& interleaved, int channels, bool is_end);
    void make_converter(const AVChannelLayout& layout, int rate);
    void append(const std::vector<std::int32_t>& interleaved);

    std::string path;
    std::unique_ptr<AVFormatContext, InputDeleter> input;
    AvPtr<AVCodecContext> decoder;
    AvPtr<AVPacket> packet;
    AvPtr<AVFrame> frame;
    std::unique_ptr<SwrContext, InputDeleter> converter;  // null: nothing has to be converted
    AVChannelLayout converted_layout{};                   // what it converts
    int converted_rate = 0;
    int stream = -1;
    bool is_at_end = false;
    std::vector<std::int32_t> ready;  // interleaved
    std::size_t taken = 0;            // of them
};

SoundDecoder::State::State(std::string file) : path(std::move(file)) {
    AVFormatContext* opened = nullptr;
    // Without "file:", libavformat would read "a:b.flac" as protocol "a".
    require(avformat_open_input(&opened, ("file:" + path).c_str(), nullptr, nullptr), path);
    input.reset(opened);
    require(avformat_find_stream_info(input.get(), nullptr), path);
    open_decoder();
    packet.reset(av_packet_alloc());
    frame.reset(av_frame_alloc());
    if (packet == nullptr || frame == nullptr) {
        refuse(path, "no memory");
    }
}

void SoundDecoder::State::open_decoder() {
    const AVCodec* codec = nullptr;
    stream = av_find_best_stream(input.get(), AVMEDIA_TYPE_AUDIO, -1, -1, &codec, 0);
    if (stream < 0 || codec == nullptr) {
        refuse(path, "the file has none that this system's libavcodec can decode");
    }
    for (unsigned i = 0; i < input->nb_streams; ++i) {
        if (static_cast<int>(i) != stream) {
            input->streams[i]->discard = AVDISCARD_ALL;
        }
    }
    decoder.reset(avcodec_alloc_context3(codec));
    if (decoder == nullptr) {
        refuse(path, "no memory");
    }
    require(avcodec_parameters_to_context(decoder.get(), input->streams[stream]->codecpar), path);
    decoder->thread_count = 1;
    decoder->pkt_timebase = input->streams[stream]->time_base;
    require(avcodec_open2(decoder.get(), codec, nullptr), path);
}

void SoundDecoder::State::make_converter(const AVChannelLayout& layout, int rate) {
    AVChannelLayout stereo{};
    av_channel_layout_default(&stereo, kChannels);
    require(av_channel_layout_copy(&converted_layout, &layout), path);
    converted_rate = rate;
    SwrContext* made = nullptr;
    require(swr_alloc_set_opts2(&made, &stereo, AV_SAMPLE_FMT_S32, kSoundRate, &converted_layout,
                                AV_SAMPLE_FMT_S32, rate, 0, nullptr),
            path);
    converter.reset(made);
    // With 32-bit integers libswresample uses no vector code of the processor.
    require(av_opt_set_sample_fmt(made, "internal_sample_fmt", AV_SAMPLE_FMT_S32P, 0), path);
    require(swr_init(made), path);
}

void SoundDecoder::State::append(const std::vector<std::int32_t>& interleaved) {
    ready.insert(ready.end(), interleaved.begin(), interleaved.end());
}

void SoundDecoder::State::convert(const std::vector<std::int32_t>& interleaved, int channels,
                                  bool is_end) {
    const int count = is_end ? 0 : static_cast<int>(interleaved.size()) / channels;
    const int most = swr_get_out_samples(converter.get(), count);
    require(most, path);
    std::vector<std::int32_t> converted(static_cast<std::size_t>(most) * kChannels);
    void* out = converted.data();
    const void* in = interleaved.data();
    auto* out_bytes = static_cast<std::uint8_t*>(out);
    const auto* in_bytes = static_cast<const std::uint8_t*>(in);
    const int got =
        swr_convert(converter.get(), &out_bytes, most, is_end ? nullptr : &in_bytes, count);
    require(got, path);
    converted.resize(static_cast<std::size_t>(got) * kChannels);
    append(converted);
}

void SoundDecoder::State::take_frame() {
    const int channels = frame->ch_layout.nb_channels;
    const int rate = frame->sample_rate;
    const bool is_plain = rate == kSoundRate && channels <= kChannels;
    const int stored = channels == 1 ? kChannels : channels;  // one channel is heard on both sides
    std::vector<std::int32_t> interleaved;
    interleaved.reserve(static_cast<std::size_t>(frame->nb_samples) *
                        static_cast<std::size_t>(stored));
    for (int i = 0; i < frame->nb_samples; ++i) {
        for (int channel = 0; channel < stored; ++channel) {
            interleaved.push_back(
                as_32_bits(sample_of(*frame, std::min(channel, channels - 1), i)));
        }
    }
    AVChannelLayout layout{};
    if (channels == 1 || frame->ch_layout.order == AV_CHANNEL_ORDER_UNSPEC) {
        av_channel_layout_default(&layout, stored);  // the usual one of so many channels
    } else {
        require(av_channel_layout_copy(&layout, &frame->ch_layout), path);
    }
    if (is_plain && converter == nullptr) {
        append(interleaved);
    } else {
        if (converter == nullptr || converted_rate != rate ||
            av_channel_layout_compare(&converted_layout, &layout) != 0) {
            if (converter != nullptr) {
                convert({}, stored, true);
            }
            make_converter(layout, rate);
        }
        convert(interleaved, stored, false);
    }
    av_channel_layout_uninit(&layout);
}

bool SoundDecoder::State::fill() {
    ready.clear();
    taken = 0;
    while (ready.empty() && !is_at_end) {
        const int code = avcodec_receive_frame(decoder.get(), frame.get());
        if (code == 0) {
            take_frame();
            av_frame_unref(frame.get());
        } else if (code == AVERROR_EOF) {
            is_at_end = true;
            if (converter != nullptr) {
                convert({}, kChannels, true);
            }
        } else if (code == AVERROR(EAGAIN)) {
            const int read = av_read_frame(input.get(), packet.get());
            if (read == AVERROR_EOF) {
                require(avcodec_send_packet(decoder.get(), nullptr), path);
                continue;
            }
            require(read, path);
            const int sent = packet->stream_index == stream
                                 ? avcodec_send_packet(decoder.get(), packet.get())
                                 : 0;
            av_packet_unref(packet.get());
            require(sent, path);
        } else {
            require(code, path);
        }
    }
    return !ready.empty();
}

SoundDecoder::SoundDecoder(const std::string& path) {
    capture_av_log();
    state_ = std::make_unique<State>(path);
}

SoundDecoder::~SoundDecoder() = default;

std::size_t SoundDecoder::read(std::span<double> left, std::span<double> right) {
    State& state = *state_;
    if (state.taken == state.ready.size() && !state.fill()) {
        return 0;
    }
    const std::size_t count = std::min(left.size(), (state.ready.size() - state.taken) / kChannels);
    for (std::size_t i = 0; i < count; ++i) {
        left[i] = state.ready[state.taken++] / kFullScale;
        right[i] = state.ready[state.taken++] / kFullScale;
    }
    return count;
}

}  // namespace carom::pipeline
