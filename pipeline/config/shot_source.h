// The YAML from which a shot was read, with the place of each value.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/diagnostic.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline {

class ShotSource {
  public:
    /// `root`: the tree after includes, presets and overrides. `files`: the absolute paths of the
    /// files to which its values refer.
    ShotSource(config::SourceSet sources, config::Node root,
               std::map<const config::Node*, std::string> files)
        : sources_(std::move(sources)), root_(std::move(root)), files_(std::move(files)) {}

    /// A problem at the value of that path ({"events", "0", "strike", "tip"}; elements of lists by
    /// their index), or at the last part of the path that the shot has.
    [[nodiscard]] Problem problem_at(const std::vector<std::string>& path, Severity severity,
                                     std::string message) const;

    /// A problem of the simulation or the renderer, at the value to which it refers; without a
    /// place if it refers to the whole shot.
    [[nodiscard]] Problem problem_of(const Diagnostic& diagnostic) const;

    [[nodiscard]] const config::Node& root() const { return root_; }
    [[nodiscard]] const config::SourceSet& sources() const { return sources_; }
    [[nodiscard]] const std::map<const config::Node*, std::string>& files() const { return files_; }

  private:
    config::SourceSet sources_;
    config::Node root_;
    std::map<const config::Node*, std::string> files_;  // nodes of `root_` below its top
};

}  // namespace carom::pipeline
