#include "pipeline/studio/live_shot.h"

#include <iterator>
#include <limits>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

#include "core/cpu_time.h"
#include "core/error.h"
#include "pipeline/check/file_check.h"
#include "pipeline/job/film_job.h"
#include "pipeline/picture/lit_annotations.h"
#include "pipeline/solve/answers.h"
#include "pipeline/studio/live_bake.h"
#include "pipeline/studio/live_messages.h"
#include "pipeline/studio/live_requests.h"
#include "pipeline/studio/live_sequence.h"
#include "sim/bake.h"
#include "sim/billiards/table_memo.h"

namespace carom::studio {

namespace {

constexpr std::uintmax_t kMostBytesRead = 8'000'000;

LiveOptions with_defaults(LiveOptions options) {
    if (!options.clock) {
        options.clock = thread_cpu_seconds;
    }
    if (!options.bake) {
        options.bake = sim::bake_within;
    }
    return options;
}

}  // namespace

class LiveShot::Worker {
  public:
    Worker(LiveOptions options, LiveOutput output)
        : options_(with_defaults(std::move(options))),
          output_(std::move(output)),
          messages_(output_, options_.root),
          sequence_(output_, options_.root),
          bake_(options_.clock),
          requests_(bake_) {
        answers_.folder.path = options_.answers_folder;
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    ~Worker() {
        thread_.request_stop();
        bake_.end();
        const std::lock_guard lock(search_mutex_);
        search_.request_stop();
    }

    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    Worker(Worker&&) = delete;
    Worker& operator=(Worker&&) = delete;

    void offer(TextsOfVersion texts) {
        const std::lock_guard lock(search_mutex_);  // their own search begins after this
        requests_.offer(std::move(texts));
        search_.request_stop();
    }
    void set_dragging(bool on) { requests_.set_dragging(on); }
    void simulate() { requests_.simulate(); }

  private:
    void run(const std::stop_token& end) {
        while (const std::optional<LiveRequest> request = requests_.next(end)) {
            try {
                answer(*request);
            } catch (const Stopped&) {
                if (is_search_told_) {
                    output_.text(Work{});
                }
                continue;
            } catch (const std::exception& error) {
                fail(*request, error.what());
            }
        }
    }

    /// `solve` takes seconds, for which newer texts do not wait: the search for those of that
    /// version can be stopped from now on.
    void begin_search(std::int64_t v) {
        const std::lock_guard lock(search_mutex_);
        search_ = std::stop_source();
        if (requests_.has_newer()) {
            search_.request_stop();
        }
        is_search_told_ = false;
        answers_.parts.context = {
            [this, v](double fraction) {
                is_search_told_ = fraction < 1;
                output_.text(is_search_told_ ? Work{"solve", v, fraction} : Work{});
            },
            search_.get_token()};
    }

    void fail(const LiveRequest& request, const std::string& message) {
        output_.text(Failed{"bake", request.texts.v, message});
        messages_.complete_problems(request.texts.v);
    }

    void answer(const LiveRequest& request) {
        const double start = thread_cpu_seconds();
        const std::int64_t v = request.texts.v;
        begin_search(v);
        if (sequence_.takes(request.texts)) {
            timeline_.reset();
            messages_.forget_cameras();
            sequence_.answer(v, load_options(request.texts),
                             [&](const auto& world) { return bake(request, world); });
            return;
        }
        pipeline::LoadResult loaded = load(request.texts);
        add_file_problems(loaded);
        output_.files(v, loaded.files, loaded.missing);
        messages_.tell_problems(v, loaded, !loaded.shot);
        if (!loaded.shot) {
            return;
        }
        const auto shot = std::make_shared<pipeline::Shot>(std::move(*loaded.shot));
        const Hash128 hash = sim::physics_hash(shot->world);
        const bool kept = timeline_.has_value() && hash == baked_;
        if (!kept && (!timeline_ || bake_.was_slow())) {
            messages_.show_at_rest(v, *shot, *loaded.source);
        }
        if (!kept && !simulate(request, *shot, hash)) {
            return;
        }
        sim::Bake bake;
        bake.timeline = *timeline_;
        pipeline::add_keyed_motions(bake, *shot);
        const auto timeline = std::make_shared<const sim::Timeline>(std::move(bake.timeline));
        if (!resolve_moments(v, *shot, loaded, *timeline)) {
            return;
        }
        pipeline::add_lit_annotations(*shot, *timeline);
        messages_.show(v, *shot, *loaded.source, *timeline, kept, start);
        output_.answer({v, shot, loaded.source, timeline});
        if (!requests_.has_newer()) {
            messages_.add_motion_problems(v, *shot, loaded, *timeline);
        }
    }

    /// Gives the moments of the shot their times. False if one never comes, which the page is told.
    bool resolve_moments(std::int64_t v, pipeline::Shot& shot, pipeline::LoadResult& loaded,
                         const sim::Timeline& timeline) {
        std::vector<pipeline::Problem> found =
            pipeline::resolve_moments(shot, loaded.source, timeline, &tables_);
        if (found.empty()) {
            return true;
        }
        const bool is_usable = !pipeline::has_errors(found);
        std::move(found.begin(), found.end(), std::back_inserter(loaded.problems));
        messages_.tell_problems(v, loaded, !is_usable);
        return is_usable;
    }

    /// Bakes the world into timeline_. False if it is left for later, which the page is told.
    bool simulate(const LiveRequest& request, const pipeline::Shot& shot, const Hash128& hash) {
        const std::int64_t v = request.texts.v;
        if (!request.unlimited && requests_.defer(timeline_.has_value())) {
            messages_.defer_during_drag(v);
            return false;
        }
        std::optional<sim::Timeline> timeline;
        if (request.unlimited || too_long_ != hash) {
            timeline = bake(request, shot.world);
        }
        if (!timeline) {
            too_long_ = hash;
            messages_.defer_to_button(v);
            return false;
        }
        timeline_ = std::move(timeline);
        baked_ = hash;
        return true;
    }

    /// Empty if the simulation takes too many steps. Throws Stopped if newer texts wait.
    std::optional<sim::Timeline> bake(const LiveRequest& request,
                                      const sim::WorldDescription& world) {
        bool has_reported = false;
        std::int64_t looked_at = request.texts.v;
        const WorkContext context{.progress =
                                      [&](double fraction) {
                                          stop_if_outdated(request, world, looked_at);
                                          if (bake_.takes_long()) {
                                              has_reported = true;
                                              output_.text(Work{"bake", request.texts.v, fraction});
                                          }
                                      },
                                  .stop = bake_.begin(request.unlimited)};
        const auto finish = [&](bool stopped) {
            bake_.finish(stopped);
            if (has_reported) {
                output_.text(Work{});
            }
        };
        std::optional<sim::Timeline> timeline;
        try {
            timeline = options_.bake(
                request.unlimited ? std::numeric_limits<std::uint64_t>::max() : options_.most_steps,
                world, context);
        } catch (const Stopped&) {
            finish(true);
            throw;
        } catch (...) {
            finish(false);
            throw;
        }
        finish(false);
        return timeline;
    }

    void stop_if_outdated(const LiveRequest& request, const sim::WorldDescription& world,
                          std::int64_t& looked_at) {
        if (request.unlimited) {
            stop_for_other_world(world, looked_at);
        } else if (requests_.has_newer()) {
            bake_.stop_for_newer();
        }
    }

    /// A simulation that the user asked for, which may take minutes, is stopped by texts with
    /// another world only: not by those that are being typed and have errors, nor by an edit of a
    /// camera. `looked_at`: the newest version that was compared.
    void stop_for_other_world(const sim::WorldDescription& world, std::int64_t& looked_at) {
        const std::optional<TextsOfVersion> newer = requests_.other_than(looked_at);
        if (!newer) {
            return;
        }
        looked_at = newer->v;
        const pipeline::LoadResult loaded = load(*newer);
        if (loaded.shot && sim::physics_hash(loaded.shot->world) != sim::physics_hash(world)) {
            bake_.stop();
        }
    }

    pipeline::LoadResult load(const TextsOfVersion& texts) {
        return pipeline::load_shot(texts.shot, load_options(texts));
    }

    /// Large files are read by their headers, so that the page does not wait for them.
    void add_file_problems(pipeline::LoadResult& loaded) {
        pipeline::FileCheckOptions options;
        options.most_bytes = kMostBytesRead;
        pipeline::FileReport report = files_.check(loaded.named_files, options);
        std::move(report.problems.begin(), report.problems.end(),
                  std::back_inserter(loaded.problems));
    }

    pipeline::LoadOptions load_options(const TextsOfVersion& texts) {
        return {.overrides = options_.overrides,
                .quality = options_.quality,
                .root = options_.root,
                .texts = texts.texts.get(),
                .most_asset_bytes = options_.most_asset_bytes,
                .tables = &tables_,
                .answers = &answers_};
    }

    LiveOptions options_;
    LiveOutput output_;
    LiveMessages messages_;  // of the thread
    LiveSequence sequence_;  // as well
    LiveBake bake_;
    LiveRequests requests_;

    std::mutex search_mutex_;  // of the next one; taken before that of the requests
    std::stop_source search_;

    // Of the thread.
    pipeline::solve::AnswerWork answers_;
    bool is_search_told_ = false;  // to the page
    sim::billiards::TableMemo tables_;
    pipeline::FileChecker files_;
    std::optional<sim::Timeline> timeline_;  // without keyed motions
    Hash128 baked_;
    std::optional<Hash128> too_long_;

    std::jthread thread_;
};

LiveShot::LiveShot(LiveOptions options, LiveOutput output)
    : worker_(std::make_unique<Worker>(std::move(options), std::move(output))) {}

LiveShot::~LiveShot() = default;

void LiveShot::offer(TextsOfVersion texts) {
    worker_->offer(std::move(texts));
}

void LiveShot::set_dragging(bool on) {
    worker_->set_dragging(on);
}

void LiveShot::simulate() {
    worker_->simulate();
}

}  // namespace carom::studio
