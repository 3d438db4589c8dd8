#include "pipeline/studio/live_sequence.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/problem_list.h"
#include "pipeline/sequence/load_sequence.h"
#include "pipeline/studio/sequence_state.h"
#include "pipeline/studio/value_places.h"

namespace carom::studio {

namespace config = pipeline::config;

namespace {

auto place_of(const Problem& problem) {
    const TextRange& place = problem.place;
    return std::tie(place.file, place.line, place.column, problem.message);
}

/// A problem of a shot that several parts use is told once. One of a value that a part gives to its
/// shot has its place there.
std::vector<Problem> told_once(std::vector<Problem> problems,
                               const std::vector<pipeline::ReadFile>& files) {
    std::vector<Problem> once;
    for (Problem& problem : problems) {
        const bool has_place =
            std::ranges::find(files, problem.place.file, &pipeline::ReadFile::path) != files.end();
        if (!has_place && !problem.included_by.empty()) {
            problem.place = problem.included_by.back();
        }
        if (std::ranges::none_of(
                once, [&](const Problem& one) { return place_of(one) == place_of(problem); })) {
            once.push_back(std::move(problem));
        }
    }
    return once;
}

}  // namespace

bool LiveSequence::takes(const TextsOfVersion& texts) {
    config::ConfigFolders folders;
    folders.texts = texts.texts.get();
    std::string text;
    if (!config::read_config_text(texts.shot, config::YamlLimits{}.bytes, folders, text)) {
        return is_sequence_;
    }
    path_ = texts.shot;
    config::SourceSet sources;
    config::ProblemList problems(sources);
    const int source = sources.add({texts.shot, "", std::move(text), {}, texts.shot});
    if (const std::optional<config::Node> root = config::parse_yaml(sources, source, problems)) {
        is_sequence_ = root->find("film") != nullptr;
        places_ = is_sequence_ ? value_places(sources, *root, root_) : std::vector<ValuePlace>();
    }
    return is_sequence_;
}

void LiveSequence::answer(std::int64_t v, const pipeline::LoadOptions& options) {
    const pipeline::SequenceResult loaded = pipeline::load_sequence(path_, options);
    output_.files(v, loaded.files, loaded.missing);
    if (loaded.sequence) {
        SequenceState state = sequence_state(*loaded.sequence);
        state.v = v;
        state.places = places_;
        output_.text(std::move(state));
    }
    output_.text(Problems{
        v, true, told_once(problem_messages(loaded.problems, loaded.files), loaded.files)});
}

}  // namespace carom::studio
