// The film of a job of the farm.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/farm/store_path.h"
#include "pipeline/cli/run_program.h"
#include "pipeline/cli/shot_input.h"
#include "pipeline/farm/farm_job.h"
#include "pipeline/farm/round.h"
#include "pipeline/job/film_job.h"
#include "pipeline/job/film_plan.h"
#include "pipeline/job/film_status.h"
#include "pipeline/job/film_worker.h"
#include "pipeline/sequence/sequence_job.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {

/// What a command does with a job, whose files may be another user's work.
enum class JobUse {
    look,    // at anybody's, also where nothing may be written: nothing is
    work,    // on this user's own, or in a folder that is named, as a task's script names it: the
             // processes of containers are often those of another user than the folder's owner
    change,  // this user's own
};

/// The job that the command names, this user's own before those of others. Who does more than look
/// makes files in its folder that all can read who may read the folder (let_readers_read). Other
/// jobs of the store that cannot be read do not matter. Throws InputError if there is none, Error
/// if it cannot be read or if it is another user's and must not be for this use.
[[nodiscard]] farm::FarmJob find_job(const FarmCommand& command, JobUse use);

/// What a job films, and the options with which its frames are rendered and encoded.
struct FarmFilm {
    struct OneShot {
        ShotInput input;
        sim::Bake bake;
    };
    struct SeveralShots {
        pipeline::Sequence sequence;
        pipeline::SequenceBakes bakes;
    };
    std::variant<OneShot, SeveralShots> content;
    pipeline::FilmJobOptions options;

    /// The numbers of the job's frames, ascending. Throws Error if there are none.
    [[nodiscard]] std::vector<std::int64_t> frames() const;
    /// Its shots with the frames of each that the job needs. They refer to this film.
    [[nodiscard]] std::vector<pipeline::WorkerFilm> shots() const;
    /// Of the job's frames those that are not stored, ascending; of several shots without title
    /// cards, which are drawn. Every stored frame is read. Throws Error, Stopped.
    [[nodiscard]] std::vector<std::int64_t> missing_frames(const std::stop_token& stop,
                                                           pipeline::DamagedFrames damaged) const;
};
/// Reads the film of a job, all of whose shots have to be baked. Files of this user's job that are
/// damaged are restored from their copies, except to look. Who looks writes nothing to the store
/// either, and is refused another user's film of too many frames. Throws InputError, which says
/// what to do, if the copies are damaged, too; Error if it is not known that no other machine can
/// read it either.
[[nodiscard]] FarmFilm read_film(const farm::FarmJob& job, JobUse use, CommandContext& context);

/// Which frames of a job are there, without reading them.
class FarmFrames {
  public:
    FarmFrames(const FarmFilm& film, const std::stop_token& stop);

    struct Stored {
        std::vector<std::int64_t> frames;  // ascending
        std::int64_t pictures = 0;         // frames that show the same share one
        std::int64_t awaited = 0;          // pictures that are missing of frames that are wanted
    };
    /// What is stored of the job. `skipped`: frames that are not wanted.
    [[nodiscard]] Stored stored(const std::set<std::int64_t>& skipped = {}) const;
    /// The missing frames, and the samples of these that are kept.
    [[nodiscard]] farm::Progress progress() const;
    [[nodiscard]] std::int64_t count() const { return std::ssize(frames_); }
    [[nodiscard]] std::int64_t pictures() const;
    /// Protects the frames and the bake from being pruned until unpin(), and reserves room for
    /// those that are missing. Throws NoRoom, and protects nothing then, if other jobs have
    /// reserved too much of what is left. Throws Error, Stopped.
    /// `on_wait`: that of pipeline::RoomRequest.
    void pin(const farm::FarmJob& job, const FarmFilm& film, const std::stop_token& stop,
             const std::function<void(const std::string&)>& on_wait = {}) const;
    static void unpin(const farm::FarmJob& job);
    /// Ends the reservation of a job that has failed. Its frames stay protected.
    static void forget_reservation(const farm::FarmJob& job);

    /// Removes all claims on the frames, which are there for everybody.
    void forget_claims() const;

    /// The plan of a shot of the film.
    struct Part {
        pipeline::FilmPlan plan;
        std::int64_t shift = 0;    // from its frames to those of the job
        std::int64_t samples = 0;  // of a picture, at most
    };
    [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
    /// Their numbers, ascending.
    [[nodiscard]] const std::vector<std::int64_t>& numbers() const { return frames_; }

  private:
    struct Found {
        std::set<Hash128> pictures;      // that are stored
        std::set<Hash128> awaited;       // that are not, of frames that are wanted
        std::set<std::int64_t> missing;  // frames, in the numbers of the job
    };
    /// Looks for all pictures of the job.
    [[nodiscard]] Found look(const std::set<std::int64_t>& skipped) const;

    std::string folder_;
    std::vector<std::int64_t> frames_;
    std::vector<Part> parts_;
};

/// Writes a picture with some of the stored frames. `count`: of all frames of the job. Throws
/// Error.
void write_sheet(const FarmFilm& film, const std::vector<std::int64_t>& stored, std::int64_t count,
                 const std::string& path, CommandContext& context);

}  // namespace carom::cli
