// What a live shot answers if its text is a film of several shots.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/hash.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/studio/live_shot.h"
#include "pipeline/studio/messages.h"
#include "sim/timeline/timeline.h"
#include "sim/world.h"

namespace carom::studio {

/// For the thread of a live shot.
class LiveSequence {
  public:
    /// Refers to the output. `root`: the folder below which the film's files are.
    LiveSequence(const LiveOutput& output, std::string root)
        : output_(output), root_(std::move(root)) {}

    /// Whether the texts are those of a film of several shots: a map with the key `film`. A text
    /// that cannot be parsed, which is being typed, is what it was before.
    [[nodiscard]] bool takes(const TextsOfVersion& texts);

    /// Returns the motion without keyed motions; nothing if that takes too many steps.
    using Simulate = std::function<std::optional<sim::Timeline>(const sim::WorldDescription&)>;

    /// Answers the texts that were asked about last. `options`: of all shots. Each world is
    /// simulated once, and only if the answer before did not need it. Throws what `simulate` does.
    void answer(std::int64_t v, const pipeline::LoadOptions& options, const Simulate& simulate);

  private:
    /// By the hashes of their worlds; nothing: it takes too many steps.
    using Timelines = std::map<Hash128, std::optional<sim::Timeline>>;

    const std::optional<sim::Timeline>& motion_of(const sim::WorldDescription& world,
                                                  const Simulate& simulate, Timelines& used);
    [[nodiscard]] std::vector<pipeline::Problem> add_motions(SequenceAnswer& answer,
                                                             pipeline::Sequence& sequence,
                                                             const pipeline::LoadOptions& options,
                                                             const Simulate& simulate);
    [[nodiscard]] std::vector<Problem> told(const std::vector<pipeline::Problem>& problems,
                                            const std::vector<pipeline::ReadFile>& files) const;

    const LiveOutput& output_;
    std::string root_;
    std::string path_;  // of the film's file
    std::vector<ValuePlace> places_;
    bool is_sequence_ = false;
    Timelines timelines_;
};

}  // namespace carom::studio
