// Writes drawings as .svg or .png.
#pragma once

#include <string>

#include "pipeline/plan/plan_colours.h"

namespace carom::cli {

/// The file of a drawing.
struct DrawingOutput {
    std::string path;  // .svg, .png, or "-": SVG on standard output
    int width = 0;     // of a .png, pixels
};

/// Throws InputError if the name ends in neither .svg nor .png, or if its folder does not exist.
/// `what` names the drawing: "a plan".
void check_drawing_path(const std::string& path, const std::string& what);

/// The page for "light", "dark" or "auto". "auto" is light for a .png, which cannot adapt to the
/// browser.
[[nodiscard]] pipeline::PlanPage page_of(const std::string& page, const std::string& path);

/// Writes the drawing completely or not at all, like write_text_output. Throws Error.
void write_drawing(const DrawingOutput& output, const std::string& svg);

}  // namespace carom::cli
