// How sure the outcome of a shot is: the same shot several times, with small disturbances.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "pipeline/shot/shot.h"
#include "pipeline/studio/message_lists.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// Simulates in a thread of its own. All functions may be called from any thread.
class OutcomeFan {
  public:
    /// Called from that thread.
    using Send = std::function<void(const ServerMessage& message)>;
    using SendNumbers =
        std::function<void(const FanHead& head, const std::vector<double>& numbers)>;

    OutcomeFan(SendNumbers answer, Send failed);
    /// Stops all work and waits for its end.
    ~OutcomeFan();
    OutcomeFan(const OutcomeFan&) = delete;
    OutcomeFan& operator=(const OutcomeFan&) = delete;
    OutcomeFan(OutcomeFan&&) = delete;
    OutcomeFan& operator=(OutcomeFan&&) = delete;

    /// The newest shot and its motion.
    void set_shot(std::shared_ptr<const pipeline::Shot> shot,
                  std::shared_ptr<const sim::Timeline> timeline, std::int64_t v);

    /// The newest question is the only one. It waits for the shot of its version.
    void ask(const Fan& question);

    /// Ends the question and stops its work.
    void cancel();

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace carom::studio
