#include "pipeline/cli/farm/farm_film.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <optional>
#include <system_error>

#include <fmt/core.h>

#include "core/text.h"
#include "pipeline/camera/frame_plan.h"
#include "pipeline/cli/bake_input.h"
#include "pipeline/cli/farm/spare_files.h"
#include "pipeline/cli/film_input.h"
#include "pipeline/cli/sequence_films.h"
#include "pipeline/cli/sequence_input.h"
#include "pipeline/job/job_frames.h"
#include "pipeline/store/file_descriptor.h"
#include "pipeline/store/pins.h"
#include "pipeline/store/reservations.h"
#include "pipeline/store/sums_file.h"

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

bool is_named(const FarmJob& job, const std::string& name) {
    if (job.film == absolute_path(name)) {
        return true;
    }
    const std::optional<std::int64_t> number = number_of(name);
    const std::optional<farm::Round> round = number ? farm::read_round(job) : std::nullopt;
    return round && std::ranges::find(round->numbers, *number) != round->numbers.end();
}

/// The job of a folder, if the name is its id, its film or one of its numbers. Throws Error if it
/// has the id and cannot be read; counts it in `unreadable` if it might have been meant.
std::optional<FarmJob> job_if_named(const std::string& folder, const std::string& name,
                                    std::uint64_t& unreadable) {
    if (farm::job_id(folder) == name) {
        return farm::read_job(folder);
    }
    try {
        FarmJob job = farm::read_job(folder);
        if (is_named(job, name)) {
            return job;
        }
    } catch (const Error&) {
        ++unreadable;
    }
    return std::nullopt;
}

/// The tasks of a job, with its command after the film, have the rights of whoever submits them.
void require_own(const std::string& folder) {
    if (!farm::is_own(folder)) {
        throw Error("'" + folder + "' is the job of the user " + pipeline::name_of_owner(folder) +
                    "; nobody else can work on it or change it");
    }
}

}  // namespace

FarmJob find_job(const FarmCommand& command, JobUse use) {
    if (farm::is_job_folder(command.job)) {
        if (use == JobUse::change) {
            require_own(command.job);
        }
        if (use != JobUse::look) {
            farm::let_readers_read(command.job);
        }
        return farm::read_job(command.job);
    }
    const std::string store = store_of(command);
    std::vector<std::string> folders = farm::job_folders(store);
    std::stable_partition(folders.begin(), folders.end(), farm::is_own);
    std::uint64_t unreadable = 0;
    for (const std::string& folder : folders) {
        const std::optional<FarmJob> job = job_if_named(folder, command.job, unreadable);
        if (job && use != JobUse::look) {
            require_own(folder);
            farm::let_readers_read(folder);
        }
        if (job) {
            return *job;
        }
    }
    throw InputError(
        "the store '" + store + "' has no job '" + command.job +
        "'; name its film, its folder, its id from 'carom farm list' or one of its numbers in "
        "the queue, and the store with --store" +
        (unreadable > 0
             ? "; 'carom farm list' says why " + counted(unreadable, "job") + " cannot be read"
             : ""));
}

std::vector<std::int64_t> FarmFilm::frames() const {
    if (const auto* one = std::get_if<OneShot>(&content)) {
        return pipeline::job_frames(one->input.shot, options);
    }
    const auto& several = std::get<SeveralShots>(content);
    return options.frames.frames(several.sequence.frames());
}

std::vector<pipeline::WorkerFilm> FarmFilm::shots() const {
    if (const auto* one = std::get_if<OneShot>(&content)) {
        return {{one->input.shot, one->bake, options}};
    }
    const auto& [sequence, bakes] = std::get<SeveralShots>(content);
    const std::vector<std::int64_t> all = frames();
    const std::vector<std::int64_t> starts = sequence.starts();
    std::vector<pipeline::WorkerFilm> shots;
    for (const auto& [part, bake] : bakes) {
        const auto& shot = std::get<pipeline::ShotPart>(sequence.parts[part].content);
        const std::vector<std::int64_t> own = pipeline::own_frames(sequence, part, all);
        if (!own.empty()) {
            shots.push_back(
                {shot.shot, bake, pipeline::part_options(options, own), starts[part] - shot.first});
        }
    }
    return shots;
}

