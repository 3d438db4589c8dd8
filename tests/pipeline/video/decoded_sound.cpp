#include "tests/pipeline/video/decoded_sound.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include <cmath>
#include <memory>
#include <stdexcept>

namespace carom::testing {

namespace {

struct Deleter {
    void operator()(AVFormatContext* context) const { avformat_close_input(&context); }
    void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
};
template <class T>
using Ptr = std::unique_ptr<T, Deleter>;

void require(bool good, const char* what) {
    if (!good) {
        throw std::runtime_error(what);
    }
}

double sample(const AVFrame& frame, int channel, int at) {
    const void* first = frame.data[0];
    const void* own = frame.extended_data[channel];
    const int interleaved = at * frame.ch_layout.nb_channels + channel;
    switch (frame.format) {
        case AV_SAMPLE_FMT_FLTP:
            return static_cast<double>(static_cast<const float*>(own)[at]);
        case AV_SAMPLE_FMT_FLT:
            return static_cast<double>(static_cast<const float*>(first)[interleaved]);
        case AV_SAMPLE_FMT_S32:
            return static_cast<const std::int32_t*>(first)[interleaved] / 2147483648.0;
        case AV_SAMPLE_FMT_S16:
            return static_cast<const std::int16_t*>(first)[interleaved] / 32768.0;
        default:
            throw std::runtime_error("an unknown format of samples");
    }
}

Ptr<AVCodecContext> open_decoder(const AVStream& stream) {
    const AVCodec* codec = avcodec_find_decoder(stream.codecpar->codec_id);
    Ptr<AVCodecContext> decoder(avcodec_alloc_context3(codec));
    require(avcodec_parameters_to_context(decoder.get(), stream.codecpar) >= 0, "bad parameters");
    decoder->thread_count = 1;
    decoder->pkt_timebase = stream.time_base;
    require(avcodec_open2(decoder.get(), codec, nullptr) == 0, "cannot open the decoder");
    return decoder;
}

/// A stream that is decoded.
struct Stream {
    const AVStream* stream = nullptr;
    Ptr<AVCodecContext> decoder;
    bool is_sound = false;

    void receive(AVFrame& frame, DecodedSound& found) const {
        while (avcodec_receive_frame(decoder.get(), &frame) == 0) {
            const double time =
                static_cast<double>(frame.best_effort_timestamp) * av_q2d(stream->time_base);
            if (is_sound) {
                DecodedBlock block;
                block.time = time;
                const int right = frame.ch_layout.nb_channels > 1 ? 1 : 0;
                for (int i = 0; i < frame.nb_samples; ++i) {
                    block.left.push_back(sample(frame, 0, i));
                    block.right.push_back(sample(frame, right, i));
                }
                found.blocks.push_back(std::move(block));
            } else {
                found.picture_times.push_back(time);
            }
            av_frame_unref(&frame);
        }
    }
};

void describe(const AVStream& stream, DecodedSound& found) {
    const AVCodecParameters& parameters = *stream.codecpar;
    found.has_sound = true;
    found.codec = avcodec_get_name(parameters.codec_id);
    found.rate = parameters.sample_rate;
    found.channels = parameters.ch_layout.nb_channels;
    found.bits = parameters.bits_per_raw_sample;
    if (stream.duration != AV_NOPTS_VALUE) {
        found.sound_duration = static_cast<double>(stream.duration) * av_q2d(stream.time_base);
    }
}

}  // namespace

std::int64_t DecodedSound::samples() const {
    std::size_t count = 0;
    for (const DecodedBlock& block : blocks) {
        count += block.left.size();
    }
    return static_cast<std::int64_t>(count);
}

std::vector<double> DecodedSound::channel(bool is_right) const {
    std::vector<double> all;
    for (const DecodedBlock& block : blocks) {
        const std::vector<double>& own = is_right ? block.right : block.left;
        all.insert(all.end(), own.begin(), own.end());
    }
    return all;
}

double DecodedSound::click_near(double time) const {
    double energy = 0;
    double moment = 0;
    for (const DecodedBlock& block : blocks) {
        for (std::size_t i = 0; i < block.left.size(); ++i) {
            const double at = block.time + static_cast<double>(i) / rate;
            if (std::abs(at - time) < 5e-3) {
                const double own = block.left[i] * block.left[i] + block.right[i] * block.right[i];
                energy += own;
                moment += own * at;
            }
        }
    }
    return energy > 1e-3 ? moment / energy : -1;
}

DecodedSound decode_sound(const std::string& path) {
    AVFormatContext* opened = nullptr;
    require(avformat_open_input(&opened, ("file:" + path).c_str(), nullptr, nullptr) == 0,
            "cannot open the file");
    const Ptr<AVFormatContext> container(opened);
    require(avformat_find_stream_info(container.get(), nullptr) >= 0, "no stream information");
    DecodedSound found;
    found.duration = static_cast<double>(container->duration) / AV_TIME_BASE;
    std::vector<Stream> streams(container->nb_streams);
    for (unsigned i = 0; i < container->nb_streams; ++i) {
        const AVStream* stream = container->streams[i];
        if ((stream->disposition & AV_DISPOSITION_ATTACHED_PIC) != 0) {
            continue;
        }
        const bool is_sound = stream->codecpar->codec_type == AVMEDIA_TYPE_AUDIO;
        if (is_sound) {
            describe(*stream, found);
        }
        streams[i] = {stream, open_decoder(*stream), is_sound};
    }
    const Ptr<AVPacket> packet(av_packet_alloc());
    const Ptr<AVFrame> frame(av_frame_alloc());
    while (av_read_frame(container.get(), packet.get()) == 0) {
        const Stream& stream = streams[static_cast<std::size_t>(packet->stream_index)];
        if (stream.decoder != nullptr) {
            const std::int64_t time = packet->dts != AV_NOPTS_VALUE ? packet->dts : packet->pts;
            found.packets.push_back(
                {stream.is_sound, static_cast<double>(time) * av_q2d(stream.stream->time_base)});
            require(avcodec_send_packet(stream.decoder.get(), packet.get()) == 0, "cannot decode");
            stream.receive(*frame, found);
        }
        av_packet_unref(packet.get());
    }
    for (const Stream& stream : streams) {
        if (stream.decoder != nullptr) {
            avcodec_send_packet(stream.decoder.get(), nullptr);
            stream.receive(*frame, found);
        }
    }
    return found;
}

}  // namespace carom::testing
