#include "pipeline/studio/scene_annotations.h"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "pipeline/picture/text_extents.h"
#include "pipeline/studio/annotations_message.h"

namespace carom::studio {

class SceneAnnotations::Worker {
  public:
    Worker(SendNumbers answer, Send failed)
        : answer_(std::move(answer)), failed_(std::move(failed)) {
        thread_ = std::jthread([this](const std::stop_token& end) { run(end); });
    }

    void set_shot(std::shared_ptr<const pipeline::Shot> shot,
                  std::shared_ptr<const sim::Timeline> timeline, std::int64_t v) {
        const std::lock_guard lock(mutex_);
        shot_ = std::move(shot);
        timeline_ = std::move(timeline);
        v_ = v;
        if (!shot_) {
            questions_.clear();
        }
        wake_.notify_one();
    }

    void ask(PageId page, const SeeAnnotations& question) {
        const std::lock_guard lock(mutex_);
        questions_[page] = question;
        wake_.notify_one();
    }

    void cancel(PageId page) {
        const std::lock_guard lock(mutex_);
        questions_.erase(page);
    }

  private:
    struct Job {
        PageId page = 0;
        SeeAnnotations question;
        std::shared_ptr<const pipeline::Shot> shot;
        std::shared_ptr<const sim::Timeline> timeline;
        std::int64_t v = 0;
    };

    /// With the mutex: the next question that can be answered.
    [[nodiscard]] auto next() {
        return std::ranges::find_if(
            questions_, [&](const auto& entry) { return shot_ && entry.second.v <= v_; });
    }

    /// Empty at the end.
    std::optional<Job> wait_for_job(const std::stop_token& end) {
        std::unique_lock lock(mutex_);
        if (!wake_.wait(lock, end, [&] { return next() != questions_.end(); }) ||
            end.stop_requested()) {
            return std::nullopt;
        }
        const auto found = next();
        Job job{found->first, found->second, shot_, timeline_, v_};
        questions_.erase(found);
        return job;
    }

    void run(const std::stop_token& end) {
        pipeline::TextExtents extents;
        while (const std::optional<Job> job = wait_for_job(end)) {
            try {
                Numbers<AnnotationsHead> message =
                    annotations_message(*job->shot, *job->timeline, job->question, extents);
                message.head.v = job->v;
                answer_(job->page, message.head, message.numbers);
            } catch (const std::exception& error) {
                failed_(job->page, Failed{SeeAnnotations::kName, job->v, error.what()});
            }
        }
    }

    SendNumbers answer_;
    Send failed_;

    std::mutex mutex_;  // of the members below
    std::condition_variable_any wake_;
    std::map<PageId, SeeAnnotations> questions_;
    std::shared_ptr<const pipeline::Shot> shot_;
    std::shared_ptr<const sim::Timeline> timeline_;
    std::int64_t v_ = 0;

    std::jthread thread_;  // ends first
};

SceneAnnotations::SceneAnnotations(SendNumbers answer, Send failed)
    : worker_(std::make_unique<Worker>(std::move(answer), std::move(failed))) {}

SceneAnnotations::~SceneAnnotations() = default;

void SceneAnnotations::set_shot(std::shared_ptr<const pipeline::Shot> shot,
                                std::shared_ptr<const sim::Timeline> timeline, std::int64_t v) {
    worker_->set_shot(std::move(shot), std::move(timeline), v);
}

void SceneAnnotations::ask(PageId page, const SeeAnnotations& question) {
    worker_->ask(page, question);
}

void SceneAnnotations::cancel(PageId page) {
    worker_->cancel(page);
}

}  // namespace carom::studio
