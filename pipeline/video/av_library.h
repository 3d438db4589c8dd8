// Owning pointers for libav's objects, and Errors for its error codes.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
}

#include <memory>
#include <string>

namespace carom::pipeline {

struct AvDeleter {
    void operator()(AVCodecContext* context) const { avcodec_free_context(&context); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    /// Also closes the file, if one is open.
    void operator()(AVFormatContext* context) const {
        if (context != nullptr) {
            avio_closep(&context->pb);
            avformat_free_context(context);
        }
    }
};

template <class T>
using AvPtr = std::unique_ptr<T, AvDeleter>;

/// libav has one log function per process. After the first call of capture_av_log it prints
/// nothing: the last message of each thread of level error or worse is kept for the next Error.
void capture_av_log();

/// What libav says about an error's code.
[[nodiscard]] std::string av_error_text(int code);

/// If `code` is a libav error, throws Error "cannot write 'PATH': STEP failed: TEXT", with the last
/// message that libav logged on this thread, if any. Otherwise returns `code`.
int check_av(int code, const char* step, const std::string& path);

/// The same check for functions that return nullptr when memory is short.
template <class T>
T* check_allocated(T* object, const std::string& path) {
    if (object == nullptr) {
        check_av(AVERROR(ENOMEM), "allocating memory", path);
    }
    return object;
}

}  // namespace carom::pipeline
