// The files of a shot: the texts of the pages, which stand before those on disk, and what may be
// written.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
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

    /// Reads the files again. `reloaded`: those without an open text, which are used as they are
    /// now; `conflicting`: those with another one.
    struct DiskChanges {
        std::vector<TextChanged> reloaded;
        std::vector<DiskChanged> conflicting;
    };
    [[nodiscard]] DiskChanges look_at_disk();

  private:
    struct DiskFile {
        std::string text;
        std::string hash;  // empty: it does not exist
    };

    [[nodiscard]] static DiskFile read(const std::string& path);
    void require_writable(const std::string& file) const;
    [[nodiscard]] bool is_known(const std::string& file) const;
    [[nodiscard]] std::int64_t next_version(std::int64_t v);
    void change_text(const std::string& file, const std::optional<std::string>& text);

    std::string shot_;
    std::string root_;
    std::int64_t version_ = 1;
    std::vector<pipeline::ReadFile> files_;
    std::map<std::string, DiskFile> disk_;  // as they were last read or written
    std::shared_ptr<const pipeline::config::OpenTexts> texts_;
};

}  // namespace carom::studio
