// Reads a Shot from YAML and reports all of its problems together.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/config/named_file.h"
#include "pipeline/config/problem.h"
#include "pipeline/shot/shot.h"

namespace carom::sim::billiards {
class TableMemo;  // sim/billiards/table_memo.h
}

namespace carom::pipeline::solve {
struct AnswerWork;  // pipeline/solve/answers.h
}

namespace carom::pipeline {

class ShotSource;  // pipeline/config/shot_source.h

/// A file that was read: the shot, a file that it includes, or a preset.
struct ReadFile {
    std::string path;  // absolute
    std::string name;  // as problems name it

    bool operator==(const ReadFile&) const = default;
};

struct LoadResult {
    std::optional<Shot> shot;                  // empty if a problem is an error
    std::vector<Problem> problems;             // errors and warnings, sorted by file and place
    std::shared_ptr<const ShotSource> source;  // null if there is no shot
    std::vector<ReadFile> files{};             // in the order of reading, also if there is no shot
    std::vector<std::string> missing{};        // absolute paths of files that do not exist
    std::vector<NamedFile> named_files{};      // other files, also if there is no shot
};

/// What changes a shot while it is loaded, and what it may read.
struct LoadOptions {
    /// Values like those of `overrides` that count as the shot's own: a preset may change them.
    std::vector<std::string> own{};
    /// Values as given to --set: "render.samples=64".
    std::vector<std::string> overrides{};
    /// The name of a preset in configs/quality: "draft", "preview" or "final". Empty: the one that
    /// the shot names, if any.
    std::string quality{};
    /// A file whose cameras replace the shot's (gather.h). Empty: none.
    std::string camera_file{};
    /// The folder that must hold all files that the shot names (config_files.h). Empty: any.
    std::string root{};
    /// Texts that are read instead of the files of these absolute paths (config_files.h). nullptr:
    /// none.
    const std::map<std::string, std::string>* texts = nullptr;
    /// The largest size of a mesh or an image; 0: any.
    std::uintmax_t most_asset_bytes = 0;
    /// Tables that were built before. nullptr: the table is built anew.
    sim::billiards::TableMemo* tables = nullptr;
    /// How strikes of `solve` are found. nullptr: by a search, unless this process has made it
    /// before.
    const solve::AnswerWork* answers = nullptr;
};

/// A file that cannot be read is a problem, not an exception. Nothing is simulated but for `solve`,
/// so that loading takes milliseconds. Any number of threads may load at the same time. Throws
/// Stopped if a search for a strike is stopped.
[[nodiscard]] LoadResult load_shot(const std::string& path, const LoadOptions& options = {});

/// Like load_shot for a text in memory (a bake's shot_text, a fuzzer's input). Relative paths are
/// relative to the folder of `origin`.
[[nodiscard]] LoadResult load_shot_text(const std::string& text, const std::string& origin,
                                        const LoadOptions& options = {});

/// Whether the times of some moments are not known yet.
/// The text of the shot's own file with the strikes that were found for `solve` instead of it; all
/// else, comments too, stays. Throws Error if they stand in another file.
[[nodiscard]] std::string solved_text(const Shot& shot, const ShotSource& source);

[[nodiscard]] bool has_open_moments(const Shot& shot);

/// Gives the shot the times at which its moments come in `timeline`, the motion of its world: in
/// its cameras, annotations, moments and its resolved text. Its cameras also learn where they keep
/// their up direction (keep_up). `source` is what it was read from, and
/// becomes one that explains moments by their times. Returns the problems that were not found
/// before. A moment that never comes is an error at its place, and leaves both unchanged. A shot
/// without open moments is left as it is.
[[nodiscard]] std::vector<Problem> resolve_moments(Shot& shot,
                                                   std::shared_ptr<const ShotSource>& source,
                                                   const sim::Timeline& timeline,
                                                   sim::billiards::TableMemo* tables = nullptr);

/// The same for what only looks at a shot: moments that never come are warnings, and stay open. The
/// cameras that need them are left out of the shot, and of `source`, which then explains nothing.
[[nodiscard]] std::vector<Problem> resolve_known_moments(Shot& shot,
                                                         std::shared_ptr<const ShotSource>& source,
                                                         const sim::Timeline& timeline);

}  // namespace carom::pipeline
