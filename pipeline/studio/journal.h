// Unsaved texts in the cache, for when the studio ends unexpectedly.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/studio/messages.h"

namespace carom::studio {

struct JournalOptions {
    std::string folder{};                       // it is made if it does not exist
    std::chrono::milliseconds interval{2'000};  // from one writing to the next
};

/// The journal of one shot. Several studios may have the same shot open: each has a file of its
/// own. A journal that cannot be written is none; nothing else fails then.
class Journal {
  public:
    Journal(const std::string& shot, const JournalOptions& options);
    /// Writes what waits. The file of texts that are not saved remains.
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;
    Journal(Journal&&) = delete;
    Journal& operator=(Journal&&) = delete;

    /// The texts that a studio left behind, with the hashes of the files from which they were made.
    [[nodiscard]] const std::vector<RecoveredText>& found() const { return found_; }

    /// What the file is to hold from now on; it is written soon. Empty: there is no file.
    void keep(std::vector<RecoveredText> texts);

  private:
    class Writer;
    std::vector<RecoveredText> found_;
    std::unique_ptr<Writer> writer_;  // null: there is no journal
};

}  // namespace carom::studio
