#include <sstream>

#include "core/text.h"
#include "pipeline/cli/help/completion.h"

namespace carom::cli {

namespace {

std::vector<std::string> names_of(const std::vector<CommandInfo>& commands) {
    std::vector<std::string> names;
    names.reserve(commands.size());
    for (const CommandInfo& command : commands) {
        names.push_back(command.name);
    }
    return names;
}

class BashWriter {
  public:
    std::string write(const CommandInfo& program) {
        describe(program, "");
        std::ostringstream out;
        out << "# bash completion for carom; made by 'carom completion bash'.\n"
            << "_carom_find() { mapfile -t COMPREPLY < <(compgen \"$@\"); }\n"
            << "_carom_files() { compopt -o filenames 2>/dev/null || :; _carom_find \"$@\"; }\n"
            << "_carom() {\n"
            << "    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]}\n"
            << "    local command='' word\n"
            << "    COMPREPLY=()\n"
            << "    for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
            << "        case \"$command $word\" in\n"
            << steps_.str() << "        esac\n"
            << "    done\n"
            << "    case \"$command $prev\" in\n"
            << values_.str() << "    esac\n"
            << "    case \"$command $cur\" in\n"
            << rest_.str() << "    esac\n"
            << "}\n"
            << "complete -F _carom carom\n";
        return out.str();
    }

  private:
    /// `path`: of the commands that lead to it, " render", " cache prune".
    void describe(const CommandInfo& command, const std::string& path) {
        std::vector<std::string> options;
        for (const OptionInfo& option : command.options) {
            std::string names = "'" + path + " " + option.long_name + "'";
            options.push_back(option.long_name);
            if (!option.short_name.empty()) {
                names += "|'" + path + " " + option.short_name + "'";
            }
            if (!option.value.empty()) {
                values_ << "        " << names << ") " << value_of(option) << "return ;;\n";
            }
        }
        for (const CommandInfo& below : command.commands) {
            const std::string way = path + " " + below.name;
            steps_ << "            '" << way << "') command='" << way << "' ;;\n";
            describe(below, way);
        }
        // After those below it, whose lines begin like its own.
        rest_ << "        '" << path << " -'*) _carom_find -W '" << join(options, " ")
              << "' -- \"$cur\" ;;\n        '" << path << " '*) ";
        if (!command.commands.empty()) {
            rest_ << "_carom_find -W '" << join(names_of(command.commands), " ")
                  << "' -- \"$cur\" ";
        } else if (!command.arguments.empty()) {
            rest_ << words_of(command.arguments.front());
        }
        rest_ << ";;\n";
    }

    static std::string value_of(const OptionInfo& option) {
        if (!option.choices.empty()) {
            return "_carom_find -W '" + join(option.choices, " ") + "' -- \"$cur\"; ";
        }
        if (option.takes_file()) {
            return "_carom_files -f -- \"$cur\"; ";
        }
        return option.takes_folder() ? "_carom_files -d -- \"$cur\"; " : "";
    }

    static std::string words_of(const ArgumentInfo& argument) {
        return argument.choices.empty()
                   ? "_carom_files -f -- \"$cur\" "
                   : "_carom_find -W '" + join(argument.choices, " ") + "' -- \"$cur\" ";
    }

    std::ostringstream steps_;   // which word leads to which command
    std::ostringstream values_;  // what follows an option
    std::ostringstream rest_;    // options, commands, files
};

}  // namespace

std::string bash_completion(const CommandInfo& program) {
    return BashWriter().write(program);
}

}  // namespace carom::cli
