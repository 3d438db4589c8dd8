#include "pipeline/cli/manual_pages.h"

#include <algorithm>
#include <cctype>
#include <span>

#include "core/atomic_file.h"
#include "pipeline/cli/help_text.h"
#include "pipeline/cli/program_description.h"

namespace carom::cli {

namespace {

/// Escapes a text for roff: backslashes, control lines, and hyphens so that they can be copied.
std::string roff(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        if (letter == '\\' || letter == '-') {
            result += letter == '-' ? "\\-" : "\\e";
        } else {
            result += letter;
        }
    }
    return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string bold(const std::string& text) {
    return "\\fB" + roff(text) + "\\fR";
}

std::string italic(const std::string& text) {
    return text.empty() ? "" : "\\fI" + roff(text) + "\\fR";
}

/// "carom-render(1)"
std::string reference_to(const std::string& title) {
    return bold(title) + "(1)";
}

std::string entry(const std::string& label, const std::string& text) {
    return ".TP\n" + label + "\n" + roff(text) + "\n";
}

std::string entry(const Option& option) {
    const std::string value = option.value.empty() ? "" : " " + italic(option.value);
    return entry(option.is_argument() ? italic(option.name)
                 : option.short_name.empty()
                     ? bold(option.name) + value
                     : bold(option.short_name) + ", " + bold(option.name) + value,
                 option.help);
}

std::string paragraphs(const std::vector<std::string>& texts) {
    std::string page;
    for (const std::string& text : texts) {
        page += ".PP\n" + roff(text) + "\n";
    }
    return page;
}

/// The subcommands, which have no page of their own: those of carom cache.
std::string subcommands(const CommandDescription& command, const std::string& path) {
    std::string page;
    for (const CommandDescription& subcommand : command.commands) {
        page +=
            ".SS " + roff(path + " " + subcommand.name) + "\n" + roff(subcommand.summary) + "\n";
        for (const Option& option : subcommand.options) {
            page += entry(option);
        }
    }
    return page;
}

/// All commands with a page of their own, by group.
std::string commands(const CommandDescription& program) {
    std::string page = ".SH COMMANDS\n";
    std::string group;
    for (const CommandDescription& command : program.commands) {
        if (command.group != group) {
            group = command.group;
            page += ".SS " + roff(group) + "\n";
        }
        page += entry(reference_to("carom-" + command.name), command.summary);
    }
    return page;
}

constexpr const char* kEnvironment = R"(.SH ENVIRONMENT
.TP
\fBCAROM_CACHE\fR
The folder of bakes, finished frames and strikes that were found.
.TP
\fBCAROM_CACHE_SIZE\fR
The largest size of that folder.
.TP
\fBCAROM_CONFIGS\fR
A folder of tables, balls, looks, rigs and presets that is searched first.
.TP
\fBOCIO\fR
The OpenColorIO configuration of the view 'ocio'.
.TP
\fBNO_COLOR\fR
If it is set, messages have no colours.
)";

std::string examples_of(const CommandDescription& command) {
    std::string page = ".SH EXAMPLES\n";
    for (const Example& example : command.examples) {
        page += entry(bold(example.line), example.meaning);
    }
    return page;
}

}  // namespace

std::string manual_page(const CommandDescription& command, const std::string& title,
                        const std::string& version) {
    const bool is_program = title == "carom";
    const std::string path = is_program ? title : "carom " + command.name;
    std::string upper = title;
    std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
    std::string summary = command.summary.substr(0, command.summary.find_last_of('.'));
    summary.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(summary.front())));
    std::string page = ".TH " + roff(upper) + " 1 \"\" \"" + version + "\" \"User Commands\"\n" +
                       ".SH NAME\n" + roff(title) + " \\- " + roff(summary) + "\n.SH SYNOPSIS\n" +
                       bold(path) + roff(usage_line(command, "")) + "\n.SH DESCRIPTION\n" +
                       roff(command.summary) + "\n" + paragraphs(command.details);
    page += is_program ? commands(command) : subcommands(command, path);
    page += ".SH OPTIONS\n";
    for (const Option& option : command.options) {
        page += entry(option);
    }
    page += examples_of(command);
    if (is_program) {
        return page + kEnvironment + ".SH NOTES\n" + paragraphs(command.notes);
    }
    return page + ".SH SEE ALSO\n" + reference_to("carom") + "\n";
}

void write_manual(const std::string& folder) {
    ProgramOptions options;
    const CommandDescription program = describe_program(options);
    const std::string version = "carom " CAROM_VERSION;
    const auto write = [&](const CommandDescription& command, const std::string& title) {
        const std::string page = manual_page(command, title, version);
        write_file_atomically(folder + "/" + title + ".1", std::as_bytes(std::span(page)));
    };
    write(program, program.name);
    for (const CommandDescription& command : program.commands) {
        write(command, "carom-" + command.name);
    }
}

}  // namespace carom::cli
