// Which documents are still wanted, and the program that makes one of them.
#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <utility>

#include "pipeline/studio/child_program.h"
#include "pipeline/studio/session.h"

namespace carom::studio {

using AskedDocument = std::pair<PageId, std::int64_t>;  // with the number of the question

/// All functions may be called from any thread.
class WantedDocuments {
  public:
    /// `writes`: a file, which somebody else may wait for.
    void add(const AskedDocument& asked, bool writes);
    void remove(const AskedDocument& asked);

    /// The page does not want it any more: its program is interrupted.
    void stop(const AskedDocument& asked);

    /// Nobody can look at what a closed page asked for; its exports are finished.
    void closed(PageId page);

    /// Nothing is wanted any more.
    void end();

    /// Throws Error if it is not wanted any more.
    void require(const AskedDocument& asked);

    /// While it lives, the program makes what was asked for, and is interrupted when that is not
    /// wanted. Only one at a time.
    class Running {
      public:
        Running(WantedDocuments& wanted, const AskedDocument& asked, ChildProgram& child);
        ~Running();
        Running(const Running&) = delete;
        Running& operator=(const Running&) = delete;
        Running(Running&&) = delete;
        Running& operator=(Running&&) = delete;

      private:
        WantedDocuments& wanted_;
    };

  private:
    [[nodiscard]] bool is_wanted(const AskedDocument& asked) const;

    std::mutex mutex_;  // of all members
    std::set<AskedDocument> wanted_;
    std::set<AskedDocument> exports_;  // of these, those that write a file
    ChildProgram* child_ = nullptr;
    AskedDocument child_asked_;
    bool is_ending_ = false;
};

}  // namespace carom::studio
