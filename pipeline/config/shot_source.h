// The YAML from which a shot was read, with the place of each value.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/diagnostic.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem.h"
#include "pipeline/config/source_set.h"

namespace carom::pipeline {

class ShotSource {
  public:
    /// Texts by the values that they replace in a text that explains the shot.
    using Replaced = std::map<const config::Node*, std::string>;

    /// What a text that explains the shot adds to the places of values.
    using Notes = std::map<const config::Node*, std::string>;

    /// `root`: the tree after includes, presets and overrides. `replaced`: the absolute paths of
    /// the files to which its values refer, and the times of its moments. `problems`: those that
    /// were found when the tree was read. `notes`: the aims of directions that were found.
    ShotSource(std::shared_ptr<const config::SourceSet> sources,
               std::shared_ptr<const config::Node> root, Replaced replaced,
               std::vector<Problem> problems, Notes notes = {})
        : sources_(std::move(sources)),
          root_(std::move(root)),
          replaced_(std::move(replaced)),
          problems_(std::move(problems)),
          notes_(std::move(notes)) {}

    /// The same texts and tree, with other replaced values.
    [[nodiscard]] ShotSource with_replaced(Replaced replaced) const {
        return {sources_, root_, std::move(replaced), problems_, notes_};
    }

    /// The same texts with another tree, in which nothing is replaced.
    [[nodiscard]] ShotSource with_root(std::shared_ptr<const config::Node> root) const {
        return {sources_, std::move(root), {}, problems_};
    }

    /// A problem at the value of that path ({"events", "0", "strike", "tip"}; elements of lists by
    /// their index), or at the last part of the path that the shot has.
    [[nodiscard]] Problem problem_at(const std::vector<std::string>& path, Severity severity,
                                     std::string message) const;

    /// A problem of the simulation or the renderer, at the value to which it refers; without a
    /// place if it refers to the whole shot.
    [[nodiscard]] Problem problem_of(const Diagnostic& diagnostic) const;

    [[nodiscard]] const config::Node& root() const { return *root_; }
    [[nodiscard]] const config::SourceSet& sources() const { return *sources_; }
    [[nodiscard]] const Replaced& replaced() const { return replaced_; }
    [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
    [[nodiscard]] const Notes& notes() const { return notes_; }

  private:
    std::shared_ptr<const config::SourceSet> sources_;
    std::shared_ptr<const config::Node> root_;
    Replaced replaced_;  // nodes of `root_` below its top
    std::vector<Problem> problems_;
    Notes notes_;  // by nodes of `root_` below its top
};

}  // namespace carom::pipeline
