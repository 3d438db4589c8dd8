// Reads a film of several shots, with all of its shots, and reports all problems together.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/load_shot.h"
#include "pipeline/sequence/sequence.h"

namespace carom::pipeline {

/// Whether the file is a film of several shots: a map with the key `film`. False if it cannot be
/// read. `texts` as of LoadOptions.
[[nodiscard]] bool is_sequence_file(const std::string& path,
                                    const std::map<std::string, std::string>* texts = nullptr);

struct SequenceResult {
    std::optional<Sequence> sequence;  // empty if a problem is an error
    std::vector<Problem> problems;  // those of the film's own file first, then those of its shots
    std::vector<ReadFile> files{};  // texts that were read, each once, the film's own first
    std::vector<std::string> missing{};    // absolute paths of files that do not exist
    std::vector<NamedFile> named_files{};  // other files, of the film and of its shots
    Problem output_place{};  // a problem at the film's output settings, without a message
};

/// `options.overrides` and `options.quality` are for all shots. The shots' moments are open, and
/// nothing is simulated. With `options.root` the shots' files have to lie in that folder, too, or
/// in `folder_of_shots` if it is given.
[[nodiscard]] SequenceResult load_sequence(const std::string& path, const LoadOptions& options = {},
                                           const std::string& folder_of_shots = {});

}  // namespace carom::pipeline
