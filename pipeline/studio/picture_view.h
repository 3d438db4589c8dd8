// The path-traced pictures in the views of the studio's pages: each page has one question, its
// newest, and a thread of its own answers them, the newest first.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "pipeline/studio/picture_rounds.h"
#include "pipeline/studio/session.h"

namespace carom::studio {

struct PictureOptions {
    std::string cache_folder;
    int threads = 0;  // 0: one per processor
    /// From a change to the work on it, so that a row of changes starts no work in between.
    std::chrono::milliseconds restart_delay{40};
};

/// Why pictures wait.
enum class Hold : std::uint8_t {
    dragging,  // a pointer drags something
    texts,     // newer texts are read and simulated: the answer to them comes first
};

/// All functions may be called from any thread, and return without waiting for work.
class PictureView {
  public:
    /// Called from the view's thread, one call at a time, with the page that asked. It must not
    /// call the view.
    using Send = std::function<void(PageId, Picture)>;

    PictureView(Send send, PictureOptions options);
    ~PictureView();
    PictureView(const PictureView&) = delete;
    PictureView& operator=(const PictureView&) = delete;
    PictureView(PictureView&&) = delete;
    PictureView& operator=(PictureView&&) = delete;

    /// All questions are answered again, for this shot; samples of the last one are kept if only
    /// its view differs.
    void set_shot(std::shared_ptr<const pipeline::Shot> shot,
                  std::shared_ptr<const sim::Timeline> timeline, std::int64_t version);

    /// Once it returns, no picture of an earlier question of this page is sent any more.
    void ask(PageId page, See question);
    /// Once it returns, no picture is sent to this page until its next question.
    void cancel(PageId page);
    /// Ends the questions of all pages.
    void cancel_all();

    /// Pictures wait while one of the reasons holds.
    void hold(Hold reason, bool holds);
    /// While a film is made, pictures take one thread and at most 16 samples.
    void set_film_running(bool running);

    /// Returns when all questions are answered, or they are held.
    void wait_until_idle();
    [[nodiscard]] PictureCounts counts() const;

  private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace carom::studio
