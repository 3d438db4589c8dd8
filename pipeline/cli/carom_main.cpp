// bin/carom: reads the command line and runs what needs no renderer. For the rest it becomes
// libexec/carom/carom-film, which links OpenImageIO (200 ms to load) and libav.
#include <cstdio>
#include <string>
#include <vector>

#include <sys/resource.h>

#include "core/error.h"
#include "pipeline/cli/cache_command.h"
#include "pipeline/cli/check_command.h"
#include "pipeline/cli/command_line.h"
#include "pipeline/cli/helper_program.h"
#include "pipeline/cli/info_command.h"
#include "pipeline/cli/light_commands.h"
#include "pipeline/cli/new_command.h"
#include "pipeline/cli/overload.h"
#include "pipeline/cli/plan_command.h"
#include "pipeline/cli/report_command.h"
#include "pipeline/cli/schema_command.h"
#include "pipeline/cli/terminal/standard_descriptors.h"

namespace {

using namespace carom::cli;

/// With less the libraries of the renderer crash before it begins (OpenImageIO 2.4, log4cplus 2.0).
constexpr rlim_t kLeastAddressSpace = rlim_t{512} << 20;

bool has_address_space() {
    rlimit limit{};
    return ::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur >= kLeastAddressSpace;
}

/// Returns only if it fails.
int become_film_program(const std::string& name, char** arguments) {
    if (!has_address_space()) {
        std::fputs(
            "carom: error: there is not enough memory: the renderer's libraries need 512 MiB of "
            "address space, more than this process may have (ulimit -v)\n",
            stderr);
        return kFailed;
    }
    try {
        become_program(name, arguments);
    } catch (const carom::Error& error) {
        std::fprintf(stderr, "carom: error: %s\n", error.what());
    }
    return kFailed;
}

bool needs_renderer(const Command& command) {
    return std::holds_alternative<RenderCommand>(command) ||
           std::holds_alternative<RetimeCommand>(command) ||
           std::holds_alternative<FrameCommand>(command) ||
           std::holds_alternative<ContactSheetCommand>(command) ||
           std::holds_alternative<MuxCommand>(command);
}

void run(const Command& command, CommandContext& context) {
    std::visit(Overload{
                   [&](const CheckCommand& check) { run_check(check, context); },
                   [&](const BakeCommand& bake) { run_bake(bake, context); },
                   [&](const ExportCommand& export_) { run_export(export_, context); },
                   [&](const ReportCommand& report) { run_report(report, context); },
                   [&](const ImportCommand& scene) { run_import(scene, context); },
                   [](const CompletionCommand& shell) { run_completion(shell); },
                   [](const ManualCommand& manual) { run_manual(manual); },
                   [&](const ImportTrackCommand& track) { run_import_track(track, context); },
                   [&](const CacheCommand& cache) { run_cache(cache, context); },
                   [&](const PlanCommand& plan) { run_plan(plan, context); },
                   [&](const NewCommand& starter) { run_new(starter, context); },
                   [&](const InfoCommand& info) { run_info(info, context); },
                   [&](const SchemaCommand& schema) { run_schema(schema); },
                   [](const RenderCommand&) {},  // never here: needs_renderer
                   [](const RetimeCommand&) {},
                   [](const FrameCommand&) {},
                   [](const ContactSheetCommand&) {},
                   [](const MuxCommand&) {},
                   [](const CompareCommand&) {},
               },
               command);
}

}  // namespace

int main(int argument_count, char** arguments) {
    hold_standard_descriptors();
    const auto parsed = parse_command_line({arguments + 1, arguments + argument_count});
    if (const auto* nothing = std::get_if<NothingToRun>(&parsed)) {
        return print(*nothing);
    }
    const auto& line = std::get<CommandLine>(parsed);
    if (needs_renderer(line.command)) {
        return become_film_program("carom-film", arguments);
    }
    if (std::holds_alternative<CompareCommand>(line.command)) {
        return become_film_program("carom-lab", arguments);
    }
    return run_command(line, run);
}
