#include "pipeline/cli/sound_command.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/film_music.h"
#include "pipeline/cli/heard_table.h"
#include "pipeline/cli/job_observer.h"
#include "pipeline/cli/named_files.h"
#include "pipeline/cli/output_file.h"
#include "pipeline/cli/retime_words.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/sequence/load_sequence.h"
#include "pipeline/sequence/sequence_scene.h"
#include "pipeline/sound/film_scene.h"
#include "pipeline/sound/loudness_note.h"
#include "sound/file/wav_file.h"
#include "sound/sound_scene.h"

namespace carom::cli {

namespace {

namespace fs = std::filesystem;

/// The sound of a film, and all that it refers to.
struct FilmInput {
    std::optional<ShotInput> shot;
    std::optional<pipeline::Sequence> sequence;
    std::map<std::size_t, sim::Bake> bakes;  // of a shot: number 0
    sound::SoundScene scene;
    sound::AddedSound music;
};

[[noreturn]] void refuse_silence(const SoundCommand& command) {
    throw InputError("'" + command.input.path +
                     "' says 'sound: none' and has no music, so its film is silent");
}

void read_sequence(const SoundCommand& command, CommandContext& context, FilmInput& film) {
    if (changes_film(command.retime)) {
        throw InputError(
            "a film of several shots cannot be filmed again at another speed; give "
            "one of its shots");
    }
    if (const auto loaded = load_sequence_input(command.input); loaded.sequence) {
        require_film_program(loaded.sequence->output.music.has_value(), context);
    }
    film.sequence = read_sequence_input(command.input, context.console);
    std::vector<pipeline::SequencePart>& parts = film.sequence->parts;
    std::map<std::size_t, const sim::Timeline*> timelines;
    const auto is_silent = [](const pipeline::SequencePart& part) {
        const auto* shot = std::get_if<pipeline::ShotPart>(&part.content);
        return shot == nullptr || shot->shot.sound.is_silent;
    };
    if (std::ranges::all_of(parts, is_silent) && !film.sequence->output.music) {
        refuse_silence(command);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (auto* part = std::get_if<pipeline::ShotPart>(&parts[i].content)) {
            ShotInput input = input_of(*part);
            film.bakes[i] = obtain_bake(input, InputOptions{part->path, {}, {}, {}, {}},
                                        command.cache, context);
            take_back(std::move(input), *part);
            timelines[i] = &film.bakes[i].timeline;
        }
    }
    film.scene = pipeline::sequence_scene(*film.sequence, timelines, 0, film.sequence->frames());
    film.music = film_music(film.sequence->output, film.scene.frames, context);
}

void read_shot(const SoundCommand& command, CommandContext& context, FilmInput& film) {
    pipeline::RetimeOptions options = parse_retime(command.retime);
    CheckedInput checked = load_shot_input(command.input);
    if (checked.input) {
        require_film_program(checked.input->shot.output.music.has_value(), context);
    }
    film.shot = require_shot_input(std::move(checked), command.input, context.console);
    if (film.shot->shot.sound.is_silent && !film.shot->shot.output.music) {
        refuse_silence(command);
    }
    film.bakes[0] = obtain_bake(*film.shot, command.input, command.cache, context);
    if (changes_film(command.retime)) {
        if (names_moments(command.retime)) {
            film.shot->bake = film.bakes[0];
        }
        retime(command.retime, std::move(options), *film.shot);
    }
    const pipeline::Shot& shot = film.shot->shot;
    film.scene = pipeline::film_scene(shot, film.bakes[0].timeline, 0,
                                      pipeline::frame_count(shot.cameras, shot.timing));
    film.music = film_music(*film.shot, film.scene.frames, context);
}

void read_film(const SoundCommand& command, CommandContext& context, FilmInput& film) {
    if (is_sequence(command.input)) {
        read_sequence(command, context, film);
    } else {
        read_shot(command, context, film);
    }
}

/// Passes all samples to the file, if there is one.
void copy_all(sound::FilmSound& source, SoundFile* file, const WorkContext& work) {
    source.read_rest(work, [file](std::span<const double> left, std::span<const double> right) {
        if (file != nullptr) {
            file->write(left, right);
        }
    });
    if (file != nullptr) {
        file->finish();
    }
}

/// Writes a file for each group, and one for the music. Together they are the film's sound.
void write_stems(const SoundCommand& command, const FilmInput& film, const sound::FilmGain& gain,
                 const WorkContext& work, const SoundFileMaker& make) {
    const std::string extension =
        command.output.empty() ? ".wav" : fs::path(command.output).extension().string();
    fs::create_directories(command.stems);
    const auto write = [&](const std::string& name, sound::FilmSoundOptions options) {
        options.added = film.music;
        options.gain = gain;
        sound::FilmSound stem(film.scene, options, work);
        const std::string path = (fs::path(command.stems) / (name + extension)).string();
        copy_all(stem, make(path, stem.frames()).get(), work);
        print_path(path);
    };
    for (std::size_t i = 0; i < sound::kGroupCount; ++i) {
        write(std::string(sound::kGroupNames[i]), {.only = static_cast<sound::Group>(i)});
    }
    if (film.music) {
        write("music", {.only_added = true});
    }
}

class WavSoundFile final : public SoundFile {
  public:
    WavSoundFile(const std::string& path, std::int64_t samples) : file_(path, samples) {}
    void write(std::span<const double> left, std::span<const double> right) override {
        file_.write(left, right);
    }
    void finish() override { file_.finish(); }

