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

const char* what_interruption_leaves(const Command& command) {
    if (std::holds_alternative<RenderCommand>(command)) {
        return "interrupted; the frames that were finished are kept, and the same command goes on "
               "from there";
    }
    if (std::holds_alternative<CompareCommand>(command)) {
        return "interrupted; what was measured until then is all that there is";
    }
    return "interrupted; nothing was written";  // over in seconds
}

ExitCode run_guarded(const Command& command, const CommandHandler& handler,
                     CommandContext& context) {
    Console& console = context.console;
    try {
        handler(command, context);
        return kDone;
    } catch (const Stopped&) {
        console.end_progress();
        console.warning(what_interruption_leaves(command));
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
    } catch (const std::system_error& error) {  // of a thread that cannot be started
        console.end_progress();
        console.error("the system gives no more: " + error.code().message());
    } catch (const std::exception& error) {
        console.end_progress();
        console.error(std::string("this should not happen: ") + error.what());
    }
    return kFailed;
}

}  // namespace

ExitCode run_command(const CommandLine& line, const CommandHandler& handler) {
    Console console(console_on_stderr(line.logging.json, line.logging.quiet));
    std::optional<Interrupts> interrupts;
    try {
        interrupts.emplace(
            [&console] { console.warning("stopping; a second Ctrl-C stops at once"); });
    } catch (const std::exception& error) {
        console.error(std::string("signals cannot be watched: ") + error.what());
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
