#include "pipeline/sequence/load_sequence.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/config/bake_shot.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/emit_yaml.h"
#include "pipeline/config/gather.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/sections/sections.h"
#include "pipeline/config/text.h"
#include "pipeline/video/video_format.h"

namespace carom::pipeline {

namespace fs = std::filesystem;
using namespace config;

namespace {

/// The whole file.
struct SequenceFile {
    std::optional<FilmSection> film;
    OutputSettings output;
    std::string output_text;
};

const MapSpec<SequenceFile>& sequence_spec() {
    static const MapSpec<SequenceFile> spec = [] {
        MapSpec<SequenceFile> s("film of several shots", "The whole file.");
        s.set(
             "carom", integer(1, 1), [](SequenceFile&, int) {}, "version of the format")
            .required();
        s.key("film", &SequenceFile::film, record(film_spec()), "the parts of the film").required();
        s.map("output", &SequenceFile::output, output_spec(), "how the film is encoded");
        return s;
    }();
    return spec;
}

std::string folder_of(const std::string& path) {
    std::error_code code;
    const fs::path absolute = fs::absolute(path, code);
    return code ? "." : absolute.lexically_normal().parent_path().string();
}

/// The number of whole frames in a time, rounded to the nearest.
std::int64_t frames_in(const Rational& time, const Rational& fps) {
    return static_cast<std::int64_t>(std::llround(time.to_double() * fps.to_double()));
}

/// The first frame at or after a time.
std::int64_t frame_from(const Rational& time, const Rational& fps) {
    constexpr double kRounding = 1e-9;
    return static_cast<std::int64_t>(std::ceil(time.to_double() * fps.to_double() - kRounding));
}

std::string size_text(int width, int height) {
    return fmt::format("{}x{}", width, height);
}

std::string rate_text(const Rational& fps) {
    return decimal_text(fps.to_double(), 4) + " frames per second";
}

bool is_bake(const std::string& path) {
    return fs::path(path).extension() == ".bake";
}

class Loader {
  public:
    Loader(const std::string& path, const LoadOptions& options, const std::string& folder_of_shots)
        : path_(path),
          options_(options),
          root_of_shots_(folder_of_shots.empty() ? options.root : folder_of_shots) {}

    SequenceResult load() {
        SequenceResult result;
        const std::optional<SequenceFile> file = read_file();
        if (file && file->film && !problems_.has_error()) {
            Sequence sequence;
            sequence.name = fs::path(path_).stem().string();
            sequence.output = file->output;
            sequence.output_text = file->output_text;
            add_parts(*file->film, sequence);
            if (!problems_.has_error() && !has_errors(of_shots_)) {
                check_fades(*file->film, sequence);
            }
            if (!problems_.has_error() && !has_errors(of_shots_)) {
                result.sequence = std::move(sequence);
            }
        }
        result.problems = problems_.take();
        std::move(of_shots_.begin(), of_shots_.end(), std::back_inserter(result.problems));
        result.files = std::move(files_);
        result.missing = std::move(missing_);
        result.named_files = std::move(named_files_);
        result.output_place = std::move(output_place_);
        return result;
    }

  private:
    std::optional<SequenceFile> read_file() {
        ConfigFolders folders = config_folders_of(path_);
        folders.root = options_.root;
        folders.texts = options_.texts;
        folders.missing = &missing_;
        std::string text;
        if (!read_config_text(path_, YamlLimits{}.bytes, folders, text)) {
            Problem problem;
            problem.place.file = path_;
            problem.message = "the file " + text;
            of_shots_.push_back(std::move(problem));
            return std::nullopt;
        }
        folder_ = folder_of(path_);
        const int source = sources_.add({path_, folder_, std::move(text), {}, path_});
        const Gathered gathered = gather(sources_, source, folders, {}, problems_);
        for (int i = 0; i < sources_.size(); ++i) {
            add_files({{sources_.at(i).path, sources_.at(i).name}});
        }
        if (!gathered.root) {
            return std::nullopt;
        }
        Reader reader(sources_, folders, problems_);
        reader.set_root_place(gathered.root->place);
        reader.set_partial(!gathered.is_complete);
        SequenceFile file;
        sequence_spec().read(reader, *gathered.root, file);
        if (const Entry* output = gathered.root->find("output")) {
            file.output_text = emit_flow(output->value);
            output_place_.place = sources_.describe(output->key_place);
            output_place_.source_line = sources_.line_of(output->key_place);
            output_place_.key_path = "output";
            check_output(*output, file.output, reader);
        }
        named_files_ = reader.named_files();
        if (file.output.hdr10) {
            reader.error(gathered.root->find("output")->key_place,
                         "a film of several shots cannot be written as 'hdr10' yet");
        }
        return file;
    }

