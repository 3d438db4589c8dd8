// The words for the condition of a table, its balls and the stick ("cloth: worn"), which stand for
// numbers.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

/// A key of `physics` whose value is a word, and of `conditions`, which has the numbers of each
/// word.
struct ConditionKey {
    std::string name;                // "cloth"
    std::string description;         // of what
    std::vector<std::string> words;  // those that configs/balls has for every kind of ball
};

/// All of them, in the order in which they are applied: of two conditions that give the same
/// number, the later has precedence.
[[nodiscard]] std::span<const ConditionKey> condition_keys();

/// Replaces the words of `physics` in the merged tree of a shot by numbers:
/// - The numbers of each word are merged under the keys that `physics` has, so that a number of the
///   shot or of an included file has precedence over a word, wherever the word is.
/// - The numbers of `physics.stick` are added to the strikes that do not give their own.
/// The words remain. Of `conditions` only the words that `physics` uses remain, without numbers, so
/// that the result means the same without the files from which the numbers came.
///
/// A word that `conditions` does not have is taken from configs/balls/<kind>.yaml, where the kind
/// is that of the ball set, else that of the table, else pool. All of `conditions` is checked, and
/// a word that is found nowhere is a problem; with `is_partial` (an included file is missing) it is
/// not.
void apply_conditions(Node& root, SourceSet& sources, const ConfigFolders& folders,
                      ProblemList& problems, bool is_partial);

}  // namespace carom::pipeline::config