std::vector<std::int64_t> FarmFilm::missing_frames(const std::stop_token& stop,
                                                   pipeline::DamagedFrames damaged) const {
    std::set<std::int64_t> missing;
    for (const pipeline::WorkerFilm& shot : shots()) {
        for (const std::int64_t frame :
             pipeline::film_status(shot.shot, shot.bake, shot.options, stop, damaged).missing) {
            missing.insert(frame + shot.shift);
        }
    }
    return {missing.begin(), missing.end()};
}

namespace {

/// The job may be anybody's: a pipe would never end.
std::string regular_file(const std::string& path) {
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        throw InputError("'" + path + "' is not a regular file");
    }
    return path;
}

/// Nothing is simulated for a job: what its file names may be anybody's.
void require_bakes(const pipeline::Sequence& sequence) {
    for (const pipeline::SequencePart& part : sequence.parts) {
        const auto* shot = std::get_if<pipeline::ShotPart>(&part.content);
        if (shot != nullptr && !shot->bake) {
            throw InputError("'" + shot->path + "' is not the bake of a shot");
        }
    }
}

std::variant<FarmFilm::OneShot, FarmFilm::SeveralShots> read_content(const FarmJob& job,
                                                                     const CacheOptions& cache,
                                                                     CommandContext& context) {
    InputOptions input;
    input.root = job.root;
    if (job.is_sequence) {
        input.path = regular_file(farm::sequence_path(job));
        FarmFilm::SeveralShots film{read_sequence_input(input, context.console, job.folder), {}};
        require_bakes(film.sequence);
        film.bakes = obtain_bakes(film.sequence, cache, context);
        return film;
    }
    input.path = regular_file(farm::bake_path(job));
    FarmFilm::OneShot film{read_film_input(input, FileReading::none, context), {}};
    film.bake = obtain_bake(film.input, input, cache, context);
    return film;
}

/// What became of the job's own files.
OwnFiles restored(const FarmJob& job, const std::string& problem) {
    try {
        return farm::is_own(job.folder) ? restore_files(job) : OwnFiles::intact;
    } catch (const Error& error) {
        throw Error(problem + "; it cannot be restored: " + error.what());
    }
}

/// The same; files of the job that are damaged are restored first. With intact files it is not the
/// job's fault that it cannot be read, but for example that of a node that does not see a mesh.
std::variant<FarmFilm::OneShot, FarmFilm::SeveralShots> read_intact_content(
    const FarmJob& job, JobUse use, const CacheOptions& cache, CommandContext& context) {
    try {
        return read_content(job, cache, context);
    } catch (const InputError& error) {
        const std::string problem = error.what();
        if (use == JobUse::look) {
            throw InputError(problem +
                             "; a worker restores damaged files from their copies; if it cannot, "
                             "submit the film again");
        }
        const OwnFiles files = restored(job, problem);
        if (files == OwnFiles::damaged) {
            throw InputError(problem + "; the job cannot go on: submit the film again");
        }
        if (files == OwnFiles::intact) {
            throw Error(problem);
        }
        context.console.warning(problem + "; it was restored from the job's copy");
    }
    try {
        return read_content(job, cache, context);
    } catch (const InputError& error) {
        throw Error(error.what());
    }
}

/// Whoever looks at all jobs must not be kept busy by one.
void refuse_endless(const FarmJob& job, const FarmFilm& film) {
    constexpr std::int64_t kMost = 200'000;  // two hours
    const auto* one = std::get_if<FarmFilm::OneShot>(&film.content);
    const std::int64_t count =
        one != nullptr ? pipeline::frame_count(one->input.shot.cameras, one->input.shot.timing)
                       : std::get<FarmFilm::SeveralShots>(film.content).sequence.frames();
    if (count > kMost && !farm::is_own(job.folder)) {
        throw InputError(
            fmt::format("the film has {} frames; of the jobs of others only those with "
                        "at most {} are looked at",
                        count, kMost));
    }
}

}  // namespace

FarmFilm read_film(const FarmJob& job, JobUse use, CommandContext& context) {
    const CacheOptions cache{job.store, "none", use == JobUse::look};
    FarmFilm film{read_intact_content(job, use, cache, context),
                  job_options(cache, job.frames, "")};
    if (use == JobUse::look) {
        refuse_endless(job, film);
    }
    film.options.threads = static_cast<int>(job.processors);
    film.options.claim_times = pipeline::claim_times(
        std::chrono::milliseconds(static_cast<std::int64_t>(1000 * job.dead_after)));
    film.options.claim_times.keeps_finished = true;
    film.options.keeps_sums = true;
    return film;
}

