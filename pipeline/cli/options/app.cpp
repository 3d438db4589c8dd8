#include "pipeline/cli/options/app.h"

#include "pipeline/cli/help_formatter.h"
#include "pipeline/cli/options/command_options.h"

namespace carom::cli {

namespace {

// The help begins with what most people came for.
constexpr const char* kFirstLines =
    "  carom render shot.yaml -o film.mp4     simulate, render and encode a shot\n"
    "  carom check shot.yaml                  say everything that is wrong with it\n"
    "  carom frame shot.yaml --at 1.5s        one picture of it\n";

constexpr const char* kLastLines =
    "Results go to standard output, all talk to standard error.\n"
    "Exit codes: 0 done, 1 failed while running, 2 wrong usage or input,\n"
    "130 interrupted.\n"
    "'carom COMMAND --help' explains a command.";

}  // namespace

std::unique_ptr<CLI::App> make_app(Targets& targets) {
    auto owned = std::make_unique<CLI::App>(kFirstLines, "carom");
    CLI::App& app = *owned;
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_help_flag("-h,--help", "print this help");
    app.set_version_flag("--version", "carom " CAROM_VERSION, "print the version");
    app.require_subcommand(1);
    app.footer(kLastLines);
    add_render(app, targets);
    add_retime(app, targets);
    add_bake(app, targets);
    add_frame(app, targets);
    add_contact_sheet(app, targets);
    add_check(app, targets);
    add_info(app, targets);
    add_export(app, targets);
    add_report(app, targets);
    add_plan(app, targets);
    add_new(app, targets);
    add_schema(app, targets);
    add_import(app, targets);
    add_import_track(app, targets);
    add_mux(app, targets);
    add_compare(app, targets);
    add_cache_actions(app, targets);
    add_completion(app, targets);
    add_manual(app, targets);
    return owned;
}

Command chosen_command(const CLI::App& app, Targets& targets) {
    const std::string name = app.get_subcommands().front()->get_name();
    if (name == "render") {
        return std::move(targets.render);
    }
    if (name == "retime") {
        return std::move(targets.retime);
    }
    if (name == "bake") {
        return std::move(targets.bake);
    }
    if (name == "frame") {
        return std::move(targets.frame);
    }
    if (name == "info") {
        return std::move(targets.info);
    }
    if (name == "contact-sheet") {
        return std::move(targets.sheet);
    }
    if (name == "check") {
        return std::move(targets.check);
    }
    if (name == "report") {
        return std::move(targets.report);
    }
    if (name == "new") {
        return std::move(targets.new_);
    }
    if (name == "schema") {
        return std::move(targets.schema);
    }
    if (name == "plan") {
        return std::move(targets.plan);
    }
    if (name == "mux") {
        return std::move(targets.mux);
    }
    if (name == "cache") {
        return std::move(targets.cache);
    }
    if (name == "import") {
        return std::move(targets.import_);
    }
    if (name == "completion") {
        return std::move(targets.completion);
    }
    if (name == "manual") {
        return std::move(targets.manual);
    }
    if (name == "compare") {
        return std::move(targets.compare);
    }
    if (name == "import-track") {
        return std::move(targets.import_track);
    }
    return std::move(targets.export_);
}

}  // namespace carom::cli
