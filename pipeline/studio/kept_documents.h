// The documents that were made last, for pages that GET them.
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "pipeline/studio/messages.h"
#include "pipeline/studio/session.h"

namespace carom::studio {

/// All functions may be called from any thread.
class KeptDocuments {
  public:
    /// Keeps bytes of a version of the texts (0: of the files on disk). `extension`: that of such a
    /// file, ".svg".
    [[nodiscard]] Made keep(const Make& request, std::int64_t v, const std::string& extension,
                            std::string bytes);

    /// Keeps the path of a file that was written.
    [[nodiscard]] Made keep_file(const Make& request, const std::string& file);

    /// What was kept at "/made/…"; of older documents nothing is kept.
    [[nodiscard]] std::optional<Download> find(std::string_view address);

  private:
    [[nodiscard]] Made add(const Make& request, const std::string& extension, Download download);

    std::mutex mutex_;
    int number_ = 1;                                     // of the next one
    std::deque<std::pair<std::string, Download>> kept_;  // by their addresses
};

}  // namespace carom::studio