    /// Reports settings that exclude each other at the last of them.
    static void check_output(const Entry& section, const OutputSettings& output, Reader& reader) {
        const SettingProblem problem =
            find_setting_problem(output, "film" + default_extension(output));
        Place place = section.key_place;
        for (const std::string& key : problem.keys) {
            const Entry* setting = section.value.find(key);
            place = setting != nullptr ? setting->value.place : place;
        }
        if (!problem.sentence.empty()) {
            reader.error(place, problem.sentence);
        }
    }

    void add_files(const std::vector<ReadFile>& files) {
        for (const ReadFile& file : files) {
            if (!file.path.empty() &&
                std::ranges::find(files_, file.path, &ReadFile::path) == files_.end()) {
                files_.push_back(file);
            }
        }
    }

    void add_parts(const FilmSection& film, Sequence& sequence) {
        if (film.size) {
            sequence.width = (*film.size)[0];
            sequence.height = (*film.size)[1];
        }
        if (film.fps) {
            sequence.fps = *film.fps;
        }
        bool is_first = true;
        for (const FilmPartSection& part : film.parts) {
            if (part.shot) {
                add_shot(film, part, is_first, sequence);
            } else {
                sequence.parts.push_back({*part.title, 1, 0});
            }
        }
        const bool is_titles = std::ranges::none_of(
            film.parts, [](const auto& part) { return part.shot.has_value(); });
        if (is_titles && !(film.size && film.fps)) {
            problems_.error(film.parts.front().place,
                            "a film of title cards alone needs 'size' and 'fps'", "film");
        }
    }

    [[nodiscard]] LoadOptions options_of(const FilmSection& film,
                                         const FilmPartSection& part) const {
        LoadOptions options = options_;
        if (film.size) {
            options.own.push_back(
                fmt::format("render.size=[{}, {}]", (*film.size)[0], (*film.size)[1]));
        }
        if (film.fps) {
            options.own.push_back("render.fps=" + film.fps->to_string());
        }
        options.own.insert(options.own.end(), part.overrides.begin(), part.overrides.end());
        return options;
    }

    /// The shot in a bake, which it keeps.
    LoadResult load_bake(const FilmPartSection& part, const LoadOptions& options, ShotPart& shot) {
        try {
            shot.bake = std::make_shared<const sim::Bake>(sim::read_bake(shot.path));
        } catch (const Error& error) {
            problems_.error(part.shot_place, error.what());
            return {};
        }
        LoadResult loaded = load_bake_shot(*shot.bake, shot.path, options);
        if (loaded.shot && changes_physics(*shot.bake, *loaded.shot, shot.path, options)) {
            problems_.error(part.place, quote(*part.shot) +
                                            " is a bake, whose physics cannot be changed; change "
                                            "the shot and bake it again");
        }
        return loaded;
    }

    /// The file of a shot that the film names, beside the film, or beside the file to which a
    /// linked film leads.
    [[nodiscard]] std::string path_of(const fs::path& name) const {
        const fs::path beside = fs::path(path_).parent_path() / name;  // or the name, if absolute
        std::error_code code;
        const fs::path target = fs::canonical(path_, code).parent_path() / name;
        const bool is_there = !code && !fs::exists(beside, code) && fs::exists(target, code);
        return (is_there ? target : beside).string();
    }

    /// Whether the shot's file may be read; else a problem says why not.
    [[nodiscard]] bool may_read(const FilmPartSection& part) {
        if (root_of_shots_.empty()) {
            return true;
        }
        ConfigFolders folders = config_folders_of(path_);
        folders.folders.clear();
        folders.root = root_of_shots_;
        folders.texts = options_.texts;
        folders.missing = &missing_;
        const FoundFile found = find_config_file(*part.shot, folder_, folders);
        if (found.path.empty()) {
            problems_.error(part.shot_place, found.problem);
        }
        return !found.path.empty();
    }

    /// The problems and the files of a part's shot become those of the film.
    void take_over(LoadResult& loaded, const FilmPartSection& part, bool is_text) {
        if (is_text) {
            add_files(loaded.files);
        }
        missing_.insert(missing_.end(), loaded.missing.begin(), loaded.missing.end());
        for (NamedFile& file : loaded.named_files) {
            file.where.included_by.push_back(sources_.describe(part.shot_place));
            named_files_.push_back(std::move(file));
        }
        for (Problem& problem : loaded.problems) {
            problem.included_by.push_back(sources_.describe(part.shot_place));
            of_shots_.push_back(std::move(problem));
        }
    }

