#include "pipeline/cli/farm/farm_film.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/store/cache_folder.h"
#include "pipeline/store/pins.h"
#include "pipeline/store/reservations.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FarmJob;

std::optional<std::int64_t> number_of(const std::string& text) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                    : std::nullopt;
}

/// The name of the job's pin.
std::string pin_of(const FarmJob& job) {
    return fs::path(job.folder).filename().string();
}

bool is_named(const FarmJob& job, const std::string& name, const std::string& film) {
    if (job.film == film) {
        return true;
    }
    const std::optional<std::int64_t> number = number_of(name);
    const std::optional<farm::SlurmJobs> slurm = number ? farm::read_slurm_jobs(job) : std::nullopt;
    return slurm && std::ranges::find(slurm->numbers, *number) != slurm->numbers.end();
}

}  // namespace

std::string absolute_path(const std::string& path) {
    return fs::absolute(path).lexically_normal().string();
}

std::string store_of(const FarmCommand& command) {
    return absolute_path(command.store.empty() ? pipeline::default_cache_folder() : command.store);
}

FarmJob find_job(const FarmCommand& command) {
    if (farm::is_job_folder(command.job)) {
        return farm::read_job(command.job);
    }
    const std::string store = store_of(command);
    for (const std::string& folder : farm::job_folders(store)) {
        FarmJob job = farm::read_job(folder);
        if (is_named(job, command.job, absolute_path(command.job))) {
            return job;
        }
    }
    throw InputError("the store '" + store + "' has no job '" + command.job +
                     "'; name its film, its folder or one of its numbers in Slurm's queue, and the "
                     "store with --store");
}

FarmFilm read_film(const FarmJob& job, CommandContext& context) {
    InputOptions input;
    input.path = farm::bake_path(job);
    input.root = job.root;
    FarmFilm film{
        read_film_input(input, context), {}, job_options({job.store, "none"}, job.frames, "")};
    film.bake = obtain_bake(film.input, input, {job.store, "none"}, context);
    film.options.tier = job.tier;
    film.options.threads = static_cast<int>(job.processors);
    film.options.claim_times = pipeline::claim_times(
        std::chrono::milliseconds(static_cast<std::int64_t>(1000 * job.dead_after)));
    film.options.claim_times.keeps_finished = true;
    film.options.keeps_sums = true;
    return film;
}

FarmFrames::FarmFrames(const FarmFilm& film, const std::stop_token& stop)
    : folder_(pipeline::frames_folder(film.options)),
      plan_(pipeline::plan_film(
          pipeline::FilmSource(film.input.shot, film.bake.timeline, film.options.tier),
          pipeline::job_frames(film.input.shot, film.options), stop)) {}

FarmFrames::Stored FarmFrames::stored() const {
    Stored stored;
    const pipeline::FrameStore store(folder_);
    std::vector<bool> is_stored;
    for (const pipeline::FilmPlan::Picture& picture : plan_.pictures) {
        is_stored.push_back(store.contains(picture.key));
        stored.pictures += is_stored.back() ? 1 : 0;
    }
    for (std::size_t i = 0; i < plan_.frames.size(); ++i) {
        const pipeline::FilmPlan::Blend* blend = plan_.blend_of(i);
        if (is_stored[plan_.picture_of[i]] && (blend == nullptr || is_stored[blend->picture])) {
            stored.frames.push_back(plan_.frames[i]);
        }
    }
    return stored;
}

void FarmFrames::pin(const FarmJob& job, const FarmFilm& film, const std::stop_token& stop) const {
    pipeline::JobPin pin{pin_of(job), "", static_cast<std::uint64_t>(job.frame_bytes)};
    if (!job.is_portable) {  // else the store is in the job's folder
        pin.folder = fs::path(job.folder).lexically_relative(job.store).string();
    }
    const pipeline::RoomRequest request{job.store, pipeline::job_pin_name(pin.job)};
    try {
        pipeline::reserve_room(
            request, [&] { write_job_pin(job.store, pin, pipeline::keys_of(plan_, film.bake)); },
            stop);
    } catch (const pipeline::NoRoom&) {
        unpin(job);
        throw;
    }
}

void FarmFrames::unpin(const FarmJob& job) {
    pipeline::remove_job_pin(job.store, pin_of(job));
}

void FarmFrames::forget_reservation(const FarmJob& job) {
    pipeline::forget_reservation(job.store, pin_of(job));
}

void FarmFrames::forget_claims() const {
    const pipeline::FrameStore store(folder_);
    for (const pipeline::FilmPlan::Picture& picture : plan_.pictures) {
        store.forget_claims(picture.key);
    }
}

}  // namespace carom::cli
