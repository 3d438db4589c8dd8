// Which frames of a job come again, first, or not at all.
#include <algorithm>
#include <chrono>
#include <iterator>
#include <thread>

#include <fmt/core.h>
#include <unistd.h>

#include "core/text.h"
#include "pipeline/cli/farm/farm_actions.h"
#include "pipeline/cli/farm/farm_film.h"
#include "pipeline/farm/engine.h"
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
    if (!farm::read_end(job)) {
        return "";
    }
    return farm::has_queue(job) ? "; the job has ended: 'carom farm resume' goes on with it"
                                : "; the job has ended: start its tasks again, as '" + job.folder +
                                      "/README.md' says";
}

/// The film that is there is no longer the one that is wanted.
void forget_film(const farm::FarmJob& job) {
    if (const auto end = farm::read_end(job); end && end->state == "complete") {
        farm::remove_end(job);
    }
}

/// A picture and the frames that show it.
struct Shown {
    pipeline::FilmPlan::Picture picture;
    Frames frames;
};

/// The pictures that the wanted frames show.
std::vector<Shown> pictures_of(const FarmFrames& all, const Frames& wanted) {
    std::vector<Shown> pictures;
    for (const auto& [plan, shift, samples] : all.parts()) {
        std::map<std::size_t, Frames> shown;  // by picture
        for (std::size_t i = 0; i < plan.frames.size(); ++i) {
            shown[plan.picture_of[i]].insert(plan.frames[i] + shift);
            if (const pipeline::FilmPlan::Blend* blend = plan.blend_of(i)) {
                shown[blend->picture].insert(plan.frames[i] + shift);
            }
        }
        for (const auto& [picture, showing] : shown) {
            if (std::ranges::any_of(showing, [&](std::int64_t f) { return wanted.contains(f); })) {
                pictures.push_back({plan.pictures[picture], showing});
            }
        }
    }
    return pictures;
}

/// Takes pictures out of the store. Those that somebody has claimed are left in the list; each is
/// tried again until a claim of a dead worker would have counted as dead.
void drop(const pipeline::FrameStore& store, std::chrono::milliseconds dead_after,
          std::vector<Shown>& pictures, CommandContext& context) {
    constexpr std::chrono::milliseconds kPause{500};
    const auto end = std::chrono::steady_clock::now() + dead_after + kPause;
    const auto drop_all = [&] {
        std::erase_if(pictures, [&](const Shown& shown) {
            return pipeline::drop_frame(store, shown.picture.key, shown.picture.noisy_key);
        });
    };
    drop_all();
    if (!pictures.empty()) {
        context.console.info(fmt::format(
            "{} claimed; waiting for {} s to see whether by workers that are alive",
            counted(pictures.size(), "picture") + (pictures.size() == 1 ? " is" : " are"),
            std::chrono::ceil<std::chrono::seconds>(dead_after).count()));
    }
    while (!pictures.empty() && std::chrono::steady_clock::now() < end) {
        if (context.stop.stop_requested()) {
            throw Stopped();
        }
        std::this_thread::sleep_for(kPause);
        drop_all();
    }
}

/// Who works on pictures that stay.
std::string holders_of(const pipeline::FrameStore& store, const std::vector<Shown>& pictures) {
    std::set<std::string> holders;
    for (const Shown& shown : pictures) {
        for (const Hash128& key : {shown.picture.key, shown.picture.noisy_key}) {
            if (std::string holder = store.claim_holder(key); !holder.empty()) {
                holders.insert(std::move(holder));
            }
        }
    }
    return join(std::vector<std::string>(holders.begin(), holders.end()), "; ");
}

}  // namespace

void farm_retry(const FarmCommand& command, CommandContext& context) {
    const Asked asked(command, context);
    std::vector<Shown> pictures = pictures_of(asked.frames, asked.wanted);
    Frames again = asked.wanted;
    for (const Shown& shown : pictures) {
        again.insert(shown.frames.begin(), shown.frames.end());
    }
    const pipeline::FrameStore store = pipeline::open_store(asked.film.options);
    drop(store, asked.film.options.claim_times.dead_after, pictures, context);
    Frames busy;
    for (const Shown& shown : pictures) {
        busy.insert(shown.frames.begin(), shown.frames.end());
    }
    if (!busy.empty()) {
        context.console.warning(fmt::format(
            "{} {} being rendered now, and {}: {}", named(busy), busy.size() == 1 ? "is" : "are",
            busy.size() == 1 ? "stays" : "stay", holders_of(store, pictures)));
    }
    std::erase_if(again, [&](std::int64_t frame) { return busy.contains(frame); });
    farm::change_wishes(asked.job, [&](farm::Wishes& wishes) {
        for (const std::int64_t frame : asked.wanted) {
            wishes.skipped.erase(frame);
        }
        for (const std::int64_t frame : again) {
            wishes.retried[frame] = wishes.revision;
            wishes.skipped.erase(frame);
        }
    });
    if (again.empty()) {
        return;
    }
    context.console.info("rendered again: " + named(again) + hint(asked.job));
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
