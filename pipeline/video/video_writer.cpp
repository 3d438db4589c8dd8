#include "pipeline/video/video_writer.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "pipeline/video/container.h"
#include "pipeline/video/encoder.h"
#include "pipeline/video/pending_file.h"
#include "sim/timeline/assert.h"
#include "sim/timeline/error.h"

namespace carom::pipeline {

namespace {

// Names that both the MP4 and the Matroska muxer write as tags of their own.
constexpr std::array<std::string_view, 7> kKnownTags{"title", "artist",      "album", "comment",
                                                     "date",  "description", "genre"};

/// libavformat would read "a:b.mp4" as protocol "a".
std::string file_url(const std::string& path) {
    return "file:" + path;
}

std::map<std::string, std::string> known_tags(const std::map<std::string, std::string>& metadata) {
    std::map<std::string, std::string> tags;
    std::string others;
    for (const auto& [key, value] : metadata) {
        if (std::find(kKnownTags.begin(), kKnownTags.end(), key) != kKnownTags.end()) {
            tags[key] = value;
        } else {
            others += (others.empty() ? "" : "; ") + key + "=" + value;
        }
    }
    if (!others.empty()) {
        std::string& comment = tags["comment"];
        comment += (comment.empty() ? "" : "; ") + others;
    }
    return tags;
}

}  // namespace

// Members are destroyed from the last to the first: the container closes its file before the
// pending file removes it.
struct VideoWriter::State {
    State(const std::string& path, const VideoFormat& video_format, const OutputSettings& output,
          const std::map<std::string, std::string>& metadata);

    void open_container(const std::map<std::string, std::string>& metadata);
    void write_header();
    /// Hands a picture (or nullptr: the end) to the encoder and writes every packet that comes out.
    void encode(const AVFrame* picture);
    void close();

    [[nodiscard]] const std::string& path() const { return file.target(); }

    VideoFormat format;
    PendingFile file;
    AvPtr<AVFormatContext> container;
    AvPtr<AVCodecContext> encoder;
    AvPtr<AVFrame> frame;
    AvPtr<AVPacket> packet;
    AVStream* stream = nullptr;  // the container's
    std::int64_t frames_written = 0;
};

VideoWriter::State::State(const std::string& path, const VideoFormat& video_format,
                          const OutputSettings& output,
                          const std::map<std::string, std::string>& metadata)
    : format(video_format), file(path) {
    open_container(metadata);
    encoder =
        open_encoder(format, output, (container->oformat->flags & AVFMT_GLOBALHEADER) != 0, path);
    write_header();

    frame.reset(check_allocated(av_frame_alloc(), path));
    packet.reset(check_allocated(av_packet_alloc(), path));
    frame->format = encoder->pix_fmt;
    frame->width = format.width;
    frame->height = format.height;
    check_av(av_frame_get_buffer(frame.get(), 0), "making room for a frame", path);
}

void VideoWriter::State::open_container(const std::map<std::string, std::string>& metadata) {
    const std::string muxer(find_container(path())->muxer);
    const std::string url = file_url(file.temporary_path());
    AVFormatContext* opened = nullptr;
    check_av(avformat_alloc_output_context2(&opened, nullptr, muxer.c_str(), url.c_str()),
             "opening the container", path());
    container.reset(opened);
    container->flags |= AVFMT_FLAG_BITEXACT;  // no dates, versions or random identifiers
    for (const auto& [key, value] : known_tags(metadata)) {
        check_av(av_dict_set(&container->metadata, key.c_str(), value.c_str(), 0),
                 "writing metadata", path());
    }
    check_av(avio_open2(&container->pb, url.c_str(), AVIO_FLAG_WRITE, nullptr, nullptr),
             "opening the file", path());
}

void VideoWriter::State::write_header() {
    stream = check_allocated(avformat_new_stream(container.get(), nullptr), path());
    stream->time_base = encoder->time_base;
    stream->avg_frame_rate = encoder->framerate;
    stream->r_frame_rate = encoder->framerate;
    stream->sample_aspect_ratio = encoder->sample_aspect_ratio;
    check_av(avcodec_parameters_from_context(stream->codecpar, encoder.get()),
             "describing the stream", path());
    AVDictionary* options = nullptr;
    const std::string_view muxer = container->oformat->name;
    if (muxer == "mp4" || muxer == "mov") {
        av_dict_set(&options, "movflags", "+faststart+write_colr", 0);
    }
    const int code = avformat_write_header(container.get(), &options);
    av_dict_free(&options);
    check_av(code, "writing the header", path());
}

void VideoWriter::State::encode(const AVFrame* picture) {
    check_av(avcodec_send_frame(encoder.get(), picture), "encoding", path());
    for (;;) {
        const int code = avcodec_receive_packet(encoder.get(), packet.get());
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) {
            return;
        }
        check_av(code, "encoding", path());
        packet->stream_index = stream->index;
        packet->duration = 1;  // one frame, in the encoder's time base
        av_packet_rescale_ts(packet.get(), encoder->time_base, stream->time_base);
        check_av(av_interleaved_write_frame(container.get(), packet.get()), "writing", path());
    }
}

void VideoWriter::State::close() {
    encode(nullptr);
    check_av(av_write_trailer(container.get()), "writing the end", path());
    check_av(container->pb->error, "writing", path());
    check_av(avio_closep(&container->pb), "closing", path());
    file.commit();
}

VideoWriter::VideoWriter(const std::string& path, const VideoFormat& format,
                         const OutputSettings& output,
                         const std::map<std::string, std::string>& metadata) {
    const std::string problem = check_video_format(format, output, path);
    if (!problem.empty()) {
        throw Error(problem);
    }
    capture_av_log();
    state_ = std::make_unique<State>(path, format, output, metadata);
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::write(std::span<const std::uint16_t> rgb) {
    CAROM_ASSERT(state_ != nullptr);
    State& state = *state_;
    CAROM_ASSERT(rgb.size() == std::size_t{3} * static_cast<std::size_t>(state.format.width) *
                                   static_cast<std::size_t>(state.format.height));
    // The encoder may still hold the last picture: then this gives the frame a new buffer.
    check_av(av_frame_make_writable(state.frame.get()), "making room for a frame", state.path());
    fill_frame(*state.frame, rgb);
    state.frame->pts = state.frames_written++;
    state.encode(state.frame.get());
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
