#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/core.h>

#include "pipeline/cli/output_file.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/quantity.h"
#include "pipeline/import/import_track.h"

namespace carom::cli {

namespace {

/// Parses a length and returns it in metres. Throws InputError.
double parse_length(const std::string& text) {
    const auto parsed = pipeline::config::parse_quantity(text);
    const auto* quantity = std::get_if<pipeline::config::Quantity>(&parsed);
    constexpr pipeline::config::Exponents kLength{1, 0, 0, 0};
    constexpr double kMaxLength = 1;  // m
    if (quantity == nullptr || (quantity->has_unit && quantity->exponents != kLength) ||
        !(quantity->value >= 0 && quantity->value <= kMaxLength)) {
        throw InputError("'" + text + "' is not a length up to 1 m; write 0.01mm or '0.1 mm'");
    }
    return quantity->value;
}

/// Whether an object of a shot may have this name.
bool is_object_name(const std::string& name) {
    constexpr std::size_t kLongest = 64;
    return name.size() <= kLongest && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
           std::ranges::all_of(
               name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

}  // namespace

void run(const ImportTrackCommand& command, CommandContext& context) {
    const std::string path = output_or_default(command.output, command.table, ".yaml");
    if (path != "-") {
        check_output_folder(path);
        std::error_code ignored;
        if (std::filesystem::equivalent(path, command.table, ignored)) {
            throw InputError("the output '" + path +
                             "' is the table itself; give another file with -o");
        }
    }
    if (!command.name.empty() && !is_object_name(command.name)) {
        throw InputError("'" + command.name +
                         "' cannot be the name of an object; a name has at most 64 letters, "
                         "digits, _ and -, and begins with a letter");
    }
    pipeline::ImportTrackOptions options;
    options.object = command.object;
    options.name = command.name;
    options.is_linear = command.linear;
    if (!command.error.empty()) {
        options.error = parse_length(command.error);
    }
    const pipeline::ImportTrackResult result = pipeline::import_track_file(command.table, options);
    report_problems(result.problems, context.console, true);
    if (result.yaml.empty()) {
        throw InputError("'" + command.table + "' has " + count_text(result.problems));
    }
    context.console.info(fmt::format("{} keys for {} rows", result.keys, result.rows));
    write_text_output(path, result.yaml);
}

}  // namespace carom::cli
