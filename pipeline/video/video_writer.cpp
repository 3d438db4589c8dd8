#include "pipeline/video/video_writer.h"

#include <cmath>
#include <optional>
#include <string_view>

extern "C" {
#include <libavutil/mastering_display_metadata.h>
}

#include "core/assert.h"
#include "core/error.h"
#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/container.h"
#include "pipeline/video/encoder.h"
#include "pipeline/video/encoder_options.h"
#include "pipeline/video/hdr_view.h"
#include "pipeline/video/output_container.h"
#include "pipeline/video/peak_limit.h"
#include "pipeline/video/pending_file.h"
#include "pipeline/video/poster.h"
#include "pipeline/video/sound_length.h"
#include "pipeline/video/sound_stream.h"

namespace carom::pipeline {

// Members are destroyed from the last to the first: the container closes its file before the
// pending file removes it.
struct VideoWriter::State {
    State(const std::string& path, const VideoFormat& video_format, const OutputSettings& output,
          const std::map<std::string, std::string>& metadata, std::unique_ptr<SoundSource> source);

    void describe_stream();
    void add_sound(const OutputSettings& output, std::unique_ptr<SoundSource> source);
    /// Writes the sound that belongs before a picture which is decoded at that time, in frames.
    void write_sound_before(std::int64_t picture);
    /// Sends a picture (or nullptr at the end) to the encoder and writes all packets that it
    /// returns.
    void encode(const AVFrame* picture);
    void close();

    [[nodiscard]] const std::string& path() const { return file.target(); }

    VideoFormat format;
    PendingFile file;
    AvPtr<AVFormatContext> container;
    AvPtr<AVCodecContext> encoder;
    AvPtr<AVFrame> frame;
    AvPtr<AVPacket> packet;
    AVStream* stream = nullptr;  // owned by the container, like the next one
    AVStream* poster = nullptr;  // nullptr: no poster
    std::unique_ptr<SoundSource> sound_source;
    std::optional<SoundStream> sound;  // empty: no sound
    std::optional<Hdr10Settings> hdr10;
    std::int64_t frames_written = 0;
    std::int64_t packets_written = 0;
};

VideoWriter::State::State(const std::string& path, const VideoFormat& video_format,
                          const OutputSettings& output,
                          const std::map<std::string, std::string>& metadata,
                          std::unique_ptr<SoundSource> source)
    : format(video_format),
      file(path),
      container(open_container(file, std::string(find_container(path)->muxer), metadata)) {
    encoder =
        open_encoder(format, output, (container->oformat->flags & AVFMT_GLOBALHEADER) != 0, path);
    hdr10 = output.hdr10;
    describe_stream();
    add_sound(output, std::move(source));
    if (output.poster && std::string_view(container->oformat->name) == "mp4") {
        poster = check_allocated(avformat_new_stream(container.get(), nullptr), path);
        describe_poster(*poster, format.width, format.height);
    }
    write_header(*container, path);

    frame.reset(check_allocated(av_frame_alloc(), path));
    packet.reset(check_allocated(av_packet_alloc(), path));
    frame->format = encoder->pix_fmt;
    frame->width = format.width;
    frame->height = format.height;
    frame->colorspace = encoder->colorspace;
    frame->color_range = encoder->color_range;
    frame->color_primaries = encoder->color_primaries;
    frame->color_trc = encoder->color_trc;
    check_av(av_frame_get_buffer(frame.get(), 0), "allocating a frame", path);
}

namespace {

template <class T>
T& side_data(AVStream& stream, AVPacketSideDataType type, std::size_t size,
             const std::string& path) {
    void* data = check_allocated(av_stream_new_side_data(&stream, type, size), path);
    return *static_cast<T*>(data);
}

/// Writes the data that x265 stores in the stream (encoder_options.h) into the container's boxes
/// too.
void describe_hdr10(AVStream& stream, const Hdr10Settings& settings, const LightLevels& levels,
                    const std::string& path) {
    const auto chroma = [](int steps) { return AVRational{steps, 50000}; };
    auto& display = side_data<AVMasteringDisplayMetadata>(
        stream, AV_PKT_DATA_MASTERING_DISPLAY_METADATA, sizeof(AVMasteringDisplayMetadata), path);
    display = {};
    const int primaries[3][2] = {{34000, 16000}, {13250, 34500}, {7500, 3000}};
    for (int i = 0; i < 3; ++i) {
        display.display_primaries[i][0] = chroma(primaries[i][0]);
        display.display_primaries[i][1] = chroma(primaries[i][1]);
    }
    display.white_point[0] = chroma(15635);
    display.white_point[1] = chroma(16450);
    display.min_luminance = AVRational{50, 10000};
    display.max_luminance = av_d2q(std::round(settings.peak), 10000);
    display.has_primaries = 1;
    display.has_luminance = 1;
    auto& light = side_data<AVContentLightMetadata>(stream, AV_PKT_DATA_CONTENT_LIGHT_LEVEL,
                                                    sizeof(AVContentLightMetadata), path);
    light = {};
    light.MaxCLL = static_cast<unsigned>(levels.brightest);
    light.MaxFALL = static_cast<unsigned>(levels.brightest_mean);
}

}  // namespace

void VideoWriter::State::describe_stream() {
    stream = check_allocated(avformat_new_stream(container.get(), nullptr), path());
    stream->time_base = encoder->time_base;
    stream->avg_frame_rate = encoder->framerate;
    stream->r_frame_rate = encoder->framerate;
    stream->sample_aspect_ratio = encoder->sample_aspect_ratio;
    check_av(avcodec_parameters_from_context(stream->codecpar, encoder.get()),
             "describing the stream", path());
    const std::string_view muxer = container->oformat->name;
    if (encoder->codec_id == AV_CODEC_ID_HEVC && (muxer == "mp4" || muxer == "mov")) {
        stream->codecpar->codec_tag =
            MKTAG('h', 'v', 'c', '1');  // Apple's players do not accept hev1
    }
    if (hdr10) {
        describe_hdr10(*stream, *hdr10, light_levels(format, *hdr10), path());
    }
}

void VideoWriter::State::add_sound(const OutputSettings& output,
                                   std::unique_ptr<SoundSource> source) {
    const AudioCodec codec = audio_codec_for(output, path());
    if (source != nullptr && codec != AudioCodec::none) {
        sound_source = std::move(source);
        sound.emplace(*container, codec, audio_bit_rate_of(output, codec), path());
    }
}

void VideoWriter::State::write_sound_before(std::int64_t picture) {
    if (sound && picture > 0) {
        write_sound(*sound_source, *sound, first_sample(picture, format.fps));
    }
}

void VideoWriter::State::encode(const AVFrame* picture) {
    check_av(avcodec_send_frame(encoder.get(), picture), "encoding", path());
    for (;;) {
        const int code = avcodec_receive_packet(encoder.get(), packet.get());
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) {
            return;
        }
        check_av(code, "encoding", path());
        set_decoding_time(*packet, *encoder, packets_written++);
        write_sound_before(packet->dts);
        packet->stream_index = stream->index;
        packet->duration = 1;  // one frame, in the encoder's time base
        av_packet_rescale_ts(packet.get(), encoder->time_base, stream->time_base);
        // The sound is interleaved here, and a poster has no time.
        check_av(av_write_frame(container.get(), packet.get()), "writing", path());
    }
}

