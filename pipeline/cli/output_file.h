// Writes results to files or to standard output.
#pragma once

#include <string>

#include "pipeline/cli/commands.h"

namespace carom::cli {

/// `given`, or if that is empty, the input's name with another extension in the current folder:
/// ("", "shots/break.yaml", ".mp4") is "break.mp4". A shot from standard input is called "stdin".
[[nodiscard]] std::string output_or_default(const std::string& given, const std::string& input,
                                            const std::string& extension);

/// Throws InputError if the command would replace a file that it reads, such as its shot.
void check_not_input(const Command& command);

/// Throws InputError if the folder of `path` does not exist. Called before the work begins.
void check_output_folder(const std::string& path);

/// Writes the file completely or not at all. "-" is stdout, and an existing path that is not a
/// regular file (a pipe, a device) is written to directly. The path is printed as a result unless
/// the text was written to stdout or directly. Throws Error.
void write_text_output(const std::string& path, const std::string& text);

}  // namespace carom::cli
