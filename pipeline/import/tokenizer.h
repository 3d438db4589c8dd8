// Splits a scene text into words and nested groups in braces.
#pragma once

#include <string>
#include <vector>

#include "pipeline/config/problem_list.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::scene_text {

/// A word, or the contents of a pair of braces.
struct Item {
    std::string word;  // empty for a group
    std::vector<Item> group;
    bool is_group = false;
    config::Place place;  // of the word or of the opening brace
};

/// Splits the text `source` of `sources` at white space and braces. Unmatched braces, words of more
/// than 4096 bytes and braces nested more than 8 deep are reported as problems; everything else is
/// returned.
[[nodiscard]] std::vector<Item> tokenize(const config::SourceSet& sources, int source,
                                         config::ProblemList& problems);

}  // namespace carom::pipeline::scene_text
