#include "pipeline/cli/run_program.h"

#include <cerrno>
#include <new>
#include <optional>
#include <span>
#include <system_error>

#include <unistd.h>

#include "core/printable.h"
#include "core/write_all.h"
#include "pipeline/cli/terminal/interrupts.h"

namespace carom::cli {

namespace {

/// Says what an interruption leaves.
const char* interruption_message(const Command& command) {
    if (std::holds_alternative<RenderCommand>(command) ||
        std::holds_alternative<RetimeCommand>(command) ||
        std::holds_alternative<ContactSheetCommand>(command)) {
        return "interrupted; the finished frames are kept, and the same command resumes from there";
    }
    if (std::holds_alternative<CompareCommand>(command)) {
        return "interrupted; the results contain only what was measured by then";
    }
    return "interrupted; nothing was written";  // the command takes only seconds
}

ExitCode run_guarded(const Command& command, const CommandHandler& handler,
                     CommandContext& context) {
    Console& console = context.console;
    try {
        handler(command, context);
        return kDone;
    } catch (const Stopped&) {
        console.end_progress();
        console.warning(interruption_message(command));
        return kInterrupted;
    } catch (const InputError& error) {
        console.end_progress();
        console.error(error.what());
        return kWrongUsage;
    } catch (const Error& error) {
        console.end_progress();
        console.error(error.what());
    } catch (const std::bad_alloc&) {
        console.end_progress();
        console.error("there is not enough memory");
    } catch (const std::system_error& error) {  // a thread could not be started
        console.end_progress();
        console.error("the operating system cannot provide a resource, such as a thread: " +
                      error.code().message());
    } catch (const std::exception& error) {
        console.end_progress();
        console.error(std::string("internal error: ") + error.what());
    }
    return kFailed;
}

}  // namespace

ExitCode run_command(const CommandLine& line, const CommandHandler& handler) {
    Console console(console_on_stderr(line.logging.json, line.logging.quiet));
    std::optional<Interrupts> interrupts;
    try {
        interrupts.emplace(
            [&console] { console.warning("stopping; press Ctrl-C again to stop immediately"); });
    } catch (const std::exception& error) {
        console.error(error.what());
        return kFailed;
    }
    CommandContext context{console, interrupts->token()};
    return run_guarded(line.command, handler, context);
}

void print_text(const std::string& text) {
    if (!write_all(STDOUT_FILENO, std::as_bytes(std::span(text)))) {
        throw Error("cannot write to standard output: " + std::generic_category().message(errno));
    }
}

void print_path(const std::string& path) {
    print_text((isatty(STDOUT_FILENO) == 1 ? printable(path) : path) + "\n");
}

}  // namespace carom::cli
