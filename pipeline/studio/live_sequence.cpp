#include "pipeline/studio/live_sequence.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <tuple>
#include <utility>
#include <variant>

#include "pipeline/config/config_files.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/problem_list.h"
#include "pipeline/job/film_job.h"
#include "pipeline/picture/lit_annotations.h"
#include "pipeline/sequence/load_sequence.h"
#include "pipeline/studio/sequence_state.h"
#include "pipeline/studio/value_places.h"
#include "sim/bake.h"

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

const std::optional<sim::Timeline>& LiveSequence::motion_of(const sim::WorldDescription& world,
                                                            const Simulate& simulate,
                                                            Timelines& used) {
    const Hash128 hash = sim::physics_hash(world);
    if (const auto found = used.find(hash); found != used.end()) {
        return found->second;
    }
    if (auto known = timelines_.extract(hash)) {
        return used.insert(std::move(known)).position->second;
    }
    return used.emplace(hash, simulate(world)).first->second;
}

/// The moments of the shots get their times. Returns the problems of those that never come.
std::vector<pipeline::Problem> LiveSequence::add_motions(SequenceAnswer& answer,
                                                         pipeline::Sequence& sequence,
                                                         const pipeline::LoadOptions& options,
                                                         const Simulate& simulate) {
    std::vector<pipeline::Problem> problems;
    Timelines used;
    for (pipeline::SequencePart& part : sequence.parts) {
        answer.timelines.emplace_back();
        auto* shot = std::get_if<pipeline::ShotPart>(&part.content);
        if (shot == nullptr) {
            continue;
        }
        sim::Bake bake;
        if (shot->bake) {
            bake.timeline = shot->bake->timeline;
        } else if (const auto& motion = motion_of(shot->shot.world, simulate, used)) {
            bake.timeline = *motion;
        } else {
            continue;
        }
        pipeline::add_keyed_motions(bake, shot->shot);
        std::vector<pipeline::Problem> found =
            pipeline::resolve_moments(shot->shot, shot->source, bake.timeline, options.tables);
        std::move(found.begin(), found.end(), std::back_inserter(problems));
        pipeline::add_lit_annotations(shot->shot, bake.timeline);
        answer.timelines.back() = std::make_shared<const sim::Timeline>(std::move(bake.timeline));
    }
    timelines_ = std::move(used);
    return problems;
}

std::vector<Problem> LiveSequence::told(const std::vector<pipeline::Problem>& problems,
                                        const std::vector<pipeline::ReadFile>& files) const {
    return told_once(problem_messages(problems, files), files);
}

void LiveSequence::answer(std::int64_t v, const pipeline::LoadOptions& options,
                          const Simulate& simulate) {
    pipeline::SequenceResult loaded = pipeline::load_sequence(path_, options);
    output_.files(v, loaded.files, loaded.missing);
    if (!loaded.sequence) {
        output_.text(Problems{v, true, told(loaded.problems, loaded.files)});
        return;
    }
    SequenceState state = sequence_state(*loaded.sequence);
    state.v = v;
    state.places = places_;
    output_.text(std::move(state));
    output_.text(Problems{v, false, told(loaded.problems, loaded.files)});
    SequenceAnswer answer;
    answer.v = v;
    std::vector<pipeline::Problem> more = add_motions(answer, *loaded.sequence, options, simulate);
    const bool is_usable = !pipeline::has_errors(more);
    std::move(more.begin(), more.end(), std::back_inserter(loaded.problems));
    if (is_usable) {
        answer.sequence = std::make_shared<const pipeline::Sequence>(std::move(*loaded.sequence));
        output_.sequence(std::move(answer));
    }
    output_.text(Problems{v, true, told(loaded.problems, loaded.files)});
}

}  // namespace carom::studio
