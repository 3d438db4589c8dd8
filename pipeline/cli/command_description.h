// A command and its options as data, for the parser, the help, the manual and the completion in
// shells.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace carom::cli {

/// The variable to which the parser writes a value.
using Target = std::variant<bool*, std::string*, std::vector<std::string>*, int*, std::int64_t*,
                            double*, std::optional<std::int64_t>*, std::optional<double>*>;

/// What a shell offers as completions of a value that has no fixed choices.
enum class Offer { nothing, files, folders, keys, cameras, presets, measures };

/// An option "--threads N", a flag "--json" or an argument "SHOT|BAKE".
struct Option {
    std::string short_name;  // "-o", or empty
    std::string name;        // "--output"; of an argument its placeholder: "SHOT|BAKE"
    std::string value;       // "FILE"; empty: a flag or an argument
    std::string help;        // sentences
    Target target;           // a null bool*: the parser handles the option (--help, --version);
                             // a null std::string*: the value is not used
    bool is_required = false;
    std::vector<std::string> choices;  // the only valid values; empty: any value
    std::optional<double> minimum;     // of a number
    std::optional<double> maximum;
    bool must_be_folder = false;                                // that exists
    std::function<std::string(const std::string&)> problem_of;  // of a value; empty: none
    std::vector<std::string> excluded;                          // names of other options
    std::string needed;                                         // name of another option
    Offer offer = Offer::nothing;
    std::vector<std::string> endings;  // of files to offer: "yaml"; empty: any

    [[nodiscard]] bool is_argument() const { return !name.starts_with('-'); }
    [[nodiscard]] bool is_flag() const { return std::holds_alternative<bool*>(target); }

    Option& one_of(std::vector<std::string> values);
    Option& from(double smallest);
    Option& between(double smallest, double largest);
    Option& checked_by(std::function<std::string(const std::string&)> check);
    Option& excludes(std::vector<std::string> names);
    Option& needs(std::string name);
    Option& offers(Offer what, std::vector<std::string> file_endings = {});
};

struct Example {
    std::string line;     // "carom check break.yaml"
    std::string meaning;  // a sentence
};

struct CommandDescription {
    std::string name;                  // "render"; of the program itself "carom"
    std::string summary;               // a sentence
    std::string group;                 // its heading in the help
    std::vector<std::string> details;  // paragraphs
    std::list<Option> options;         // in order; a list, so that references remain valid
    std::vector<Example> examples;
    std::vector<std::string> notes;          // paragraphs at the end
    std::list<CommandDescription> commands;  // subcommands
    std::function<void()> chosen;            // called if the command is given

    /// `names` are "--json" or "-o,--output".
    Option& flag(const std::string& names, bool& target, std::string help);
    Option& option(const std::string& names, Target target, std::string value, std::string help);
    /// A required word without a dash.
    Option& argument(const std::string& argument_name, std::string& target, std::string help);
    /// One or more such words.
    Option& argument(const std::string& argument_name, std::vector<std::string>& target,
                     std::string help);

    /// Adds a subcommand.
    CommandDescription& command(std::string command_name, std::string command_summary);

    [[nodiscard]] const CommandDescription* find_command(const std::string& command_name) const;
    /// Finds an option by either of its names.
    [[nodiscard]] const Option* find_option(const std::string& option_name) const;
};

}  // namespace carom::cli
