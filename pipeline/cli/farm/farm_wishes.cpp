// Which frames of a job come again, first, or not at all.
#include <algorithm>
#include <iterator>

#include <fmt/core.h>
#include <unistd.h>

#include "core/text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/farm/wishes.h"
#include "pipeline/job/frame_range.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/store/drop_frame.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::cli {
namespace {

using Frames = std::set<std::int64_t>;

std::string text_of(const Frames& frames) {
    return pipeline::frames_text({frames.begin(), frames.end()});
}

/// "frame 3", "frames 3-5, 9".
std::string named(const Frames& frames) {
    return (frames.size() == 1 ? "frame " : "frames ") + text_of(frames);
}

/// The frames that the command names. Throws InputError if the job does not have one of them.
Frames frames_of(const FarmCommand& command, const std::vector<std::int64_t>& all) {
    pipeline::FrameRange range;
    try {
        range = pipeline::parse_frame_range(command.frames);
    } catch (const Error& error) {
        throw InputError(error.what());
    }
    constexpr std::int64_t kMost = 10'000'000;  // a wrong digit must not fill the memory
    const std::int64_t count = std::min(kMost, std::max(range.last(), all.back()) + 1);
    Frames other;
    std::ranges::set_difference(range.frames(count), all, std::inserter(other, other.end()));
    if (!other.empty()) {
        throw InputError(fmt::format("the job has no frame {}; it has {}", *other.begin(),
                                     pipeline::frames_text(all)));
    }
    const std::vector<std::int64_t> frames = range.frames(count);
    return {frames.begin(), frames.end()};
}

struct Asked {
    farm::FarmJob job;
    FarmFilm film;
    FarmFrames frames;
    Frames wanted;

    Asked(const FarmCommand& command, CommandContext& context)
        : job(find_job(command, JobUse::change)),
          film(read_film(job, JobUse::change, context)),
          frames(film, context.stop),
          wanted(frames_of(command, frames.numbers())) {
        if (::access(job.folder.c_str(), W_OK) != 0) {  // before anything is dropped
            throw Error(pipeline::system_problem(job.folder, "its wishes cannot be written"));
        }
    }
};

/// What has to be done that the wish is followed.
std::string hint(const farm::FarmJob& job) {
    return farm::read_end(job) ? "; the job has ended: 'carom farm resume' goes on with it" : "";
}

/// The film that is there is no longer the one that is wanted.
void forget_film(const farm::FarmJob& job) {
    if (const auto end = farm::read_end(job); end && end->state == "complete") {
        farm::remove_end(job);
    }
}

/// Takes the pictures of these frames out of the store. Returns the frames whose pictures are being
/// rendered just now, which stay, and adds to `frames` others that show the same pictures.
Frames drop(const FarmFilm& film, const FarmFrames& all, Frames& frames) {
    const pipeline::FrameStore store = pipeline::open_store(film.options);
    const Frames wanted = frames;
    Frames busy;
    for (const auto& [plan, shift, samples] : all.parts()) {
        std::map<std::size_t, Frames> shown;  // by picture
        for (std::size_t i = 0; i < plan.frames.size(); ++i) {
            shown[plan.picture_of[i]].insert(plan.frames[i] + shift);
            if (const pipeline::FilmPlan::Blend* blend = plan.blend_of(i)) {
                shown[blend->picture].insert(plan.frames[i] + shift);
            }
        }
        for (const auto& [picture, showing] : shown) {
            if (std::ranges::none_of(showing, [&](std::int64_t f) { return wanted.contains(f); })) {
                continue;
            }
            const pipeline::FilmPlan::Picture& dropped = plan.pictures[picture];
            const bool is_dropped = pipeline::drop_frame(store, dropped.key, dropped.noisy_key);
            (is_dropped ? frames : busy).insert(showing.begin(), showing.end());
        }
    }
    for (const std::int64_t frame : busy) {
        frames.erase(frame);
    }
    return busy;
}

}  // namespace

void farm_retry(const FarmCommand& command, CommandContext& context) {
    Asked asked(command, context);
    const Frames busy = drop(asked.film, asked.frames, asked.wanted);
    if (!busy.empty()) {
        context.console.warning(named(busy) + " " + (busy.size() == 1 ? "is" : "are") +
                                " being rendered now, and " +
                                (busy.size() == 1 ? "stays" : "stay"));
    }
    if (asked.wanted.empty()) {
        return;
    }
    farm::change_wishes(asked.job, [&](farm::Wishes& wishes) {
        for (const std::int64_t frame : asked.wanted) {
            wishes.retried[frame] = wishes.revision;
            wishes.skipped.erase(frame);
        }
    });
    context.console.info("rendered again: " + named(asked.wanted) + hint(asked.job));
    forget_film(asked.job);
}

void farm_skip(const FarmCommand& command, CommandContext& context) {
    const Asked asked(command, context);
    farm::change_wishes(asked.job, [&](farm::Wishes& wishes) {
        for (const std::int64_t frame : asked.wanted) {
            command.undo ? (void)wishes.skipped.erase(frame) : (void)wishes.skipped.insert(frame);
        }
        if (std::ssize(wishes.skipped) == asked.frames.count()) {
            throw InputError("the film would have no frame; leave out at least one");
        }
    });
    context.console.info((command.undo ? "no longer skipped: " : "skipped: ") +
                         named(asked.wanted) + hint(asked.job));
    if (command.undo) {
        forget_film(asked.job);
    }
}

void farm_prefer(const FarmCommand& command, CommandContext& context) {
    const Asked asked(command, context);
    farm::change_wishes(asked.job, [&](farm::Wishes& wishes) {
        for (const std::int64_t frame : asked.wanted) {
            wishes.preferred.erase(frame);
        }
        if (!command.undo) {
            wishes.preferred = asked.wanted;
        }
    });
    context.console.info((command.undo ? "no longer first: " : "first: ") + named(asked.wanted) +
                         hint(asked.job));
}

}  // namespace carom::cli
