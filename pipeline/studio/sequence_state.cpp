#include "pipeline/studio/sequence_state.h"

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "pipeline/camera/frame_plan.h"
#include "pipeline/studio/paths.h"

namespace carom::studio {

namespace {

FilmPart part_message(const pipeline::SequencePart& part) {
    FilmPart message;
    message.frames = part.frames;
    message.fade = part.fade;
    if (const auto* card = std::get_if<pipeline::TitleCard>(&part.content)) {
        message.kind = "title";
        message.name = card->text;
        return message;
    }
    const auto& shot = std::get<pipeline::ShotPart>(part.content);
    message.kind = "shot";
    message.file = shot.bake ? "" : whole_path(shot.path);
    message.name = std::filesystem::path(shot.path).filename().string();
    message.first = shot.first;
    message.of_frames = pipeline::frame_count(shot.shot.cameras, shot.shot.timing);
    return message;
}

}  // namespace

SequenceState sequence_state(const pipeline::Sequence& sequence) {
    SequenceState state;
    state.name = sequence.name;
    state.film.width = sequence.width;
    state.film.height = sequence.height;
    state.film.fps = sequence.fps.to_double();
    state.film.frames = sequence.frames();
    state.film.duration = static_cast<double>(sequence.frames()) / sequence.fps.to_double();
    const std::vector<std::int64_t> starts = sequence.starts();
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        FilmPart message = part_message(sequence.parts[i]);
        message.path = {"film", "shots", std::to_string(i)};
        message.start = starts[i];
        state.parts.push_back(std::move(message));
    }
    return state;
}

}  // namespace carom::studio
