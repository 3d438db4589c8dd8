#include "pipeline/job/picture_memory.h"

#include <algorithm>

namespace carom::pipeline {
namespace {

std::uint64_t size_of(const render::Film& film) {
    std::uint64_t floats = film.rgba.size();
    for (const render::Channel& channel : film.aovs) {
        floats += channel.values.size();
    }
    return floats * sizeof(float);
}

}  // namespace

PictureMemory::PictureMemory(const FilmPlan& plan, std::size_t passes, std::uint64_t limit)
    : plan_(plan),
      steps_(passes * plan.frames.size()),
      limit_(limit),
      frames_of_(plan.pictures.size()) {
    for (std::size_t i = 0; i < plan.frames.size(); ++i) {
        frames_of_[plan.picture_of[i]].push_back(i);
        if (const FilmPlan::Blend* blend = plan.blend_of(i)) {
            frames_of_[blend->picture].push_back(i);
        }
    }
}

bool PictureMemory::shows(std::size_t step, std::size_t picture) const {
    const std::size_t frame = step % plan_.frames.size();
    const FilmPlan::Blend* blend = plan_.blend_of(frame);
    return plan_.picture_of[frame] == picture || (blend != nullptr && blend->picture == picture);
}

void PictureMemory::go_to(std::size_t picture) {
    while (step_ + 1 < steps_ && !shows(step_, picture)) {
        ++step_;
    }
}

std::size_t PictureMemory::next_use(std::size_t picture) const {
    const std::vector<std::size_t>& frames = frames_of_[picture];
    const std::size_t frame = step_ % plan_.frames.size();
    const std::size_t pass_begin = step_ - frame;
    const auto next = std::ranges::upper_bound(frames, frame);
    if (next != frames.end()) {
        return pass_begin + *next;
    }
    return std::min(steps_, pass_begin + plan_.frames.size() + frames.front());
}

void PictureMemory::drop(std::size_t picture) {
    const auto found = kept_.find(picture);
    bytes_ -= found->second.bytes;
    kept_.erase(found);
}

std::optional<render::Film> PictureMemory::find(std::size_t picture) {
    go_to(picture);
    const auto found = kept_.find(picture);
    if (found == kept_.end()) {
        return std::nullopt;
    }
    if (next_use(picture) < steps_) {
        return found->second.film;
    }
    std::optional<render::Film> film = std::move(found->second.film);
    drop(picture);
    return film;
}

void PictureMemory::keep(std::size_t picture, const render::Film& film) {
    go_to(picture);
    if (next_use(picture) >= steps_) {
        return;
    }
    const std::uint64_t bytes = size_of(film);
    kept_.insert_or_assign(picture, Kept{film, bytes});
    bytes_ += bytes;
    while (bytes_ > limit_) {
        const auto last = std::ranges::max_element(
            kept_, {}, [this](const auto& entry) { return next_use(entry.first); });
        drop(last->first);
    }
}

}  // namespace carom::pipeline
