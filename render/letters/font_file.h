// Files with fonts.
#pragma once

#include <string>

namespace carom::render {

/// Throws Error that names `path` if the file is not a whole font with outlines for Unicode
/// letters (Microsoft, "OpenType font file").
void check_font_file(const std::string& path);

}  // namespace carom::render
