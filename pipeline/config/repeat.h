// Objects with a `repeat`, which stand for many.
#pragma once

#include "pipeline/config/config_files.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline::config {

/// Replaces each object of the merged tree that has a `repeat` (sections/repeat.h) by the objects
/// for which it stands. NAME becomes NAME_1, NAME_2 and so on, without `repeat`, with its own `at`
/// and, if they are turned, `rotate`, rounded to a nanometre and to 1e-7 degrees. Their places are
/// those of the original, and their nodes are marked as repeated. An object of the tree that has
/// such a name is merged over the repeated one; if its value is null, there is none.
///
/// An object or a `repeat` with problems is reported once and removed; the result is then false.
/// With `is_partial` (an included file is missing) missing keys are not reported.
[[nodiscard]] bool repeat_objects(Node& root, const SourceSet& sources,
                                  const ConfigFolders& folders, ProblemList& problems,
                                  bool is_partial);

}  // namespace carom::pipeline::config
