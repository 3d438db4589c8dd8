// Tells pages what the annotations in the scene look like.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/message_lists.h"
#include "pipeline/studio/session.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// Works in a thread of its own. All functions may be called from any thread.
class SceneAnnotations {
  public:
    /// Called from that thread.
    using Send = std::function<void(PageId page, const ServerMessage& message)>;
    using SendNumbers = std::function<void(PageId page, const AnnotationsHead& head,
                                           const std::vector<double>& numbers)>;

    SceneAnnotations(SendNumbers answer, Send failed);
    /// Stops all work and waits for its end.
    ~SceneAnnotations();
    SceneAnnotations(const SceneAnnotations&) = delete;
    SceneAnnotations& operator=(const SceneAnnotations&) = delete;
    SceneAnnotations(SceneAnnotations&&) = delete;
    SceneAnnotations& operator=(SceneAnnotations&&) = delete;

    /// The newest shot and its motion; null: there is none, and questions are forgotten.
    void set_shot(std::shared_ptr<const pipeline::Shot> shot,
                  std::shared_ptr<const sim::Timeline> timeline, std::int64_t v);

    /// The newest question of a page is its only one. It waits for the shot of its version, and is
    /// answered with the newest one.
    void ask(PageId page, const SeeAnnotations& question);

    /// Forgets the question of a page.
    void cancel(PageId page);

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace carom::studio
