#include "pipeline/studio/sequence_pictures.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace carom::studio {

void SequencePictures::set(std::optional<SequenceAnswer> answer) {
    if (answer || answer_) {
        view_.set_shot(nullptr, nullptr, 0);
    }
    answer_ = std::move(answer);
    shown_.reset();
    if (answer_) {
        for (const auto& [page, question] : questions_) {
            if (question.frame) {
                ask_frame(page, question);
            }
        }
    }
}

void SequencePictures::clear() {
    questions_.clear();
    set({});
}

void SequencePictures::ask(PageId page, const See& question) {
    questions_[page] = question;  // also before the film is read and simulated
    if (answer_) {
        ask_frame(page, question);
    } else {
        view_.ask(page, question);
    }
}

/// Gives the view the shot of a part. False if that has not been simulated.
bool SequencePictures::show(std::size_t part) {
    if (shown_ == part || !answer_->timelines[part]) {
        return shown_ == part;
    }
    const auto& shot = std::get<pipeline::ShotPart>(answer_->sequence->parts[part].content).shot;
    view_.cancel_all();
    view_.set_shot(std::shared_ptr<const pipeline::Shot>(answer_->sequence, &shot),
                   answer_->timelines[part], answer_->v);
    shown_ = part;
    return true;
}

void SequencePictures::ask_frame(PageId page, const See& question) {
    const pipeline::Sequence& sequence = *answer_->sequence;
    if (!question.frame || *question.frame < 0) {
        output_.fail(page, "a picture of a film of several shots is one of its frames");
        return;
    }
    const std::vector<pipeline::SequenceLayer> layers = pipeline::layers_of(
        sequence, std::min(*question.frame, sequence.frames() - 1));  // it may have become shorter
    const pipeline::SequenceLayer& layer =
        *std::ranges::max_element(layers, {}, &pipeline::SequenceLayer::weight);
    const auto& content = sequence.parts[layer.part].content;
    if (const auto* card = std::get_if<pipeline::TitleCard>(&content)) {
        view_.cancel(page);
        PictureHead head;
        head.q = question.q;
        head.v = answer_->v;
        head.width = sequence.width;
        head.height = sequence.height;
        head.complete = true;
        output_.draw(page, *card, head);
        return;
    }
    if (!show(layer.part)) {
        output_.fail(page,
                     "simulating this shot takes longer than happens by itself; open it to see it");
        return;
    }
    See own = question;
    own.frame = std::get<pipeline::ShotPart>(content).first + layer.frame;
    view_.ask(page, std::move(own));
}

void SequencePictures::cancel(PageId page) {
    questions_.erase(page);
    view_.cancel(page);
}

}  // namespace carom::studio
