#include "pipeline/video/made_by_carom.h"

#include <cctype>
#include <fstream>
#include <string_view>

#include "pipeline/video/av_library.h"
#include "pipeline/video/picture_kind.h"

namespace carom::pipeline {
namespace {

// job_metadata.h: what films, and what pictures say.
constexpr std::string_view kOfFilms = "carom_version=";
constexpr std::string_view kOfPictures = "carom ";  // and the version
constexpr std::size_t kHead = 64 << 10;             // bytes that hold a picture's metadata

bool is_our_picture(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(kHead, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    for (std::size_t at = head.find(kOfPictures); at != std::string::npos;
         at = head.find(kOfPictures, at + 1)) {
        const std::size_t next = at + kOfPictures.size();
        if (next < head.size() && std::isdigit(static_cast<unsigned char>(head[next])) != 0) {
            return true;
        }
    }
    return false;
}

bool is_our_film(const std::string& path) {
    AVFormatContext* opened = nullptr;
    // Without "file:", libavformat would read "a:b.mp4" as protocol "a".
    if (avformat_open_input(&opened, ("file:" + path).c_str(), nullptr, nullptr) < 0) {
        return false;
    }
    const AVDictionaryEntry* comment = av_dict_get(opened->metadata, "comment", nullptr, 0);
    const bool is_ours = comment != nullptr &&
                         std::string_view(comment->value).find(kOfFilms) != std::string_view::npos;
    avformat_close_input(&opened);
    return is_ours;
}

}  // namespace

bool is_made_by_carom(const std::string& path) {
    return is_picture_path(path) ? is_our_picture(path) : is_our_film(path);
}

}  // namespace carom::pipeline
