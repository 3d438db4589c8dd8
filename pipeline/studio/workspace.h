// The files of a shot: the texts of the pages, which stand before those on disk, and what may be
// written.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/config/config_files.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/studio/messages.h"

namespace carom::studio {

/// Not thread-safe.
class Workspace {
  public:
    /// Throws Error if the file cannot be read. `root`: the folder below which files are written;
    /// empty: that of the shot.
    Workspace(const std::string& shot, const std::string& root);

    [[nodiscard]] const std::string& shot() const { return shot_; }
    [[nodiscard]] const std::string& root() const { return root_; }
    [[nodiscard]] std::int64_t version() const { return version_; }

    /// The open texts. They do not change any more.
    [[nodiscard]] std::shared_ptr<const pipeline::config::OpenTexts> texts() const {
        return texts_;
    }

    /// Sets the files of the shot, as they were read. Returns whether they are others than before.
    bool set_files(const std::vector<pipeline::ReadFile>& files);

    [[nodiscard]] Files files() const;

    /// Opens a text and gives it a version of at least `v`. Throws Error if it is not a file of the
    /// shot that may be written.
    std::int64_t set_text(std::int64_t v, const std::string& file, const std::string& text);

    /// The file on disk is used again. Throws as set_text.
    std::int64_t revert(std::int64_t v, const std::string& file);

    /// Writes the file. Throws Error if it may not be written or that fails.
    [[nodiscard]] std::variant<Saved, DiskChanged> save(const Save& request);

    /// The files to which the values of the shot refer: meshes, images. Returns whether they are
    /// others than before.
    bool set_assets(std::vector<std::string> paths);

    /// The files that were not found: the shot is read again when they appear. Returns as
    /// set_assets.
    bool set_missing(const std::vector<std::string>& paths);

    /// All files that the shot was read from.
    [[nodiscard]] std::vector<std::string> watched() const;

    struct DiskChanges {
        bool reloaded = false;  // a file without an open text changed, and is used as it is now
        bool assets = false;    // a mesh or an image changed
        std::vector<DiskChanged> conflicting{};  // files with another open text
        bool missing = false;  // a file does not exist: told the next time if that remains true
    };

    /// Reads the files again. The text of a file that was deleted remains as an open text.
    [[nodiscard]] DiskChanges look_at_disk();

    /// The open texts that differ from the files on disk, with the hashes of those.
    [[nodiscard]] std::vector<RecoveredText> unsaved() const;

    /// Those of the texts that belong to files that may be written and that differ from the files
    /// as they are now, with the hashes of those.
    [[nodiscard]] std::vector<RecoveredText> recoverable(std::vector<RecoveredText> texts) const;

    /// Those of the texts whose files may not be written by a session with this root.
    [[nodiscard]] std::vector<RecoveredText> unreachable(std::vector<RecoveredText> texts) const;

    /// Opens texts of files that may be written. Returns whether there was one.
    bool recover(const std::vector<RecoveredText>& texts);

  private:
    struct DiskFile {
        std::string text{};
        std::string hash{};        // empty: it cannot be read
        std::string problem{};     // why it cannot, as the end of a sentence
        std::uint64_t device = 0;  // that it is on
        std::uint64_t node = 0;    // its number there, which it keeps when it gets another name
    };

    /// What tells whether a file that is not a text changed.
    struct Stamp {
        std::int64_t time = 0;  // of its last change, ns; 0: it does not exist
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };

    using Assets = std::map<std::string, Stamp>;  // by their paths, as they were last looked at

    [[nodiscard]] static DiskFile read(const std::string& path);
    [[nodiscard]] static bool replace(Assets& stamps, Assets now);
    [[nodiscard]] static Stamp stamp_of(const std::string& path);
    static void note_node(const std::string& path, DiskFile& file);
    void take_from_disk(const std::string& file, DiskChanges& changes);
    [[nodiscard]] static DiskChanged gone(const std::string& file, const DiskFile& before,
                                          const DiskFile& now);
    void require_writable(const std::string& file) const;
    [[nodiscard]] bool is_known(const std::string& file) const;
    [[nodiscard]] std::int64_t next_version(std::int64_t v);
    void change_text(const std::string& file, const std::optional<std::string>& text);

    std::string shot_;
    std::string root_;
    std::int64_t version_ = 1;
    std::vector<pipeline::ReadFile> files_;
    std::map<std::string, DiskFile> disk_;  // as they were last read or written
    std::set<std::string> missing_;         // files that did not exist at the last look
    Assets assets_;
    Assets sought_;  // files that do not exist, but are named
    std::shared_ptr<const pipeline::config::OpenTexts> texts_;
};

}  // namespace carom::studio
