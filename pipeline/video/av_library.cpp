#include "pipeline/video/av_library.h"

#include <array>
#include <cstdarg>
#include <mutex>

#include "core/error.h"

namespace carom::pipeline {

namespace {

std::string& last_message() {
    thread_local std::string message;
    return message;
}

// libav calls this on the thread that logs the message; it changes only the text of that thread.
void keep_message(void* object, int level, const char* format, std::va_list arguments) {
    if (level > AV_LOG_ERROR) {
        return;
    }
    std::array<char, 512> line{};
    int print_prefix = 0;
    av_log_format_line2(object, level, format, arguments, line.data(),
                        static_cast<int>(line.size()), &print_prefix);
    std::string text = line.data();
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) {
        text.pop_back();
    }
    if (!text.empty()) {
        last_message() = text;
    }
}

}  // namespace

void capture_av_log() {
    static std::once_flag once;
    std::call_once(once, [] { av_log_set_callback(keep_message); });
    last_message().clear();
}

std::string av_error_text(int code) {
    std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
    av_strerror(code, text.data(), text.size());
    return text.data();
}

int check_av(int code, const char* step, const std::string& path) {
    if (code >= 0) {
        return code;
    }
    std::string text = "cannot write '" + path + "': " + step + " failed: " + av_error_text(code);
    if (!last_message().empty()) {
        text += " (" + last_message() + ")";
        last_message().clear();
    }
    throw Error(text);
}

}  // namespace carom::pipeline
