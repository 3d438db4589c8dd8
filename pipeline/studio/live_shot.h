// Answers the newest texts of a shot: problems, what the page draws, cameras and motion. One thread
// of its own does the work.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "pipeline/config/config_files.h"
#include "pipeline/config/load_shot.h"
#include "pipeline/config/shot_source.h"
#include "pipeline/sequence/sequence.h"
#include "pipeline/shot/shot.h"
#include "pipeline/studio/message_lists.h"
#include "sim/timeline/timeline.h"

namespace carom::studio {

/// The texts of one version.
struct TextsOfVersion {
    std::int64_t v = 0;
    std::string shot;                                          // the path of its file
    std::shared_ptr<const pipeline::config::OpenTexts> texts;  // before the files on disk
};

/// A version without errors, with its motion.
struct LiveAnswer {
    std::int64_t v = 0;
    std::shared_ptr<const pipeline::Shot> shot;
    std::shared_ptr<const pipeline::ShotSource> source;
    std::shared_ptr<const sim::Timeline> timeline;  // with the keyed motions
};

/// A version of a film of several shots without errors, with the motions of its shots.
struct SequenceAnswer {
    std::int64_t v = 0;
    std::shared_ptr<const pipeline::Sequence> sequence;  // its moments have their times
    /// Of each part, with the keyed motions; null for title cards, and for shots that take too long
    /// to simulate.
    std::vector<std::shared_ptr<const sim::Timeline>> timelines;
};

/// Called from the thread of the live shot, one call at a time. `shown` is called before `answer`,
/// and also without it if the simulation is deferred or takes long.
struct LiveOutput {
    std::function<void(ServerMessage)> text;
    std::function<void(BinaryHead, std::vector<double>)> binary;
    std::function<void(std::int64_t v, const std::vector<pipeline::ReadFile>& read,
                       const std::vector<std::string>& missing)>
        files;
    std::function<void(std::int64_t v, const pipeline::Shot& shot)> shown;
    std::function<void(LiveAnswer)> answer;
    std::function<void(SequenceAnswer)> sequence;  // in the stead of both
};

struct LiveOptions {
    std::vector<std::string> overrides{};
    std::string quality{};
    std::string root{};            // the folder below which the shot's files are
    std::string answers_folder{};  // where strikes that `solve` found are kept; empty: nowhere
    /// Steps as sim::bake_within counts them.
    std::uint64_t most_steps = 15'000'000;
    /// The largest size of a mesh or an image that the shot may name.
    std::uintmax_t most_asset_bytes = std::uintmax_t{128} << 20U;
    /// Processor time of the calling thread, s; tests give their own.
    std::function<double()> clock{};
    /// Replaces sim::bake_within in tests.
    std::function<std::optional<sim::Timeline>(
        std::uint64_t most_steps, const sim::WorldDescription& world, const WorkContext& context)>
        bake{};
};

/// All functions may be called from any thread, and return without waiting for work.
class LiveShot {
  public:
    LiveShot(LiveOptions options, LiveOutput output);
    /// Stops all work and waits for its end.
    ~LiveShot();
    LiveShot(const LiveShot&) = delete;
    LiveShot& operator=(const LiveShot&) = delete;
    LiveShot(LiveShot&&) = delete;
    LiveShot& operator=(LiveShot&&) = delete;

    /// Texts to answer. Older ones that still wait are dropped, and a search for strikes for them
    /// is stopped. A simulation that has taken more than 0.1 s of processor time is stopped for
    /// them, except if the one before it was stopped, too, so that answers keep coming.
    void offer(TextsOfVersion texts);

    /// During a drag, a shot whose simulation takes more than 0.3 s of processor time is simulated
    /// half a second after the end of the last one; after the drag, at once.
    void set_dragging(bool on);

    /// Simulates the newest texts without the limit of steps.
    void simulate();

  private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace carom::studio
