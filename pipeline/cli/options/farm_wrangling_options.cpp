#include "pipeline/cli/options/farm_action_options.h"
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {
namespace {

using Action = FarmCommand::Action;

void describe_list(CommandDescription& description, FarmCommand& farm) {
    CommandDescription& list = description.command(
        "list", "Print all jobs of a store: owner, film, frames, time left and state.");
    list.chosen = [&farm] { farm.action = Action::list; };
    list.details = {
        "The newest is first. A job that cannot be read is printed with the reason. The other "
        "commands take the id in the first column, too."};
    add_store(list, farm);
    list.flag("--running", farm.is_running, "Only those that wait or run.");
    list.flag("--json", farm.json, "Print one JSON object.");
    list.examples = {{"carom farm list --running", "What is being rendered."}};
}

void describe_frames(CommandDescription& description, FarmCommand& farm) {
    CommandDescription& frames = add_action(
        description, farm, "frames",
        "Print a job's frames: state, node, time, memory, tries and worker.", Action::frames);
    frames.details = {"Of several of the options each names some of the frames to print."};
    frames.flag("--failed", farm.only_failed, "Those in which an attempt failed.");
    frames.flag("--slow", farm.only_slow, "Those that took more than twice the median time.");
    frames.flag("--missing", farm.only_missing, "Those that are not rendered yet.");
    frames.flag("--json", farm.json,
                "Print one JSON object, also with the nodes and each frame's log.");
    frames.examples = {{"carom farm frames break.mp4 --failed --slow", "Frames to look at."},
                       {"carom farm logs break.mp4 --frame 12", "What was printed meanwhile."}};
}

void describe_watch(CommandDescription& description, FarmCommand& farm) {
    CommandDescription& watch =
        description.command("watch", "Show the jobs of a store and their frames in a browser.");
    watch.chosen = [&farm] { farm.action = Action::watch; };
    watch.details = {
        "Starts a server that only this machine can reach, prints its address and opens it in a "
        "browser. The page shows what 'carom farm list' and 'carom farm frames' print, with a "
        "contact sheet and the frames of each hour, and keeps itself up to date.",
        "From another machine: ssh -L 8080:127.0.0.1:8080 HOST, with --port 8080 --no-browser on "
        "that machine. Ctrl-C ends the server."};
    add_store(watch, farm);
    add_page(watch, farm.page);
    watch.examples = {{"carom farm watch --store /shared/carom", "The farm in the browser."}};
}

CommandDescription& add_wish(CommandDescription& description, FarmCommand& farm, const char* name,
                             const char* summary, Action action) {
    CommandDescription& wish = add_action(description, farm, name, summary, action);
    wish.argument("FRAMES", farm.frames, "The frames: 12, 0-47, 0-47x2, 3,7,20-29.");
    return wish;
}

}  // namespace

void describe_wrangling(CommandDescription& description, FarmCommand& farm) {
    describe_list(description, farm);
    describe_frames(description, farm);
    describe_watch(description, farm);
    CommandDescription& retry =
        add_wish(description, farm, "retry", "Render frames of a job again.", Action::retry);
    retry.details = {
        "They are taken out of the store, and their failures are forgotten. Frames that are being "
        "rendered stay. A job that has ended goes on with 'carom farm resume'."};
    CommandDescription& skip = add_wish(
        description, farm, "skip", "Finish a job's film without waiting for frames.", Action::skip);
    skip.details = {
        "Where they are not there when the film is written, the nearest frame before them is "
        "shown, with a warning. 'carom farm retry' and --undo take this back."};
    skip.flag("--undo", farm.undo, "Wait for them again.");
    CommandDescription& prefer =
        add_wish(description, farm, "prefer", "Render frames of a job first.", Action::prefer);
    prefer.details = {"Instead of those that were named before."};
    prefer.flag("--undo", farm.undo, "Render them in their usual turn.");
}

}  // namespace carom::cli
