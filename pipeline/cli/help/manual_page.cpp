#include "pipeline/cli/help/manual_page.h"

#include <sstream>

namespace carom::cli {

namespace {

/// A line of text: no escape, no request, and hyphens that can be copied.
std::string roff(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        if (letter == '\\') {
            result += "\\e";
        } else if (letter == '-') {
            result += "\\-";
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
    return "\\fI" + roff(text) + "\\fR";
}

/// Lines of an example as they stand; all else is filled.
void write_footer(std::ostringstream& out, const std::string& footer) {
    std::istringstream lines(footer);
    bool is_example = false;
    for (std::string line; std::getline(lines, line);) {
        const bool is_indented = line.starts_with("  ");
        if (is_indented != is_example) {
            out << (is_indented ? ".PP\n.nf\n.RS 4\n" : ".RE\n.fi\n.PP\n");
            is_example = is_indented;
        }
        if (line.empty()) {
            continue;
        }
        out << roff(is_indented ? line.substr(2) : line) << "\n";
    }
    out << (is_example ? ".RE\n.fi\n" : "");
}

void write_option(std::ostringstream& out, const OptionInfo& option) {
    out << ".TP\n";
    if (!option.short_name.empty()) {
        out << bold(option.short_name) << ", ";
    }
    out << bold(option.long_name);
    if (!option.value.empty()) {
        out << " " << italic(option.value);
    }
    out << "\n" << roff(option.description) << "\n";
}

std::string synopsis(const CommandInfo& command, const std::string& path) {
    std::string text = bold(path);
    for (const ArgumentInfo& argument : command.arguments) {
        text += " " + italic(argument.name);
    }
    return text + (command.options.empty() ? "" : " [" + italic("options") + "]");
}

void write_command(std::ostringstream& out, const CommandInfo& command, const std::string& path) {
    out << ".SS " << roff(path) << "\n";
    out << synopsis(command, path) << "\n.PP\n" << roff(command.description) << ".\n";
    for (const ArgumentInfo& argument : command.arguments) {
        out << ".TP\n" << italic(argument.name) << "\n" << roff(argument.description) << "\n";
    }
    for (const OptionInfo& option : command.options) {
        write_option(out, option);
    }
    if (!command.footer.empty()) {
        out << ".PP\n";
        write_footer(out, command.footer);
    }
    for (const CommandInfo& below : command.commands) {
        write_command(out, below, path + " " + below.name);
    }
}

}  // namespace

std::string manual_page(const CommandInfo& program, const std::string& version) {
    std::ostringstream out;
    out << ".\\\" Made by 'carom manual'.\n"
        << ".TH CAROM 1 \"\" \"carom " << version << "\" \"User Commands\"\n"
        << ".SH NAME\ncarom \\- turn a billiard shot written in YAML into a film\n"
        << ".SH SYNOPSIS\n"
        << bold("carom") << " " << italic("command") << " [" << italic("options")
        << "]\n.SH DESCRIPTION\n";
    write_footer(out, program.description);
    out << ".PP\n"
        << "A shot is simulated once and baked into a timeline, which is then filmed as often as "
           "anyone likes.\n"
        << ".SH COMMANDS\n";
    for (const CommandInfo& command : program.commands) {
        write_command(out, command, "carom " + command.name);
    }
    out << ".SH OUTPUT AND EXIT STATUS\n";
    write_footer(out, program.footer);
    out << ".SH ENVIRONMENT\n"
        << ".TP\n\\fBCAROM_CACHE\\fR\nwhere bakes and finished frames are kept\n"
        << ".TP\n\\fBCAROM_CACHE_SIZE\\fR\nhow large it may grow\n"
        << ".TP\n\\fBCAROM_CONFIGS\\fR\na folder of tables, balls, looks, rigs and presets that is "
           "searched first\n"
        << ".TP\n\\fBOCIO\\fR\nthe OpenColorIO configuration of the view 'ocio'\n"
        << ".TP\n\\fBNO_COLOR\\fR\nno colours in messages\n";
    return out.str();
}

}  // namespace carom::cli
