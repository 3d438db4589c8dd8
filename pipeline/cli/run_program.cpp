#include "pipeline/cli/run_program.h"

#include <cerrno>
#include <new>
#include <optional>
#include <span>
#include <system_error>

#include <unistd.h>

#include "core/printable.h"
#include "core/write_all.h"
#include "pipeline/camera/no_view.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/standard_input.h"
#include "pipeline/cli/terminal/interrupts.h"
#include "pipeline/solve/answers.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/cache_folder.h"

namespace carom::cli {

namespace {

bool stores_nothing(const Command& command) {
    return std::visit(
        []<class T>(const T& chosen) {
            if constexpr (requires { chosen.cache.no_store; }) {
                return chosen.cache.no_store;
            } else if constexpr (requires { chosen.render.cache.no_store; }) {
                return chosen.render.cache.no_store;
            } else {
                return false;
            }
        },
        command);
}

/// Strikes of `solve` are found in the cache of the command, or with its progress and its end.
void set_answers(Command& command, CommandContext& context) {
    const auto set = [&](InputOptions& input, const CacheOptions& cache) {
        auto work = std::make_shared<pipeline::solve::AnswerWork>();
        try {
            work->folder.path = pipeline::answers_folder(
                cache.folder.empty() ? pipeline::default_cache_folder() : cache.folder);
        } catch (const pipeline::CacheUnusable&) {
            // Then nothing is kept.
        }
        work->folder.is_read_only = cache.no_store;
        work->parts.context = {progress_on(context.console, "solve"), context.stop};
        input.answers = std::move(work);
    };
    std::visit(
        [&]<class T>(T& chosen) {
            if constexpr (requires {
                              chosen.input;
                              chosen.cache;
                          }) {
                set(chosen.input, chosen.cache);
            } else if constexpr (requires { chosen.input; }) {
                set(chosen.input, {});
            } else if constexpr (requires { chosen.render.input; }) {
                set(chosen.render.input, chosen.render.cache);
            }
        },
        command);
}

/// Whether the command has the option --no-store.
bool can_do_without_a_store(const Command& command) {
    return std::holds_alternative<RenderCommand>(command) ||
           std::holds_alternative<RetimeCommand>(command) ||
           std::holds_alternative<FrameCommand>(command) ||
           std::holds_alternative<ContactSheetCommand>(command);
}

/// Says what an interruption leaves.
const char* interruption_message(const Command& command) {
    if (stores_nothing(command)) {
        return "interrupted; nothing was stored";
    }
    if (std::holds_alternative<RenderCommand>(command) ||
        std::holds_alternative<RetimeCommand>(command) ||
        std::holds_alternative<ContactSheetCommand>(command)) {
        return "interrupted; the finished frames are kept, and the same command resumes from there";
    }
    if (std::holds_alternative<CompareCommand>(command)) {
        return "interrupted; the results contain only what was measured by then";
    }
    if (std::holds_alternative<SolveCommand>(command)) {
        return "interrupted; the search is not complete";
    }
    if (std::holds_alternative<SweepCommand>(command)) {
        return "interrupted; what was written has only the variants that were finished";
    }
    return "interrupted; nothing was written";  // the command takes only seconds
}

ExitCode run_guarded(const Command& command, const CommandHandler& handler,
                     CommandContext& context) {
    Console& console = context.console;
    const auto refuse = [&](const Error& error) {
        console.end_progress();
        console.error(error.what());
        return kWrongUsage;
    };
    try {
        check_not_input(command);
        handler(command, context);
        return kDone;
    } catch (const Stopped&) {
        console.end_progress();
        console.warning(interruption_message(command));
        return kInterrupted;
    } catch (const InputError& error) {
        return refuse(error);
    } catch (const pipeline::NoView& error) {  // only known when the motion is
        return refuse(error);
    } catch (const TryAgain& error) {
        console.end_progress();
        console.error(error.what());
        return kTryAgain;
    } catch (const OutOfTime& error) {
        console.end_progress();
        console.warning(error.what());
        return kOutOfTime;
    } catch (const OutOfMemory& error) {
        console.end_progress();
        console.error(error.what());
        return kOutOfMemory;
    } catch (const OutputClosed&) {
        console.end_progress();
    } catch (const pipeline::CacheUnusable& error) {
        console.end_progress();
        console.error(std::string(error.what()) + (can_do_without_a_store(command)
                                                       ? "; --no-store renders without a cache"
                                                       : ""));
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
    Command command = line.command;
    try {
        // Before signals are handled, so that Ctrl-C ends the wait for input.
        take_standard_input(command);
    } catch (const Error& error) {
        console.error(error.what());
        return kWrongUsage;
    }
    std::optional<Interrupts> interrupts;
    try {
        interrupts.emplace(
            [&console] { console.warning("stopping; press Ctrl-C again to stop immediately"); });
    } catch (const std::exception& error) {
        console.error(error.what());
        return kFailed;
    }
    CommandContext context{console, interrupts->token()};
    set_answers(command, context);
    return run_guarded(command, handler, context);
}

void print_text(const std::string& text) {
    if (!write_all(STDOUT_FILENO, std::as_bytes(std::span(text)))) {
        if (errno == EPIPE) {
            throw OutputClosed();
        }
        throw Error("cannot write to standard output: " + std::generic_category().message(errno));
    }
}

void print_path(const std::string& path) {
    print_text((isatty(STDOUT_FILENO) == 1 ? printable(path) : path) + "\n");
}

}  // namespace carom::cli
