#include "pipeline/video/output_container.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace carom::pipeline {

namespace {

// Names for which both the MP4 and the Matroska muxer have tags.
constexpr std::array<std::string_view, 7> kKnownTags{"title", "artist",      "album", "comment",
                                                     "date",  "description", "genre"};

/// Without "file:", libavformat would read "a:b.mp4" as protocol "a".
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
            others.append(others.empty() ? "" : "; ").append(key).append("=").append(value);
        }
    }
    if (!others.empty()) {
        std::string& comment = tags["comment"];
        comment += (comment.empty() ? "" : "; ") + others;
    }
    return tags;
}

}  // namespace

AvPtr<AVFormatContext> open_container(const PendingFile& file, const std::string& muxer,
                                      const std::map<std::string, std::string>& metadata) {
    const std::string& path = file.target();
    const std::string url = file_url(file.temporary_path());
    AVFormatContext* opened = nullptr;
    check_av(avformat_alloc_output_context2(&opened, nullptr, muxer.c_str(), url.c_str()),
             "opening the container", path);
    AvPtr<AVFormatContext> container(opened);
    container->flags |= AVFMT_FLAG_BITEXACT;
    for (const auto& [key, value] : known_tags(metadata)) {
        check_av(av_dict_set(&container->metadata, key.c_str(), value.c_str(), 0),
                 "writing metadata", path);
    }
    check_av(avio_open2(&container->pb, url.c_str(), AVIO_FLAG_WRITE, nullptr, nullptr),
             "opening the file", path);
    return container;
}

void write_header(AVFormatContext& container, const std::string& path) {
    AVDictionary* options = nullptr;
    const std::string_view muxer = container.oformat->name;
    if (muxer == "mp4" || muxer == "mov" || muxer == "ipod") {
        av_dict_set(&options, "movflags", "+faststart+write_colr", 0);
    }
    const int code = avformat_write_header(&container, &options);
    av_dict_free(&options);
    check_av(code, "writing the header", path);
}

void close_container(AVFormatContext& container, PendingFile& file) {
    const std::string& path = file.target();
    check_av(av_write_trailer(&container), "writing the trailer", path);
    check_av(container.pb->error, "writing", path);
    check_av(avio_closep(&container.pb), "closing", path);
    file.commit();
}

}  // namespace carom::pipeline
