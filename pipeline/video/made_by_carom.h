// Whether a file was written by carom, so that it may be replaced without a question.
#pragma once

#include <string>

namespace carom::pipeline {

/// Whether the metadata of a film or picture names carom as the program that wrote it. Files in
/// formats without such metadata (.bmp, .tga), other files and those that cannot be read: no.
[[nodiscard]] bool is_made_by_carom(const std::string& path);

}  // namespace carom::pipeline
