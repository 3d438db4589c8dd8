// The table of commands and options as plain data, for whoever describes it: completions, the
// manual.
#pragma once

#include <string>
#include <vector>

namespace carom::cli {

struct OptionInfo {
    std::string short_name;  // "-o", or empty
    std::string long_name;   // "--output"
    std::string value;       // "FILE"; empty: a flag
    std::string description;
    std::vector<std::string> choices;  // of the value, if they are known

    [[nodiscard]] bool takes_file() const { return value == "FILE"; }
    [[nodiscard]] bool takes_folder() const { return value == "FOLDER"; }
};

/// What stands without a dash: a shot, a file to write.
struct ArgumentInfo {
    std::string name;  // "SHOT|BAKE"
    std::string description;
    std::vector<std::string> choices;
};

struct CommandInfo {
    std::string name;  // "render"; of the program: "carom"
    std::string description;
    std::string footer;  // its example, and what else its help ends with
    std::vector<ArgumentInfo> arguments;
    std::vector<OptionInfo> options;
    std::vector<CommandInfo> commands;  // below it
};

/// The program itself, with all its commands.
[[nodiscard]] CommandInfo describe_command_line();

}  // namespace carom::cli
