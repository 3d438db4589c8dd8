#include "pipeline/job/film_so_far.h"

#include <algorithm>
#include <optional>

#include "core/error.h"

namespace carom::pipeline {
namespace {

/// Builds a plan of the pictures that it is asked for.
class Selection {
  public:
    explicit Selection(const FilmPlan& plan) : plan_(plan), numbers_(plan.pictures.size()) {
        chosen_.frames = plan.frames;
    }

    /// The next frame shows frame `shown` of the old plan.
    void add(std::size_t shown) {
        const std::size_t index = chosen_.picture_of.size();
        const std::size_t picture = number_of(plan_.picture_of[shown]);
        chosen_.picture_of.push_back(picture);
        chosen_.pictures[picture].frames.push_back(plan_.frames[index]);
        if (const FilmPlan::Blend* blend = plan_.blend_of(shown)) {
            chosen_.blends[index] = {number_of(blend->picture), blend->weight};
        }
    }

    [[nodiscard]] FilmPlan take() { return std::move(chosen_); }

  private:
    std::size_t number_of(std::size_t old) {
        if (!numbers_[old]) {
            numbers_[old] = chosen_.pictures.size();
            chosen_.pictures.push_back(plan_.pictures[old]);
            chosen_.pictures.back().frames.clear();
        }
        return *numbers_[old];
    }

    const FilmPlan& plan_;
    FilmPlan chosen_;
    std::vector<std::optional<std::size_t>> numbers_;  // in the new plan, of the old pictures
};

}  // namespace

FilmPlan plan_so_far(const FilmPlan& plan, const std::function<bool(const Hash128&)>& is_stored) {
    std::vector<bool> has_picture;
    for (const FilmPlan::Picture& picture : plan.pictures) {
        has_picture.push_back(is_stored(picture.key));
    }
    const auto is_there = [&](std::size_t frame) {
        const FilmPlan::Blend* blend = plan.blend_of(frame);
        return has_picture[plan.picture_of[frame]] &&
               (blend == nullptr || has_picture[blend->picture]);
    };
    std::size_t shown = 0;
    while (shown < plan.frames.size() && !is_there(shown)) {
        ++shown;
    }
    if (shown == plan.frames.size()) {
        throw Error("none of the film's frames is rendered yet");
    }
    Selection selection(plan);
    for (std::size_t frame = 0; frame < plan.frames.size(); ++frame) {
        shown = is_there(frame) ? frame : shown;
        selection.add(shown);
    }
    return selection.take();
}

}  // namespace carom::pipeline
