#include <algorithm>
#include <filesystem>
#include <utility>

#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/schema_line.h"

namespace carom::cli {

namespace fs = std::filesystem;
namespace config = pipeline::config;

namespace {

std::string template_text(std::string name, const config::ConfigFolders& folders) {
    if (name == "massé") {
        name = "masse";
    }
    const config::FoundFile found =
        config::find_config_file("templates/" + name + ".yaml", ".", folders);
    std::string text;
    if (found.path.empty()) {
        throw InputError("cannot find the template '" + name + "'; is carom installed completely?");
    }
    if (!config::read_text_file(found.path, config::YamlLimits{}.bytes, text)) {
        throw InputError("the file '" + found.path + "' " + text);
    }
    return text;
}

}  // namespace

void run(const NewCommand& command, CommandContext& context) {
    const config::ConfigFolders folders = config::standard_config_folders();
    std::string text = template_text(command.template_name, folders);
    if (command.shot == "-") {
        return print_text(text);
    }
    check_output_folder(command.shot);
    std::error_code ignored;
    if (!command.force && fs::exists(command.shot, ignored)) {
        throw InputError("'" + command.shot + "' already exists; use --force to overwrite it");
    }
    const std::string folder = fs::path(command.shot).parent_path().string();
    write_text_output(command.shot, config::with_schema_line(std::move(text), folder));
    context.console.info("the shot is ready for 'carom check', 'plan', 'frame' and 'render'");
}

}  // namespace carom::cli