  private:
    sound::WavFile file_;
};

}  // namespace

bool needs_encoder(const SoundCommand& command) {
    const std::string extension = fs::path(command.output).extension().string();
    return !command.output.empty() && extension != ".wav";
}

std::unique_ptr<SoundFile> make_wav_file(const std::string& path, std::int64_t samples) {
    return std::make_unique<WavSoundFile>(path, samples);
}

void write_sound(const SoundCommand& command, CommandContext& context, const SoundFileMaker& make) {
    const bool has_other_results =
        !command.stems.empty() || !command.heard.empty() || command.report;
    const std::string path = command.output.empty() && has_other_results
                                 ? ""
                                 : output_or_default(command.output, command.input.path, ".wav");
    check_output_folder(path);
    check_output_folder(command.heard);
    FilmInput film;
    read_film(command, context, film);
    const pipeline::JobObserver observer = make_console_observer(context.console);
    const auto stage = [&](const char* name) {
        return WorkContext{[&observer, name](double done) { observer.on_progress(name, done); },
                           context.stop};
    };
    if (!path.empty() || !command.stems.empty() || command.report) {
        sound::FilmSound sound(film.scene, {.added = film.music}, stage("listen"));
        copy_all(sound, path.empty() ? nullptr : make(path, sound.frames()).get(), stage("sound"));
        context.console.end_progress();
        for (const std::string& note :
             {pipeline::missed_loudness_note(film.scene, sound.gain()),
              pipeline::fixed_gain_note(film.scene, static_cast<bool>(film.music), sound.levels()),
              pipeline::quiet_film_note(sound.levels().loudness,
                                        sound.gentle_loudness(stage("sound")))}) {
            if (!note.empty()) {
                context.console.warning(note);
            }
        }
        if (!path.empty()) {
            print_path(path);
        }
        if (!command.stems.empty()) {
            write_stems(command, film, sound.gain(), stage("stems"), make);
        }
        if (command.report) {
            const auto heard = sound::audible_impacts(film.scene, stage("report"));
            context.console.end_progress();
            print_text(sound_report({.levels = sound.levels(),
                                     .full_scale = sound.gain().full_scale,
                                     .asked = film.scene.loudness,
                                     .has_music = static_cast<bool>(film.music)},
                                    heard));
        }
    }
    if (!command.heard.empty()) {
        const auto heard = sound::audible_impacts(film.scene, stage("heard"));
        context.console.end_progress();
        write_text_output(command.heard, heard_to_csv(heard));
    }
}

void run(const SoundCommand& command, CommandContext& context) {
    write_sound(command, context, make_wav_file);
}

}  // namespace carom::cli
