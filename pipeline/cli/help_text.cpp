#include "pipeline/cli/help_text.h"

#include <algorithm>
#include <sstream>

namespace carom::cli {

namespace {

constexpr std::size_t kTerminalWidth = 80;
constexpr std::size_t kColumn = 24;  // in which the explanation of an option or a command begins
constexpr std::size_t kIndent = 2;

/// A label and its explanation, side by side if the label is short.
std::string entry(const std::string& label, const std::string& text) {
    const std::string lines = wrapped(text, kTerminalWidth, kColumn) + "\n";
    const std::string head = std::string(kIndent, ' ') + label;
    return head.size() < kColumn ? head + lines.substr(head.size()) : head + "\n" + lines;
}

void add_paragraphs(std::string& text, const std::vector<std::string>& paragraphs) {
    for (const std::string& paragraph : paragraphs) {
        text += "\n" + wrapped(paragraph, kTerminalWidth) + "\n";
    }
}

void add_options(std::string& text, const CommandDescription& command, bool arguments) {
    std::string section;
    for (const Option& option : command.options) {
        if (option.is_argument() == arguments) {
            section += entry(label_of(option), option.help);
        }
    }
    if (!section.empty()) {
        text += (arguments ? "\nArguments:\n" : "\nOptions:\n") + section;
    }
}

/// Adds the commands below the headings of their groups, in the order of the table.
void add_commands(std::string& text, const CommandDescription& command) {
    std::string heading;
    for (const CommandDescription& subcommand : command.commands) {
        const std::string group = subcommand.group.empty() ? "Commands" : subcommand.group;
        if (group != heading) {
            heading = group;
            text += "\n" + heading + ":\n";
        }
        text += entry(subcommand.name, subcommand.summary);
    }
}

/// A command line, continued on the next line where it would be wider than the terminal.
std::string broken(const std::string& line) {
    std::string text;
    std::size_t width = kIndent;
    std::size_t begin = 0;
    while (begin < line.size()) {
        const std::size_t end = std::min(line.find(" --", begin + 1), line.size());
        const std::string part = line.substr(begin, end - begin);
        if (begin > 0 && width + part.size() > kTerminalWidth - 2) {
            text += " \\\n     ";
            width = 5;
        }
        text += part;
        width += part.size();
        begin = end;
    }
    return text;
}

void add_examples(std::string& text, const std::vector<Example>& examples) {
    text += examples.size() == 1 ? "\nExample:\n" : "\nExamples:\n";
    for (const Example& example : examples) {
        text +=
            "  " + broken(example.line) + "\n" + wrapped(example.meaning, kTerminalWidth, 6) + "\n";
    }
}

}  // namespace

std::string help_text(const CommandDescription& command, const std::string& path) {
    std::string text = "Usage: " + usage_line(command, path) + "\n";
    add_paragraphs(text, {command.summary});
    add_paragraphs(text, command.details);
    add_options(text, command, true);
    if (command.commands.empty()) {
        add_options(text, command, false);
        add_examples(text, command.examples);
    } else {
        add_examples(text, command.examples);
        add_commands(text, command);
        add_options(text, command, false);
    }
    add_paragraphs(text, command.notes);
    return text;
}

std::string usage_line(const CommandDescription& command, const std::string& path) {
    std::string text = path + (command.commands.empty() ? "" : " COMMAND") + " [OPTIONS]";
    for (const Option& option : command.options) {
        if (option.is_argument()) {
            text += option.is_required ? " " + option.name : " [" + option.name + "]";
        }
    }
    return text;
}

std::string label_of(const Option& option) {
    return (option.short_name.empty() ? "" : option.short_name + ", ") + option.name +
           (option.value.empty() ? "" : " " + option.value);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
    std::istringstream words{std::string(text)};
    const std::string margin(indent, ' ');
    std::string out = margin;
    std::size_t length = indent;
    for (std::string word; words >> word;) {
        if (length > indent) {
            const bool fits = length + 1 + word.size() <= width;
            out += fits ? " " : "\n" + margin;
            length = fits ? length + 1 : indent;
        }
        out += word;
        length += word.size();
    }
    return out;
}

}  // namespace carom::cli
