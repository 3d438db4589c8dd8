// Where results go.
#pragma once

#include <string>

namespace carom::cli {

/// `given`, or if that is empty, the input's name with another extension in the current folder:
/// ("", "shots/break.yaml", ".mp4") is "break.mp4".
[[nodiscard]] std::string output_or_default(const std::string& given, const std::string& input,
                                            const std::string& extension);

/// Throws InputError if the folder that `path` names does not exist: better than after an hour.
void check_output_folder(const std::string& path);

/// Whole or not at all; "-" is stdout, and what is there but no regular file (a pipe, a device) is
/// written to as it stands. The path is printed as a result unless the text itself went to stdout.
/// Throws Error.
void write_text_output(const std::string& path, const std::string& text);

}  // namespace carom::cli
