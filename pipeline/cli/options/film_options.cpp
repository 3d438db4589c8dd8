// Commands that render, and the film of stored frames.
#include "pipeline/cli/options/command_options.h"
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

void add_render(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("render", "simulate, render and encode a shot");
    RenderCommand& render = targets.render;
    add_input(command, render.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_camera_file(command, render.input);
    add_output(
        command, render.output,
        "the film: .mp4, .mov, .mkv, .webm, or pictures: shot.####.exr (else the shot's name "
        "in the current folder)");
    add_frames(command, render.frames);
    command
        .add_option("--chunk", render.chunk,
                    "one of several machines' share of them, 2/8: renders and keeps its frames, "
                    "writes no film; 'carom mux' does when all are there")
        ->option_text("K/N");
    add_dry_run(command, render.dry_run);
    add_threads(command, render.threads);
    add_cache(command, render.cache);
    add_cache_size(command, render.cache);
    add_talk(command, targets);
    command.footer(example("  carom render break.yaml --quality draft -o try.mp4\n") +
                   "\nFinished frames are kept: a run that was interrupted goes on where it was\n"
                   "when it is repeated, and a film that changes in part renders only that part.");
}

namespace {

void add_retime_times(CLI::App& command, RetimeCommand& retime) {
    command
        .add_option("--speed", retime.speed,
                    "seconds of the scene per second of film: 0.125 or 1/8 (else as it was)")
        ->option_text("RATIO");
    command.add_option("--from", retime.from, "scene time to begin with (else all is shown)")
        ->option_text("TIME");
    command.add_option("--to", retime.to, "scene time to end with")->option_text("TIME");
    command.add_flag("--reverse", retime.reverse, "backwards");
    command
        .add_option("--ramp", retime.ramp,
                    "changing speed: film times and speeds, 0s:1,1s:1/8,3s:1/8,4s:1; the last "
                    "time is the film's length")
        ->option_text("T:V,...");
    command.add_option("--easing", retime.easing, "of the ramp: smooth (the default) or linear")
        ->option_text("NAME")
        ->check(CLI::IsMember({"smooth", "linear"}));
    command.add_option("--rig", retime.rig, "show only what this camera of the shot films")
        ->option_text("NAME");
}

}  // namespace

void add_retime(CLI::App& app, Targets& targets) {
    CLI::App& command =
        *app.add_subcommand("retime", "film a shot again: slower, backwards, a part of it");
    RetimeCommand& retime = targets.retime;
    RenderCommand& render = retime.render;
    add_input(command, render.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_retime_times(command, retime);
    add_camera_file(command, render.input);
    add_output(command, render.output,
               "the film (else the shot's name and _retimed in the current folder)");
    add_frames(command, render.frames);
    add_dry_run(command, render.dry_run);
    add_threads(command, render.threads);
    add_cache(command, render.cache);
    add_cache_size(command, render.cache);
    add_talk(command, targets);
    command.footer(
        example("  carom retime break.yaml --speed 1/8 --from 1.2s --to 2s -o slow.mp4\n"
                "  carom retime break.bake --reverse -o back.mp4\n") +
        "\nThe cameras go the ways that they went in the film. A shot whose bake was kept\n"
        "is not simulated again, and frames that the film had are not rendered again.");
}

void add_frame(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("frame", "render one frame of a shot");
    FrameCommand& frame = targets.frame;
    add_input(command, frame.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_camera_file(command, frame.input);
    CLI::Option* number =
        command.add_option("--frame", frame.frame, "its number, counted from 0 (the default)")
            ->option_text("N")
            ->check(CLI::NonNegativeNumber);
    command.add_option("--at", frame.at, "or its time in the film: 1.25s, 500ms")
        ->option_text("TIME")
        ->excludes(number);
    add_output(command, frame.output,
               "the picture: .png, .jpg, .bmp or .tga as the film shows it, .exr as it was "
               "computed (else the shot's name, the frame's number and .png)");
    add_threads(command, frame.threads);
    add_cache(command, frame.cache);
    add_talk(command, targets);
    command.footer(example("  carom frame break.yaml --at 1.25s -o contact.png"));
}

void add_contact_sheet(CLI::App& app, Targets& targets) {
    CLI::App& command =
        *app.add_subcommand("contact-sheet", "a film at a glance: frames of it in a grid");
    ContactSheetCommand& sheet = targets.sheet;
    add_input(command, sheet.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_camera_file(command, sheet.input);
    add_output(command, sheet.output,
               "the picture: .png, .jpg, .bmp or .tga (else the shot's name and _sheet.png)");
    command.add_option("--count", sheet.count, "how many frames, evenly spread (default 12)")
        ->option_text("N")
        ->check(CLI::Range(1, 400));
    command.add_option("--columns", sheet.columns, "side by side (default 4)")
        ->option_text("N")
        ->check(CLI::Range(1, 40));
    command.add_option("--width", sheet.width, "of each, in pixels (default 320)")
        ->option_text("N")
        ->check(CLI::Range(32, 2000));
    add_threads(command, sheet.threads);
    add_cache(command, sheet.cache);
    add_talk(command, targets);
    command.footer(example("  carom contact-sheet break.yaml -o sheet.png") +
                   "\nDraft frames unless --quality says otherwise, each with its number, the\n"
                   "time that it shows and its camera. They are kept like those of a film.");
}

void add_mux(CLI::App& app, Targets& targets) {
    CLI::App& command = *app.add_subcommand("mux", "write a film from frames that are stored");
    MuxCommand& mux = targets.mux;
    add_input(command, mux.input, "SHOT|BAKE", "a shot, or a bake to film as it is");
    add_camera_file(command, mux.input);
    add_output(
        command, mux.output,
        "the film: .mp4, .mov, .mkv, .webm, or pictures: shot.####.exr (else the shot's name "
        "in the current folder)");
    add_frames(command, mux.frames);
    add_cache(command, mux.cache);
    add_talk(command, targets);
    command.footer(example("  carom render break.yaml --chunk 1/2 && carom render break.yaml "
                           "--chunk 2/2\n  carom mux break.yaml -o break.mp4") +
                   "\nRenders nothing: frames that are missing are named, with exit code 1.");
}

}  // namespace carom::cli