void VideoWriter::State::close() {
    encode(nullptr);
    if (sound) {
        write_sound(*sound_source, *sound, first_sample(frames_written, format.fps));
        sound->finish();
    }
    close_container(*container, file);
}

VideoWriter::VideoWriter(const std::string& path, const VideoFormat& format,
                         const OutputSettings& output,
                         const std::map<std::string, std::string>& metadata,
                         std::unique_ptr<SoundSource> sound) {
    const std::string problem = check_video_format(format, output, path);
    if (!problem.empty()) {
        throw Error(problem);
    }
    capture_av_log();
    state_ = std::make_unique<State>(path, format, output, metadata, std::move(sound));
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::write(std::span<const std::uint16_t> rgb) {
    CAROM_ASSERT(state_ != nullptr);
    State& state = *state_;
    CAROM_ASSERT(rgb.size() == std::size_t{3} * static_cast<std::size_t>(state.format.width) *
                                   static_cast<std::size_t>(state.format.height));
    // If the encoder still refers to the previous picture, this gives the frame a new buffer.
    check_av(av_frame_make_writable(state.frame.get()), "allocating a frame", state.path());
    fill_frame(*state.frame, rgb);
    if (state.hdr10) {
        limit_to_peak(yuv10_planes(*state.frame), state.format.width, state.format.height,
                      pq_encode(state.hdr10->peak));
    }
    state.frame->pts = state.frames_written++;
    state.encode(state.frame.get());
}

bool VideoWriter::has_poster() const {
    CAROM_ASSERT(state_ != nullptr);
    return state_->poster != nullptr;
}

void VideoWriter::set_poster(std::span<const std::uint8_t> rgb) {
    CAROM_ASSERT(has_poster());
    State& state = *state_;
    const AvPtr<AVPacket> jpeg =
        encode_poster(rgb, state.format.width, state.format.height, state.path());
    jpeg->stream_index = state.poster->index;
    check_av(av_write_frame(state.container.get(), jpeg.get()), "writing the poster", state.path());
}

void VideoWriter::finish() {
    CAROM_ASSERT(state_ != nullptr);
    const std::unique_ptr<State> state = std::move(state_);
    if (state->frames_written == 0) {
        throw Error("cannot write '" + state->path() + "': the film has no frames");
    }
    state->close();
}

}  // namespace carom::pipeline
