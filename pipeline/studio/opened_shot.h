// The open shot of a session: its files, and the journal of what is not saved.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pipeline/studio/journal.h"
#include "pipeline/studio/messages.h"
#include "pipeline/studio/workspace.h"

namespace carom::studio {

/// Not thread-safe: it belongs to the session's mutex.
class OpenedShot {
  public:
    /// Throws Error if the file cannot be read. `root`: as in Workspace.
    OpenedShot(const std::string& path, const std::string& root) : files_(path, root) {}

    /// Finds the texts that a studio left behind in a journal below the folder of the cache (empty:
    /// the usual one), and begins one. To be called once, when no other journal of the same shot is
    /// open in this session.
    void open_journal(const std::string& cache_folder);

    [[nodiscard]] Workspace& files() { return files_; }
    [[nodiscard]] const Workspace& files() const { return files_; }

    /// The texts that are offered to the pages, until one says whether they are to be used.
    [[nodiscard]] const std::vector<RecoveredText>& recovered() const { return recovered_; }

    /// A page said whether they are to be used. Returns whether a text was opened.
    bool recover(bool use);

    /// The journal gets the texts that are not saved, those of which it is not known yet whether
    /// they are to be used, and those that only a studio with another root can use.
    void keep_unsaved();

    /// The texts of the other files of the shot that are not saved.
    [[nodiscard]] std::vector<RecoveredText> unsaved_of_others() const;

    /// What is not saved is kept elsewhere now: the journal gets only what nobody has decided on.
    void keep_undecided();

  private:
    Workspace files_;
    std::unique_ptr<Journal> journal_;
    std::vector<RecoveredText> recovered_;
    std::vector<RecoveredText> unreachable_;  // for files that are not writable here
};

}  // namespace carom::studio