    void add_shot(const FilmSection& film, const FilmPartSection& part, bool& is_first,
                  Sequence& sequence) {
        if (!may_read(part)) {
            return;
        }
        ShotPart shot;
        shot.path = path_of(*part.shot);
        const LoadOptions options = options_of(film, part);
        shot.own = options.own;
        shot.overrides = options.overrides;
        LoadResult loaded =
            is_bake(shot.path) ? load_bake(part, options, shot) : load_shot(shot.path, options);
        take_over(loaded, part, shot.bake == nullptr);
        sequence.parts.push_back({TitleCard{}, 1, 0});
        if (!loaded.shot) {
            return;
        }
        shot.shot = std::move(*loaded.shot);
        shot.source = std::move(loaded.source);
        check_format(part, shot.shot, is_first, sequence);
        const std::int64_t count = frame_count(shot.shot.cameras, shot.shot.timing);
        const std::int64_t first = part.from ? frame_from(*part.from, shot.shot.timing.fps) : 0;
        const std::int64_t end = part.to ? frame_from(*part.to, shot.shot.timing.fps) : count;
        if (count == 0) {
            problems_.error(part.shot_place, quote(*part.shot) +
                                                 " has no camera: there is nothing "
                                                 "to film");
        } else if (first >= count || end > count) {
            problems_.error(part.place, "the film of " + quote(*part.shot) + " ends at " +
                                            seconds_text(static_cast<double>(count) /
                                                         shot.shot.timing.fps.to_double()) +
                                            ", before this part does");
        }
        shot.first = first;
        sequence.parts.back() = {std::move(shot), std::max<std::int64_t>(end - first, 1), 0};
    }

    /// All shots have the size and the rate of the first one.
    void check_format(const FilmPartSection& part, const Shot& shot, bool& is_first,
                      Sequence& sequence) {
        if (std::exchange(is_first, false)) {
            sequence.width = shot.render.width;
            sequence.height = shot.render.height;
            sequence.fps = shot.timing.fps;
            first_ = *part.shot;
            return;
        }
        const auto report = [&](const std::string& own, const std::string& other,
                                const std::string& key) {
            problems_.error(part.shot_place, quote(*part.shot) + " has " + own + ", but " +
                                                 quote(first_) + " has " + other + "; give '" +
                                                 key + "' in 'film'");
        };
        if (shot.render.width != sequence.width || shot.render.height != sequence.height) {
            report(size_text(shot.render.width, shot.render.height) + " pixels",
                   size_text(sequence.width, sequence.height), "size");
        }
        if (shot.timing.fps != sequence.fps) {
            report(rate_text(shot.timing.fps), decimal_text(sequence.fps.to_double(), 4), "fps");
        }
    }

    /// Times become whole frames. Two fades of one part may not overlap.
    void check_fades(const FilmSection& film, Sequence& sequence) {
        for (std::size_t i = 0; i < film.parts.size(); ++i) {
            SequencePart& part = sequence.parts[i];
            if (film.parts[i].title) {
                part.frames =
                    std::max<std::int64_t>(1, frames_in(film.parts[i].length, sequence.fps));
            }
            part.fade = frames_in(film.parts[i].fade, sequence.fps);
        }
        for (std::size_t i = 0; i < film.parts.size(); ++i) {
            const std::int64_t next =
                i + 1 < sequence.parts.size() ? sequence.parts[i + 1].fade : 0;
            if (sequence.parts[i].fade + next > sequence.parts[i].frames) {
                problems_.error(
                    film.parts[i].place,
                    fmt::format(
                        "this part has {}, too few for the fades at its ends, which take {}",
                        counted(static_cast<std::uint64_t>(sequence.parts[i].frames), "frame"),
                        sequence.parts[i].fade + next));
            }
        }
    }

    std::string path_;
    const LoadOptions& options_;
    std::string root_of_shots_;
    std::string folder_;
    SourceSet sources_;
    ProblemList problems_{sources_};
    std::vector<Problem> of_shots_;
    std::vector<ReadFile> files_;
    std::vector<std::string> missing_;
    std::vector<NamedFile> named_files_;
    Problem output_place_;
    std::string first_;  // the shot that decides about size and rate
};

}  // namespace

bool is_sequence_file(const std::string& path, const OpenTexts* texts) {
    ConfigFolders folders;
    folders.texts = texts;
    std::string text;
    if (is_bake(path) || !read_config_text(path, YamlLimits{}.bytes, folders, text)) {
        return false;
    }
    SourceSet sources;
    ProblemList problems(sources);
    const int source = sources.add({path, "", std::move(text)});
    const std::optional<Node> root = parse_yaml(sources, source, problems);
    return root && root->find("film") != nullptr;
}

SequenceResult load_sequence(const std::string& path, const LoadOptions& options,
                             const std::string& folder_of_shots) {
    return Loader(path, options, folder_of_shots).load();
}

}  // namespace carom::pipeline
