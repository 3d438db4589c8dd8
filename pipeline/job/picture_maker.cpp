#include "pipeline/job/picture_maker.h"

#include <chrono>

#include "pipeline/job/job_metadata.h"
#include "sim/timeline/error.h"

namespace carom::pipeline {

MadePicture PictureMaker::make(const FilmPlan::Picture& picture, const WorkContext& context) {
    if (store_.contains(picture.key)) {
        return {PictureOrigin::stored, 0, {}};
    }
    const std::optional<FrameClaim> claim = store_.claim(picture.key);
    if (!claim) {
        return {PictureOrigin::held, 0, {}};
    }
    if (store_.contains(picture.key)) {  // finished between the two questions
        return {PictureOrigin::stored, 0, {}};
    }
    if (context.stop.stop_requested()) {
        throw Stopped();
    }
    const auto begin = std::chrono::steady_clock::now();
    FrameInputs inputs = source_.inputs(picture.frames.front());
    inputs.frame.seed = picture.key.low;
    const render::Film film = render_(inputs, context);
    store_.write(picture.key, film, stored_frame_metadata(source_.shot(), film.statistics));
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    return {PictureOrigin::rendered, elapsed.count(), film.statistics};
}

}  // namespace carom::pipeline
