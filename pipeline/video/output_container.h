// A file that libavformat writes, complete or not at all.
#pragma once

#include <map>
#include <string>

#include "pipeline/video/av_library.h"
#include "pipeline/video/pending_file.h"

namespace carom::pipeline {

/// Opens a container that writes to the temporary path of `file`. It has no streams yet, and gets
/// no dates, versions or random identifiers. `muxer`: its name in libavformat. `metadata`: keys
/// that containers know ("title", "artist", "date", "description" ...) are written as tags of these
/// names, others are collected in "comment" as "key=value; key=value". Throws Error that names the
/// file's target.
[[nodiscard]] AvPtr<AVFormatContext> open_container(
    const PendingFile& file, const std::string& muxer,
    const std::map<std::string, std::string>& metadata);

/// Writes the header, after all streams were added. In .mp4, .mov and .m4a the index will come
/// before the data. Throws Error.
void write_header(AVFormatContext& container, const std::string& path);

/// Writes the trailer, closes the file and gives it its name. Throws Error.
void close_container(AVFormatContext& container, PendingFile& file);

}  // namespace carom::pipeline
