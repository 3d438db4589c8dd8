#include "pipeline/import/import_scene.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/limits.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/problem_list.h"
#include "pipeline/config/text.h"
#include "pipeline/import/conversion.h"
#include "pipeline/import/read_scene.h"
#include "pipeline/import/tokenizer.h"

namespace carom::pipeline {

namespace {

using scene_text::Conversion;

constexpr std::size_t kMostBytes = std::size_t{16} << 20;
constexpr double kLongest = 3600;  // s

std::string comment(const std::string& line) {
    std::string text = "# " + line;
    std::replace_if(
        text.begin(), text.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return text + "\n";
}

std::string whole_text(Conversion& conversion, const std::string& name) {
    double last_time = 0;
    const std::string cameras = scene_text::cameras_section(conversion, last_time);
    const std::string objects = scene_text::objects_and_events(conversion, last_time);
    const std::string lights = scene_text::lights_section(conversion);
    const std::string render = scene_text::render_section(conversion);
    // The simulation is a little longer than the filmed interval, because the last shutter closes
    // later.
    const double duration = std::min(last_time + 0.1, kLongest);
    std::ostringstream out;
    out << comment("Made by carom import from " + std::filesystem::path(name).filename().string() +
                   "; lengths are the text's times " + scene_text::yaml(conversion.options.unit) +
                   " m.");
    for (const std::string& note : conversion.notes) {
        out << comment("- " + note);
    }
    out << "carom: 1\n"
        << "simulation: {duration: " << scene_text::yaml(duration) << " s}\n"
        << objects << lights << cameras << render;
    return out.str();
}

}  // namespace

ImportResult import_scene(const std::string& text, const std::string& name,
                          const std::string& scene_folder, const std::string& shot_folder,
                          const ImportOptions& options) {
    config::SourceSet sources;
    config::ProblemList problems(sources);
    bool was_decoded = false;
    const int source = sources.add({name, scene_folder, scene_text::as_utf8(text, was_decoded)});
    const std::vector<scene_text::Item> words = scene_text::tokenize(sources, source, problems);
    Conversion conversion{scene_text::read_scene(words, problems),
                          options,
                          scene_text::Axes(options),
                          problems,
                          scene_folder,
                          shot_folder};
    if (conversion.scene.cameras.empty() && !problems.has_error()) {
        problems.error({source, 1, 1, 1}, "the scene has no camera");
    }
    if (was_decoded) {
        conversion.note("the text is not UTF-8; it was read as Windows-1250");
    }
    ImportResult result;
    if (!problems.has_error()) {
        result.yaml = whole_text(conversion, name);
    }
    if (problems.has_error()) {
        result.yaml.clear();
    } else {
        result.notes = std::move(conversion.notes);
    }
    result.problems = problems.take();
    return result;
}

ImportResult import_scene_file(const std::string& path, const std::string& shot_folder,
                               const ImportOptions& options) {
    std::string text;
    if (!config::read_text_file(path, input_limit(kMostBytes), text)) {
        ImportResult result;
        result.problems.push_back({Severity::error, {path, 0, 0, 1}, {}, "this file " + text, {}});
        return result;
    }
    return import_scene(text, path, std::filesystem::path(path).parent_path().string(), shot_folder,
                        options);
}

}  // namespace carom::pipeline
