// The options of the commands that render, and of the command that writes a film of stored frames.
#include "pipeline/cli/options/shared_options.h"

namespace carom::cli {

namespace {

constexpr const char* kFilmFile =
    "The film (.mp4, .mov, .mkv, .webm, .avi) or pictures (shot.####.exr). The default is the "
    "shot's "
    "name in the current folder.";

}  // namespace

void describe(RenderCommand& command, CommandDescription& description) {
    description.details = {
        "Finished frames are stored in the cache. So an interrupted run resumes when the command "
        "is repeated, and after a change only the frames that it affects are rendered again."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_camera_file(description, command.input);
    add_output(description, command.output, kFilmFile);
    add_frames(description, command.frames);
    description.option("--chunk", &command.chunk, "K/N",
                       "Render only part K of N of the frames, such as 2/8, and write no film. Use "
                       "it to distribute a film over machines. 'carom mux' writes the film when "
                       "all parts are rendered.");
    add_dry_run(description, command.dry_run);
    add_tier(description);
    add_threads(description, command.threads);
    add_cache(description, command.cache);
    add_no_store(description, command.cache);
    add_cache_size(description, command.cache);
    description.examples = {
        {"carom render break.yaml --quality draft -o try.mp4", "A quick look at the film."},
        {"carom render break.yaml --frames 0-47 -o start.mp4", "Only its first 48 frames."},
        {"carom render break.yaml --set render.samples=256", "The film with less noise."}};
}

void describe(RetimeCommand& command, CommandDescription& description) {
    description.details = {
        "The cameras follow the same paths as in the original film. If the cache has the bake, the "
        "shot is not simulated again, and frames in the cache are not rendered again."};
    RenderCommand& render = command.render;
    add_input(description, render.input);
    add_changes(description, render.input);
    add_retime_words(description, command.retime);
    add_camera_file(description, render.input);
    add_output(description, render.output,
               "The film. The default is the shot's name and _retimed in the current folder.");
    add_frames(description, render.frames);
    add_dry_run(description, render.dry_run);
    add_tier(description);
    add_threads(description, render.threads);
    add_cache(description, render.cache);
    add_no_store(description, render.cache);
    add_cache_size(description, render.cache);
    description.examples = {
        {"carom retime break.yaml --speed 1/8 --from 1.2s --to 2s -o slow.mp4",
         "A part of the shot, eight times slower."},
        {"carom retime break.bake --reverse -o back.mp4", "The whole shot backwards."}};
}

void describe(SoundCommand& command, CommandDescription& description) {
    description.details = {
        "The sound follows from the shot's motion and its cameras, in less time than it takes to "
        "hear it, and is mixed with the film's music; no frame is rendered. A .wav and a .flac "
        "file have "
        "all bits, with 24 a sample.",
        "With --heard, --stems or --report, the file with the whole sound is only written if -o "
        "names it."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_retime_words(description, command.retime);
    add_camera_file(description, command.input);
    add_output(description, command.output,
               "The sound: .wav, .flac, .m4a, .opus or .mka. The default is the shot's name and "
               ".wav.");
    description
        .option("--stems", &command.stems, "FOLDER",
                "Also write a file for each group of sounds: balls, cushions, cloth, stick, "
                "pockets, objects, rolling, and the music. Their sum is the film's sound.")
        .offers(Offer::files);
    description
        .option("--heard", &command.heard, "FILE",
                "Also write a table (.csv) of every impact that is heard: when, what, from how far "
                "and how loud.")
        .offers(Offer::files);
    description.flag("--report", command.report,
                     "Print the loudness, the true peak and the ten loudest impacts.");
    add_cache(description, command.cache);
    description.examples = {
        {"carom sound break.yaml -o break.wav", "The sound of the whole film."},
        {"carom sound break.yaml --speed 1/8 --from '{strike: cue}' -o slow.flac",
         "The same, eight times slower, from the strike on."},
        {"carom sound break.yaml --heard heard.csv --report", "What is heard, and how loud."}};
}

void describe(FrameCommand& command, CommandDescription& description) {
    add_input(description, command.input);
    add_changes(description, command.input);
    add_camera_file(description, command.input);
    description
        .option("--frame", &command.frame, "N", "The frame's number, counted from 0 (the default).")
        .from(0);
    description
        .option("--at", &command.at, "TIME",
                "The frame's time in the film: 1.25s or 500ms. A moment, such as '{contact: "
                "[cue, one]}', is the first frame that shows it.")
        .excludes({"--frame"});
    add_output(description, command.output,
               "The picture: .png, .jpg, .bmp or .tga as the film shows it, .exr as it was "
               "computed. The default is the shot's name, the frame's number and .png.");
    add_tier(description);
    add_threads(description, command.threads);
    add_cache(description, command.cache);
    add_no_store(description, command.cache);
    description.examples = {
        {"carom frame break.yaml --at 1.25s -o contact.png", "The frame of the film at 1.25 s."},
        {"carom frame break.yaml --at '{potted: nine}'", "The frame in which the nine is potted."},
        {"carom frame break.yaml --frame 40 --quality draft",
         "Frame 40 with few samples, as break.0040.png."}};
}

void describe(ContactSheetCommand& command, CommandDescription& description) {
    description.details = {
        "The frames have draft quality unless --quality is given. Each is labelled with its "
        "number, "
        "its scene time and its camera. The frames are stored in the cache like those of a film."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_camera_file(description, command.input);
    add_output(description, command.output,
               "The picture: .png, .jpg, .bmp or .tga. The default is the shot's name and "
               "_sheet.png.");
    description
        .option("--count", &command.count, "N",
                "The number of frames, evenly distributed over the film (default 12).")
        .between(1, 400);
    description
        .option("--columns", &command.columns, "N", "The number of frames in a row (default 4).")
        .between(1, 40);
    description
        .option("--width", &command.width, "N", "The width of each frame in pixels (default 320).")
        .between(32, 2000);
    add_tier(description);
    add_threads(description, command.threads);
    add_cache(description, command.cache);
    add_no_store(description, command.cache);
    description.examples = {{"carom contact-sheet break.yaml -o sheet.png",
                             "Twelve frames of the film in one picture."}};
}

void describe(MuxCommand& command, CommandDescription& description) {
    description.details = {
        "This command renders nothing. If frames are missing, it lists them and ends with exit "
        "code 1."};
    add_input(description, command.input);
    add_changes(description, command.input);
    add_camera_file(description, command.input);
    add_output(description, command.output, kFilmFile);
    add_frames(description, command.frames);
    description.flag("--so-far", command.so_far,
                     "Write the film although frames are missing: each shows the last rendered one "
                     "before it.");
    add_tier(description);
    add_cache(description, command.cache);
    description.examples = {
        {"carom render break.yaml --chunk 1/2 && carom render break.yaml --chunk 2/2",
         "Render the frames in two parts, perhaps on two machines that share a cache."},
        {"carom mux break.yaml -o break.mp4", "Write the film from these frames."}};
}

}  // namespace carom::cli
