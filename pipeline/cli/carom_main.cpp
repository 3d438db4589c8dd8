// The program bin/carom: parses the command line and runs the commands that need no renderer. For
// all others it executes libexec/carom/carom-film, which links the renderer and libav.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <sys/resource.h>

#include "core/error.h"
#include "core/printable.h"
#include "pipeline/cli/command_line.h"
#include "pipeline/cli/completion.h"
#include "pipeline/cli/helper_program.h"
#include "pipeline/cli/manual_pages.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/terminal/standard_descriptors.h"

namespace {

using namespace carom::cli;

/// With less, the libraries of the renderer crash before it starts (OpenImageIO 2.4,
/// log4cplus 2.0).
constexpr rlim_t kMinAddressSpace = rlim_t{512} << 20;

bool has_address_space() {
    rlimit limit{};
    return ::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur >= kMinAddressSpace;
}

int report(const carom::Error& error) {
    std::fprintf(stderr, "carom: error: %s\n", carom::printable(error.what()).c_str());
    return kFailed;
}

/// Returns only if it fails.
int exec_other_program(const std::string& name, char** arguments) {
    if (!has_address_space()) {
        std::fputs(
            "carom: error: there is not enough memory: the renderer's libraries need 512 MiB of "
            "address space, more than the limit of this process (ulimit -v)\n",
            stderr);
        return kFailed;
    }
    try {
        exec_program(name, arguments);
    } catch (const carom::Error& error) {
        return report(error);
    }
}

/// Runs a command that is not in the help, because only the completion scripts and the build call
/// it, and returns its exit code. Empty for all other commands.
std::optional<int> run_hidden_command(const std::vector<std::string>& words) {
    if (!words.empty() && words.front() == "__complete") {
        return print({kDone, completion_lines({words.begin() + 1, words.end()}), ""});
    }
    if (words.size() == 2 && words.front() == "__manual") {
        try {
            write_manual(words.back());
        } catch (const carom::Error& error) {
            return report(error);
        }
        return kDone;
    }
    return std::nullopt;
}

}  // namespace

int main(int argument_count, char** arguments) {
    reserve_standard_descriptors();
    let_too_large_files_fail();
    const std::vector<std::string> words(arguments + 1, arguments + argument_count);
    if (const std::optional<int> exit_code = run_hidden_command(words)) {
        return *exit_code;
    }
    const auto parsed = parse_command_line(words);
    if (const auto* early_exit = std::get_if<EarlyExit>(&parsed)) {
        return print(*early_exit);
    }
    const auto& line = std::get<CommandLine>(parsed);
    if (const Program program = program_of(line.command); program != Program::carom) {
        return exec_other_program(program == Program::film  ? "carom-film"
                                  : program == Program::lab ? "carom-lab"
                                                            : "carom-studio",
                                  arguments);
    }
    std::optional<std::string> other;  // program that is needed, as the shot says
    const ExitCode exit_code =
        run_command(line, [&other](const Command& command, CommandContext& context) {
            try {
                run_here<Program::carom>(command, context);
            } catch (const NeedsProgram& needed) {
                other = needed.name();
            }
        });
    return other ? exec_other_program(*other, arguments) : exit_code;
}