FarmFrames::FarmFrames(const FarmFilm& film, const std::stop_token& stop)
    : folder_(pipeline::frames_folder(film.options)), frames_(film.frames()) {
    for (const pipeline::WorkerFilm& shot : film.shots()) {
        const pipeline::FilmSource source(shot.shot, shot.bake.timeline);
        const render::RenderSettings& render = shot.shot.render;
        parts_.push_back(
            {pipeline::plan_film(source, pipeline::job_frames(shot.shot, shot.options), stop),
             shot.shift, std::int64_t{render.width} * render.height * render.samples});
    }
}

std::int64_t FarmFrames::pictures() const {
    std::set<Hash128> keys;
    for (const Part& part : parts_) {
        for (const pipeline::FilmPlan::Picture& picture : part.plan.pictures) {
            keys.insert(picture.key);
        }
    }
    return std::ssize(keys);
}

FarmFrames::Found FarmFrames::look(const std::set<std::int64_t>& skipped) const {
    const pipeline::FrameStore store(folder_, {}, {}, pipeline::StoreAccess::only_read);
    Found found;
    for (const Part& part : parts_) {
        const pipeline::FilmPlan& plan = part.plan;
        std::vector<bool> is_stored;
        for (const pipeline::FilmPlan::Picture& picture : plan.pictures) {
            is_stored.push_back(store.contains(picture.key));
            if (is_stored.back()) {
                found.pictures.insert(picture.key);
            }
        }
        for (std::size_t i = 0; i < plan.frames.size(); ++i) {
            const std::int64_t frame = plan.frames[i] + part.shift;
            const auto need = [&](std::size_t picture) {
                if (!is_stored[picture]) {
                    found.missing.insert(frame);
                    if (!skipped.contains(frame)) {
                        found.awaited.insert(plan.pictures[picture].key);
                    }
                }
            };
            need(plan.picture_of[i]);
            if (const pipeline::FilmPlan::Blend* blend = plan.blend_of(i)) {
                need(blend->picture);
            }
        }
    }
    return found;
}

FarmFrames::Stored FarmFrames::stored(const std::set<std::int64_t>& skipped) const {
    const Found found = look(skipped);
    Stored stored;
    std::ranges::set_difference(frames_, found.missing, std::back_inserter(stored.frames));
    stored.pictures = std::ssize(found.pictures);
    stored.awaited = std::ssize(found.awaited);
    return stored;
}

farm::Progress FarmFrames::progress() const {
    const Found found = look({});
    std::int64_t samples = 0;
    const pipeline::FrameStore store(folder_, {}, {}, pipeline::StoreAccess::only_read);
    for (const Part& part : parts_) {
        for (const pipeline::FilmPlan::Picture& picture : part.plan.pictures) {
            if (found.pictures.contains(picture.key)) {
                continue;
            }
            // A picture that is to be denoised has all its samples. A damaged file may say
            // anything.
            const auto most = static_cast<std::uint64_t>(part.samples);
            samples += static_cast<std::int64_t>(
                store.noisy_size_bytes(picture.noisy_key) > 0
                    ? most
                    : std::min(most, pipeline::stored_samples(store, picture.noisy_key)));
        }
    }
    return {std::ssize(found.missing), samples};
}

void FarmFrames::pin(const FarmJob& job, const FarmFilm& film, const std::stop_token& stop,
                     const std::function<void(const std::string&)>& on_wait) const {
    pipeline::JobPin pin{pin_of(job), "", static_cast<std::uint64_t>(job.frame_bytes)};
    if (!job.is_portable) {  // else the store is in the job's folder
        pin.folder = fs::path(job.folder).lexically_relative(job.store).string();
    }
    pipeline::RoomRequest request{job.store, pipeline::job_pin_name(pin.job)};
    request.on_wait = on_wait;
    std::set<Hash128> keys;
    const std::vector<pipeline::WorkerFilm> shots = film.shots();
    for (std::size_t i = 0; i < shots.size(); ++i) {
        for (const Hash128& key : pipeline::keys_of(parts_[i].plan, shots[i].bake)) {
            keys.insert(key);
        }
    }
    const std::vector<Hash128> list(keys.begin(), keys.end());
    try {
        pipeline::reserve_room(
            request, [&] { write_job_pin(job.store, pin, list); }, stop);
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
    for (const Part& part : parts_) {
        for (const pipeline::FilmPlan::Picture& picture : part.plan.pictures) {
            store.forget_claims(picture.key);
            store.forget_claims(picture.noisy_key);
        }
    }
}

}  // namespace carom::cli
