// Where drawings go.
#pragma once

#include <string>

#include "pipeline/plan/plan_colours.h"

namespace carom::cli {

/// How a drawing is written.
struct DrawingOutput {
    std::string path;  // .svg, .png, or "-": SVG on standard output
    int width = 0;     // of a .png, pixels
};

/// Throws InputError if a drawing cannot be written in the format that the name asks for, or if its
/// folder does not exist. `what`: "a plan".
void check_drawing_path(const std::string& path, const std::string& what);

/// "light" and "dark" as they are; "auto" is light for pictures, which cannot ask their reader.
[[nodiscard]] pipeline::PlanPage page_of(const std::string& page, const std::string& path);

/// Whole or not at all, like write_text_output. Throws Error.
void write_drawing(const DrawingOutput& output, const std::string& svg);

}  // namespace carom::cli
