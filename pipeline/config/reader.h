// The state of reading a shot: the current key, and the problems, references and files found so
// far.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/config/named_file.h"
#include "pipeline/config/node.h"
#include "pipeline/config/problem_list.h"
#include "pipeline/shot/shot.h"
#include "sim/event_time.h"

namespace carom::pipeline::config {

/// The kind of thing to which a name in the shot refers.
enum class ReferenceKind {
    ball,       // a sphere that a stick can strike
    body,       // a ball or object that the simulation moves
    simulated,  // a body, or an object that keys move and that pushes others
    moving,     // a body, or any object that keys move
    touchable,  // a body, a fixed object or a part of the table ("cushion")
    placed,     // a body or any object that has a position
    aimed,      // the same, or a spot or pocket of the table
    spot,       // a spot of the table
    pocket,     // a pocket of the table, by any of its names
    material,   // a material of a surface
};

/// A name that is checked after everything has been read.
struct Reference {
    ReferenceKind kind = ReferenceKind::body;
    std::string name;
    Place place;
    std::string key_path;
};

/// The simulated motion of a shot, and the world that was simulated.
struct KnownMotion {
    const sim::Timeline* timeline = nullptr;
    const sim::WorldDescription* world = nullptr;
    bool keeps_open = false;  // a moment that never comes stays open, with a warning
};

/// Times of moments are rounded to this fraction of a second, so that they are exact fractions.
inline constexpr std::int64_t kMomentTicks = 1'000'000;

class Reader {
  public:
    /// `motion`: where the times of moments are found; nullptr: they are not known yet.
    Reader(const SourceSet& sources, const ConfigFolders& folders, ProblemList& problems,
           const KnownMotion* motion = nullptr)
        : sources_(&sources), folders_(&folders), problems_(&problems), motion_(motion) {}

    /// Enters a key or a list element for the lifetime of the scope.
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

    /// Sets the place of problems about missing keys of the whole shot.
    void set_root_place(const Place& place) { root_place_ = place; }

    /// Sets the name of the current value for messages: "camera 'opening'".
    void set_label(std::string label) { steps_.back().label = std::move(label); }

    /// The name of the current value: "camera 'opening'", "'shutter' of 'render'", "the shot".
    [[nodiscard]] std::string label() const;

    /// The current value by its key: "'bezier[1]'".
    [[nodiscard]] std::string value_name() const;

    /// "cameras[0].position"
    [[nodiscard]] std::string key_path() const;

    /// The place of the current key, or of the current element of a list.
    [[nodiscard]] Place key_place() const;

    void error(const Place& place, Message message);
    void warning(const Place& place, Message message);
    /// Adds an error that is found later, for the value at `key_path`.
    void error_at_path(const Place& place, Message message, std::string key_path);
    /// Sets whether a part of the shot could not be read (an included file is missing), so that
    /// missing keys are not reported.
    void set_partial(bool is_partial) { is_partial_ = is_partial; }
    [[nodiscard]] bool is_partial() const { return is_partial_; }

    [[nodiscard]] bool has_error() const { return problems_->has_error(); }

    /// "'duration' must be a time (s, ms, min), not a list"
    void wrong_type(const Node& node, std::string_view expected);

    void refer(ReferenceKind kind, const Node& node);
    [[nodiscard]] const std::vector<Reference>& references() const { return references_; }

    /// The absolute path of the existing regular file whose name is `node`; empty after a problem.
    /// The file becomes an asset of the shot.
    [[nodiscard]] std::string file(const Node& node, FileKind kind);
    /// Says that the shot chooses the background of the texture that `node` names.
    void set_background(const Node& node);
    /// Says that the current value, and what it contains, does not show the texture at `path` where
    /// that is transparent.
    void set_cut_out(const std::string& path);
    /// In the order of reading.
    [[nodiscard]] std::vector<NamedFile> named_files() const;

    /// The scene time (s) of the moment that `node` describes; 0 if it is not known. Empty after an
    /// error: it never comes.
    [[nodiscard]] std::optional<double> time_of(const sim::EventTime& moment, const Node& node);
    /// Whether moments have their times.
    [[nodiscard]] bool knows_motion() const { return motion_ != nullptr; }
    /// All moments so far, in the order of reading.
    [[nodiscard]] const std::vector<ShotMoment>& moments() const { return moments_; }

    /// The texts that replace values in the resolved text, by node: the absolute paths of files
    /// and the times of moments.
    [[nodiscard]] const std::map<const Node*, std::string>& replaced() const { return replaced_; }

    [[nodiscard]] const SourceSet& sources() const { return *sources_; }

  private:
    /// For a moment without a time.
    std::optional<double> leave_open(const Node& node, const std::string& reason);

    struct Step {
        std::string key;  // empty for a list element
        std::size_t index = 0;
        Place place;
        std::string label;
    };

    const SourceSet* sources_;
    const ConfigFolders* folders_;
    ProblemList* problems_;
    const KnownMotion* motion_;
    std::vector<Step> steps_;
    bool is_partial_ = false;
    Place root_place_;
    std::vector<Reference> references_;
    struct FileOfNode {
        const Node* node = nullptr;
        FileKind kind = FileKind::mesh;
        std::string path;
        std::string key_path;
        bool is_transparency_meant = false;
    };
    std::vector<FileOfNode> files_;
    std::map<const Node*, std::string> replaced_;
    std::vector<ShotMoment> moments_;
};

/// "a list", "a map", "nothing" or the quoted scalar, for use after "not".
[[nodiscard]] std::string describe(const Node& node);

}  // namespace carom::pipeline::config
