#include "pipeline/cli/completion.h"

#include <algorithm>
#include <utility>

#include "pipeline/cli/program_description.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/key_completion.h"
#include "pipeline/config/measures/measures.h"
#include "pipeline/config/parse_yaml.h"

namespace carom::cli {

namespace {

namespace config = pipeline::config;

struct Candidate {
    std::string text;
    std::string description;
};

/// What the words before the last one determine.
struct Position {
    const CommandDescription* command = nullptr;
    const Option* option = nullptr;  // the option whose value comes next
    std::vector<std::string> arguments;
};

Position position_after(const CommandDescription& program, const std::vector<std::string>& words) {
    Position position{&program, nullptr, {}};
    for (const std::string& word : words) {
        if (position.option != nullptr) {
            position.option = nullptr;
        } else if (word.size() > 1 && word.starts_with('-')) {
            const Option* option = position.command->find_option(word);
            position.option = option != nullptr && !option->is_flag() ? option : nullptr;
        } else if (const auto* subcommand = position.command->find_command(word)) {
            position.command = subcommand;
        } else {
            position.arguments.push_back(word);
        }
    }
    return position;
}

/// The argument with that index.
const Option* argument_at(const CommandDescription& command, std::size_t index) {
    for (const Option& option : command.options) {
        if (option.is_argument() && index-- == 0) {
            return &option;
        }
    }
    return nullptr;
}

/// The YAML tree of the shot or bake that is named, or an empty one.
config::Node shot_tree(const Position& position) {
    const Option* argument = argument_at(*position.command, 0);
    if (position.arguments.empty() || argument == nullptr || argument->offer != Offer::files) {
        return {};
    }
    const std::string& path = position.arguments.front();
    InputOptions input;
    input.path = path;
    if (is_bake(input)) {
        return config::readable_tree(sim::read_bake(path).shot_text, path);
    }
    std::string text;
    const bool is_read = config::read_text_file(path, config::YamlLimits{}.bytes, text);
    return is_read ? config::readable_tree(text, path) : config::Node{};
}

std::vector<Candidate> candidates_of(std::vector<std::string> words) {
    std::vector<Candidate> candidates;
    candidates.reserve(words.size());
    for (std::string& word : words) {
        candidates.push_back({std::move(word), {}});
    }
    return candidates;
}

/// The possible values of an option or argument of which `typed` is the beginning.
std::vector<Candidate> values_of(const Option& option, const std::string& typed,
                                 const Position& position) {
    switch (option.offer) {
        case Offer::keys: {
            std::vector<Candidate> candidates;
            for (auto& key : config::complete_override(typed, shot_tree(position))) {
                candidates.push_back({std::move(key.text), std::move(key.description)});
            }
            return candidates;
        }
        case Offer::cameras:
            return candidates_of(config::camera_names(shot_tree(position)));
        case Offer::presets:
            return candidates_of(
                config::preset_names("quality", config::standard_config_folders()));
        case Offer::measures: {
            std::vector<Candidate> candidates;
            for (const pipeline::measures::MeasureInfo& info : pipeline::measures::measure_list()) {
                candidates.push_back({std::string(info.name) + ":", std::string(info.meaning)});
            }
            return candidates;
        }
        case Offer::folders:
            return {{":folders", {}}};
        case Offer::files: {
            std::string text = ":files";
            for (const std::string& ending : option.endings) {
                text += " " + ending;
            }
            return {{text, {}}};
        }
        case Offer::nothing:
            break;
    }
    return candidates_of(option.choices);
}

std::vector<Candidate> candidates_for(const Position& position, const std::string& typed) {
    if (position.option != nullptr) {
        return values_of(*position.option, typed, position);
    }
    std::vector<Candidate> candidates;
    const std::size_t equals = typed.find('=');
    if (typed.starts_with("--") && equals != std::string::npos) {
        const Option* option = position.command->find_option(typed.substr(0, equals));
        if (option != nullptr && !option->is_flag()) {
            candidates = values_of(*option, typed.substr(equals + 1), position);
        }
        for (Candidate& candidate : candidates) {
            const bool is_word = !candidate.text.starts_with(':');
            candidate.text.insert(0, is_word ? typed.substr(0, equals + 1) : "");
        }
    } else if (typed.starts_with('-')) {
        for (const Option& option : position.command->options) {
            if (!option.is_argument()) {
                candidates.push_back({option.name, option.help});
            }
        }
    } else if (!position.command->commands.empty()) {
        for (const CommandDescription& subcommand : position.command->commands) {
            candidates.push_back({subcommand.name, subcommand.summary});
        }
    } else if (const Option* argument = argument_at(*position.command, position.arguments.size())) {
        candidates = values_of(*argument, typed, position);
    }
    return candidates;
}

std::string lines_for(std::vector<std::string> words) {
    const std::string typed = words.empty() ? "" : words.back();
    words.resize(words.empty() ? 0 : words.size() - 1);
    ProgramOptions options;
    const CommandDescription program = describe_program(options);
    std::string lines;
    for (const Candidate& candidate : candidates_for(position_after(program, words), typed)) {
        if (candidate.text.starts_with(':')) {
            lines += candidate.text + "\n";
        } else if (candidate.text.starts_with(typed)) {
            lines += candidate.text +
                     (candidate.description.empty() ? "" : "\t" + candidate.description) + "\n";
        }
    }
    return lines;
}

}  // namespace

std::string completion_lines(const std::vector<std::string>& words) noexcept {
    try {
        return lines_for(words);
    } catch (...) {
        return {};  // A message would disturb the user, who is typing.
    }
}

}  // namespace carom::cli
