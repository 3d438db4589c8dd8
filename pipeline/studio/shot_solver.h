// Finds strikes by what they shall do, and tells how sure a strike is, for the pages of a session.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/session.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// Works in a thread of its own. All functions may be called from any thread.
class ShotSolver {
  public:
    using Question = std::variant<SolveShot, Judge>;
    /// Called from that thread.
    using Send = std::function<void(PageId page, const ServerMessage& message)>;
    using SendNumbers = std::function<void(PageId page, const SolutionsHead& head,
                                           const std::vector<double>& numbers)>;

    ShotSolver(SendNumbers answer, Send send);
    /// Stops all work and waits for its end.
    ~ShotSolver();
    ShotSolver(const ShotSolver&) = delete;
    ShotSolver& operator=(const ShotSolver&) = delete;
    ShotSolver(ShotSolver&&) = delete;
    ShotSolver& operator=(ShotSolver&&) = delete;

    /// The newest shot and its motion; null: there is none.
    void set_shot(std::shared_ptr<const pipeline::Shot> shot,
                  std::shared_ptr<const sim::Timeline> timeline, std::int64_t v);

    /// The newest question of a page is its only one: the work for the one before is stopped. It
    /// waits for the shot of its version.
    void ask(PageId page, const Question& question);

    /// Ends the question of a page, or of all pages (0), and stops its work.
    void cancel(PageId page);

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace carom::studio
