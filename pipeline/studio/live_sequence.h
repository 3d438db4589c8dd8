// What a live shot answers if its text is a film of several shots.
#pragma once

#include <cstdint>
#include <string>

#include "pipeline/config/load_shot.h"
#include "pipeline/studio/live_shot.h"
#include "pipeline/studio/messages.h"

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

    /// Answers the texts that were asked about last. `options`: of all shots.
    void answer(std::int64_t v, const pipeline::LoadOptions& options);

  private:
    const LiveOutput& output_;
    std::string root_;
    std::string path_;  // of the film's file
    std::vector<ValuePlace> places_;
    bool is_sequence_ = false;
};

}  // namespace carom::studio
