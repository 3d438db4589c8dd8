// Where a reading of the shot stands, and what it has met: problems, references, files.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"

namespace carom::pipeline::config {

/// What a name in the shot refers to.
enum class ReferenceKind {
    ball,       // a sphere that a stick can strike
    body,       // anything that moves by the laws of physics, and so has a track
    simulated,  // a body, or an object moved by keys that pushes others
    moving,     // a body, or any object moved by keys
    touchable,  // a body, a fixed object or a part of the table ("cushion")
    placed,     // a body or any object that stands somewhere
    material,   // of the look
};

/// A name used before everything is read; checked at the end.
struct Reference {
    ReferenceKind kind = ReferenceKind::body;
    std::string name;
    Place place;
    std::string key_path;
};

class Reader {
  public:
    Reader(const SourceSet& sources, const ConfigFolders& folders, ProblemList& problems)
        : sources_(&sources), folders_(&folders), problems_(&problems) {}

    /// Goes into a key or a list element while it lives.
    class Scope {
      public:
        Scope(Reader& reader, std::string key, Place key_place);
        Scope(Reader& reader, std::size_t index, Place place);
        ~Scope() { reader_.steps_.pop_back(); }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        Reader& reader_;
    };

    /// Where the shot begins: the place of what is missing in it.
    void set_root_place(const Place& place) { root_place_ = place; }

    /// Names the thing that is being read, for messages: "camera 'opening'".
    void set_label(std::string label) { steps_.back().label = std::move(label); }

    /// What is being read: "camera 'opening'", "'shutter' of 'render'", "the shot".
    [[nodiscard]] std::string label() const;

    /// The value that is being read: "'bezier[1]'".
    [[nodiscard]] std::string value_name() const;

    /// "cameras[0].position"
    [[nodiscard]] std::string key_path() const;

    /// The place of the key that is being read (of the element, in a list).
    [[nodiscard]] Place key_place() const;

    void error(const Place& place, std::string message);
    void warning(const Place& place, std::string message);
    /// An error found later, about what stood at `key_path`.
    void error_at_path(const Place& place, std::string message, std::string key_path);
    /// Part of the shot could not be read (an included file is missing): what seems to be missing
    /// may be there.
    void set_partial(bool is_partial) { is_partial_ = is_partial; }
    [[nodiscard]] bool is_partial() const { return is_partial_; }

    [[nodiscard]] bool has_error() const { return problems_->has_error(); }

    /// "'duration' must be a time (s, ms, min), not a list"
    void wrong_type(const Node& node, std::string_view expected);

    void refer(ReferenceKind kind, const Node& node);
    [[nodiscard]] const std::vector<Reference>& references() const { return references_; }

    /// The absolute path of an existing regular file that `node` names; empty after a problem. It
    /// becomes an asset of the shot.
    [[nodiscard]] std::string file(const Node& node);
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

    /// What the resolved text says in place of a file's name, by the place of the node.
    [[nodiscard]] const std::map<const Node*, std::string>& absolute_paths() const {
        return absolute_paths_;
    }

    [[nodiscard]] const SourceSet& sources() const { return *sources_; }

  private:
    struct Step {
        std::string key;  // empty for a list element
        std::size_t index = 0;
        Place place;
        std::string label;
    };

    const SourceSet* sources_;
    const ConfigFolders* folders_;
    ProblemList* problems_;
    std::vector<Step> steps_;
    bool is_partial_ = false;
    Place root_place_;
    std::vector<Reference> references_;
    std::vector<std::string> files_;
    std::map<const Node*, std::string> absolute_paths_;
};

/// "a list", "a map", "nothing" or the quoted scalar: to follow "not".
[[nodiscard]] std::string describe(const Node& node);

}  // namespace carom::pipeline::config
