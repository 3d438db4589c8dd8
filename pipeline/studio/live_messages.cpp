#include "pipeline/studio/live_messages.h"

#include <iterator>
#include <utility>

#include "core/cpu_time.h"
#include "pipeline/check/motion_check.h"
#include "pipeline/check/text_check.h"
#include "pipeline/job/film_job.h"
#include "pipeline/studio/motion_messages.h"
#include "pipeline/studio/shot_state.h"
#include "pipeline/studio/value_places.h"

namespace carom::studio {
namespace {

/// A timeline in which everything stands as at the start, except for keyed motions.
sim::Timeline timeline_at_rest(const pipeline::Shot& shot) {
    sim::Bake bake;
    bake.timeline.end_time = shot.world.duration;
    for (const sim::Body& body : shot.world.bodies) {
        if (body.kind == sim::BodyKind::dynamic) {
            sim::Key key;
            key.position = body.pose.position;
            key.orientation = body.pose.orientation;
            bake.timeline.tracks.emplace_back(body.name, std::vector<sim::Key>{key});
        }
    }
    pipeline::add_keyed_motions(bake, shot);
    return std::move(bake.timeline);
}

}  // namespace

void LiveMessages::tell_problems(std::int64_t v, const pipeline::LoadResult& loaded,
                                 bool complete) {
    problems_ = problem_messages(loaded.problems, loaded.files);
    output_.text(Problems{v, complete, problems_});
}

void LiveMessages::complete_problems(std::int64_t v) {
    output_.text(Problems{v, true, problems_});
}

void LiveMessages::add_motion_problems(std::int64_t v, const pipeline::Shot& shot,
                                       const pipeline::LoadResult& loaded,
                                       const sim::Timeline& timeline) {
    std::vector<pipeline::Problem> found =
        pipeline::simulation_problems(timeline, loaded.source.get());
    using Check = std::vector<pipeline::Problem> (*)(
        const pipeline::Shot&, const pipeline::ShotSource*, const sim::Timeline&);
    for (const Check check :
         {Check{pipeline::cloth_problems}, Check{pipeline::stick_problems},
          Check{pipeline::annotation_problems}, Check{pipeline::camera_problems},
          Check{pipeline::sound_problems}, Check{pipeline::text_problems}}) {
        std::vector<pipeline::Problem> more = check(shot, loaded.source.get(), timeline);
        std::move(more.begin(), more.end(), std::back_inserter(found));
    }
    for (Problem& problem : problem_messages(found, loaded.files)) {
        problems_.push_back(std::move(problem));
    }
    complete_problems(v);
}

void LiveMessages::show_at_rest(std::int64_t v, const pipeline::Shot& shot,
                                const pipeline::ShotSource& source) {
    ShotState state = shot_state(shot, source, timeline_at_rest(shot), root_);
    state.v = v;
    output_.text(std::move(state));
    output_.shown(v, shot);
}

void LiveMessages::show(std::int64_t v, const pipeline::Shot& shot,
                        const pipeline::ShotSource& source, const sim::Timeline& timeline,
                        bool kept, double start) {
    ShotState state = shot_state(shot, source, timeline, root_);
    state.v = v;
    state.moves = true;
    Numbers<CamerasHead> cameras = cameras_message(shot, timeline);
    cameras.head.v = v;
    Numbers<TimelineHead> motion = timeline_message(timeline);
    motion.head.v = v;
    motion.head.kept = kept;
    motion.head.milliseconds = 1e3 * (thread_cpu_seconds() - start);
    output_.text(std::move(state));
    if (cameras.numbers != cameras_ || !has_cameras_) {  // the page keeps them
        has_cameras_ = true;
        cameras_ = cameras.numbers;
        output_.binary(cameras.head, std::move(cameras.numbers));
    }
    output_.binary(std::move(motion.head), std::move(motion.numbers));
    output_.shown(v, shot);
}

void LiveMessages::defer_during_drag(std::int64_t v) {
    output_.text(Deferred{v, "dragging",
                          "simulating this shot takes long; during the drag its motion follows "
                          "now and then"});
}

void LiveMessages::defer_to_button(std::int64_t v) {
    output_.text(Deferred{v, "limit",
                          "simulating this shot takes longer than happens by itself; start it "
                          "with the button"});
    complete_problems(v);
}

}  // namespace carom::studio
