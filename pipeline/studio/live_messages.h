// What a live shot tells the pages of a version.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/config/load_shot.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/shot/shot.h"
#include "pipeline/studio/live_shot.h"
#include "pipeline/studio/messages.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// For the thread of a live shot.
class LiveMessages {
  public:
    /// Refers to the output. `root`: the folder below which the shot's files are.
    LiveMessages(const LiveOutput& output, std::string root)
        : output_(output), root_(std::move(root)) {}

    /// The problems of the texts of a version. `complete`: no others will follow.
    void tell_problems(std::int64_t v, const pipeline::LoadResult& loaded, bool complete);

    /// Tells those that are known again: there are no others.
    void complete_problems(std::int64_t v);

    /// Adds the problems of the motion: then they are complete.
    void add_motion_problems(std::int64_t v, const pipeline::Shot& shot,
                             const pipeline::LoadResult& loaded, const sim::Timeline& timeline);

    /// The page shows the shot before its motion is known: everything stands as at the start.
    void show_at_rest(std::int64_t v, const pipeline::Shot& shot,
                      const pipeline::ShotSource& source);

    /// The shot with its motion. `kept`: the motion is that of the version before; `start`: the
    /// thread's CPU time when the texts were taken, s.
    void show(std::int64_t v, const pipeline::Shot& shot, const pipeline::ShotSource& source,
              const sim::Timeline& timeline, bool kept, double start);

    /// The pages show something else than a shot: they do not keep its cameras.
    void forget_cameras() { has_cameras_ = false; }

    /// The motion follows later during the drag, or when it ends.
    void defer_during_drag(std::int64_t v);

    /// The motion follows when the user asks for it.
    void defer_to_button(std::int64_t v);

  private:
    const LiveOutput& output_;
    std::string root_;
    std::vector<Problem> problems_;
    std::vector<double> cameras_;  // as they were last sent
    bool has_cameras_ = false;
};

}  // namespace carom::studio
