// The options of carom farm.
#include "pipeline/cli/options/farm_action_options.h"
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {
void add_store(CommandDescription& description, FarmCommand& farm) {
    description
        .option("--store", &farm.store, "DIR",
                "The folder of bakes, frames and jobs. All machines have to see it under this "
                "name. The default is the cache.")
        .offers(Offer::folders);
}

/// A subcommand for a job that exists.
CommandDescription& add_action(CommandDescription& description, FarmCommand& farm, const char* name,
                               const char* summary, FarmCommand::Action action) {
    CommandDescription& added = description.command(name, summary);
    added.chosen = [&farm, action] { farm.action = action; };
    added.argument(
        "JOB", farm.job,
        "The film, the job's folder, its id from 'carom farm list' or a number in the queue.");
    add_store(added, farm);
    return added;
}

namespace {

/// What can be changed later.
void add_changeable(CommandDescription& submit, FarmCommand& farm) {
    submit.option(
        "--time", &farm.time, "TIME",
        "The time limit of a task: 90min, 2h. The default is what the budget and the last frame "
        "need. It is raised if tasks need longer.");
    submit.option("--mem", &farm.memory, "SIZE",
                  "The memory of a worker: 2GB, or auto (the default) for what the film needs. It "
                  "is raised if workers need more.");
    submit
        .option("--workers", &farm.workers, "N",
                "The number of workers. The default uses the budget of each.")
        .between(1, 10000);
    submit
        .option("--priority", &farm.priority, "N",
                "Tasks with a higher number begin sooner (default 0). Slurm lets operators alone "
                "go above 0.")
        .between(-100000, 100000);
    submit.option("--", &farm.engine_options, "OPTIONS",
                  "All words after -- are options for sbatch (or qsub): -- --qos=high.");
}

void add_cluster(CommandDescription& submit, FarmCommand& farm) {
    submit.option("--partition", &farm.partition, "NAME", "The partition, or queue.");
    submit.option("--account", &farm.account, "NAME", "The account that pays.");
    submit.option("--cpus", &farm.processors, "N", "The processors of a worker (default 1).")
        .between(1, 1024);
    add_tier(submit);
    submit
        .option("--tasks-at-once", &farm.tasks_at_once, "N",
                "At most so many workers run at a time. The default is as many as there is room "
                "for.")
        .between(1, 10000);
    submit.option("--budget", &farm.budget, "TIME",
                  "A worker begins no frame after this time: short tasks find room sooner. The "
                  "default is 10 min with slurm and pbs; else there is no limit.");
    submit.option("--dead-after", &farm.dead_after, "TIME",
                  "A worker whose heartbeat stands still for so long is dead, and another renders "
                  "its frame (default 30 s).");
    submit.option("--exec-after", &farm.exec_after, "COMMAND",
                  "Run this with /bin/sh, once, when the film is there, which CAROM_FILM names.");
    add_changeable(submit, farm);
}

void describe_submit(CommandDescription& description, FarmCommand& farm) {
    CommandDescription& submit =
        description.command("submit", "Simulate a shot and render its film on a cluster.");
    submit.chosen = [&farm] { farm.action = FarmCommand::Action::submit; };
    submit.details = {
        "The shot is simulated once. Then workers render the frames, each the next one that nobody "
        "has, and a last task writes the film. If frames are missing then, it asks for workers "
        "again. The film has the same bytes as one of 'carom render'.",
        "The result is the job's folder and the numbers of its two jobs in Slurm's queue."};
    add_input(submit, farm.input);
    add_changes(submit, farm.input);
    add_camera_file(submit, farm.input);
    add_output(submit, farm.output,
               "The film. The default is the shot's name in the current folder.");
    add_frames(submit, farm.frames);
    add_store(submit, farm);
    add_cluster(submit, farm);
    submit.flag("--shared", farm.is_shared,
                "Others may read the job's folder; without it only its owner may.");
    submit.option("--group", &farm.group, "GROUP",
                  "Share the store with this group of users, now and from now on: its members may "
                  "use and replace all frames and bakes, and read the folders of jobs.");
    submit.flag("--dry-run", farm.dry_run, "Only print what would be submitted.");
    submit.flag("--wait", farm.wait, "Show the progress until the film is there.");
    submit.examples = {{"carom farm submit break.yaml -o break.mp4 --partition short --wait",
                        "The film, made by a cluster."}};
}

void describe_export(CommandDescription& description, FarmCommand& farm) {
    CommandDescription& exported = description.command(
        "export", "Write a film's job to a folder, to be run elsewhere or without Slurm.");
    exported.chosen = [&farm] { farm.action = FarmCommand::Action::export_job; };
    exported.details = {
        "The folder has the simulated shot, scripts, a README and a recipe for a container; frames "
        "and film will be in it."};
    add_input(exported, farm.input);
    add_changes(exported, farm.input);
    add_camera_file(exported, farm.input);
    exported
        .option(
            "--format", &farm.format, "NAME",
            "What runs the job: slurm (the default), parallel (GNU parallel), k8s (Kubernetes), "
            "openjd (Open Job Description) or pbs.")
        .one_of({"slurm", "parallel", "k8s", "openjd", "pbs"});
    exported.option("-o,--output", &farm.folder, "DIR", "The folder, which must not exist yet.")
        .is_required = true;
    add_frames(exported, farm.frames);
    add_cluster(exported, farm);
    exported.examples = {{"carom farm export break.yaml --format parallel -o break_job",
                          "A folder whose run.sh renders the film with GNU parallel."}};
}

}  // namespace

void describe(FarmCommand& command, CommandDescription& description) {
    using Action = FarmCommand::Action;
    description.details = {
        "The machines share one folder (--store). All commands can be given on any of them."};
    describe_submit(description, command);
    describe_export(description, command);
    CommandDescription& status =
        add_action(description, command, "status", "Print how far a job is.", Action::status);
    status.flag("--json", command.json, "Print one JSON object.");
    status
        .option("--sheet", &command.sheet, "FILE",
                "Also write a picture with frames of the film so far: .png or .jpg.")
        .offers(Offer::files, {"png", "jpg"});
    status.flag("--wait", command.wait, "Show the progress until the film is there.");
    status.examples = {{"carom farm status break.mp4", "The workers and their frames."}};
    describe_wrangling(description, command);
    add_action(description, command, "cancel", "Stop a job; its frames are kept.", Action::cancel);
    CommandDescription& change = add_action(
        description, command, "change",
        "Change the limits, the priority or the number of a job's tasks.", Action::change);
    change.details = {
        "Tasks that wait are submitted again with the change; those that run keep what they have."};
    add_changeable(change, command);
    CommandDescription& logs =
        add_action(description, command, "logs", "Print the ends of a job's logs.", Action::logs);
    logs.option("--lines", &command.lines, "N", "So many lines of each (default 20).")
        .between(1, 100000);
    logs.option("--frame", &command.frame, "N",
                "Print what was printed while this frame was rendered, at each attempt.")
        .from(0);
    add_action(description, command, "resume", "Submit a job again that was stopped or has failed.",
               Action::resume);
    add_action(description, command, "work", "Be a worker of a job; its tasks do this.",
               Action::work);
    add_action(description, command, "finish",
               "Write a job's film if all frames are there; its last task does this.",
               Action::finish);
    description.examples = {{"carom farm submit break.yaml -o break.mp4", "Submit a film."},
                            {"carom farm status break.mp4", "See how far it is."}};
}

}  // namespace carom::cli
