// Drawings, reports, pictures and exports of the open shot.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/document_kinds.h"
#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/session.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// Drawings and the report to look at are made here, of the shot as it was simulated last. Files
/// and rendered pictures are made by the program, one after the other, of the files on disk. All
/// functions may be called from any thread, and return without waiting.
class Documents {
  public:
    /// Sends to a page. Called from any thread. It must not call the documents.
    using Send = std::function<void(PageId page, const ServerMessage& message)>;

    Documents(ProgramOptions options, Send send);
    /// Stops what is being made.
    ~Documents();
    Documents(const Documents&) = delete;
    Documents& operator=(const Documents&) = delete;
    Documents(Documents&&) = delete;
    Documents& operator=(Documents&&) = delete;

    /// The shot and its motion of version `v`; null: there is none yet.
    void set_shot(std::shared_ptr<const pipeline::Shot> shot,
                  std::shared_ptr<const sim::Timeline> timeline, std::int64_t v);

    /// Throws Error if the request is not a valid one, or if too much was asked for.
    void make(PageId page, const Make& request, const std::string& shot, const std::string& root);

    /// Stops the program if it makes what this page asked for, or keeps it from being started. A
    /// drawing, or the report to look at, is made all the same.
    void stop(PageId page, std::int64_t q);

    /// Stops the program if it makes what this page wanted to look at. Its exports are finished.
    void closed(PageId page);

    /// What was made to look at, at "/made/…"; of older documents nothing is kept.
    [[nodiscard]] std::optional<Download> find(std::string_view address) const;

  private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::studio
