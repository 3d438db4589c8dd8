// The words of a scene text, in the nesting that its braces give them.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem_list.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::scene_text {

/// A word, or what stands between a pair of braces.
struct Item {
    std::string word;  // empty for a group
    std::vector<Item> group;
    bool is_group = false;
    config::Place place;  // of the word or of the opening brace
};

/// The text `source` of `sources`, cut at white space and braces. Unmatched braces, words over
/// 4096 bytes and braces more than 8 deep are problems; what can be read is returned all the same.
[[nodiscard]] std::vector<Item> tokenize(const config::SourceSet& sources, int source,
                                            config::ProblemList& problems);

}  // namespace carom::pipeline::scene_text
