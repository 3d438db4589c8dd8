// The pictures of a film of several shots in the pages' views: those of its shots come from the
// view of pictures, title cards are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "pipeline/studio/live_shot.h"
#include "pipeline/studio/messages.h"
#include "pipeline/studio/picture_view.h"
#include "pipeline/studio/session.h"

namespace carom::studio {

/// Not thread-safe: it belongs to the session's mutex.
class SequencePictures {
  public:
    /// What the view does not do: called with the mutex, and must not wait.
    struct Output {
        /// Draws a title card and sends it to the page later.
        std::function<void(PageId page, const pipeline::TitleCard& card, const PictureHead& head)>
            draw;
        /// Tells a page why it gets no picture.
        std::function<void(PageId page, const std::string& why)> fail;
    };

    /// Refers to the view.
    SequencePictures(PictureView& view, Output output) : view_(view), output_(std::move(output)) {}

    /// A film without errors with the motion of its shots: all questions are answered again. Empty:
    /// a shot is open, to which the questions are passed on.
    void set(std::optional<SequenceAnswer> answer);

    /// Neither is open, and nothing is asked any more.
    void clear();

    /// Asks for a frame of the film, or for a picture of the shot. In a fade the picture is that of
    /// the part which has more weight. One page's question about another shot ends those of the
    /// others.
    void ask(PageId page, const See& question);
    void cancel(PageId page);

  private:
    [[nodiscard]] bool show(std::size_t part);

    void ask_frame(PageId page, const See& question);

    PictureView& view_;
    Output output_;
    std::optional<SequenceAnswer> answer_;
    std::optional<std::size_t> shown_;  // the part of which the view has the shot
    std::map<PageId, See> questions_;
};

}  // namespace carom::studio
