#include "pipeline/cli/drawing_output.h"

#include <filesystem>
#include <span>

#include <fmt/core.h>

#include "core/atomic_file.h"
#include "pipeline/cli/helper_program.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

namespace {

bool is_png(const std::string& path) {
    return std::filesystem::path(path).extension() == ".png";
}

}  // namespace

void check_drawing_path(const std::string& path, const std::string& what) {
    if (path != "-" && !is_png(path) && std::filesystem::path(path).extension() != ".svg") {
        throw InputError("'" + path + "': " + what + " can only be written as .svg or .png");
    }
    check_output_folder(path);
}

pipeline::PlanPage page_of(const std::string& page, const std::string& path) {
    return page == "dark"                    ? pipeline::PlanPage::dark
           : page == "light" || is_png(path) ? pipeline::PlanPage::light
                                             : pipeline::PlanPage::automatic;
}

void write_drawing(const DrawingOutput& output, const std::string& svg) {
    if (!is_png(output.path)) {
        write_text_output(output.path, svg);
        return;
    }
    const std::vector<std::byte> png =
        run_helper("carom-draw", "the program that draws pictures", fmt::format("{}", output.width),
                   std::as_bytes(std::span(svg)));
    write_file_atomically(output.path, png);
    print_path(output.path);
}

}  // namespace carom::cli
