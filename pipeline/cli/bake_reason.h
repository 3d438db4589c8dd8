// Explains why a shot was simulated or not.
#pragma once

#include <string>

#include "pipeline/job/film_job.h"
#include "pipeline/shot/shot.h"

namespace carom::cli {

/// Compares a shot with the record of its previous run, which is stored in the cache beside the
/// bakes, and explains what changed in its physics.
class BakeReason {
  public:
    /// Reads the record. If `cache_folder` is empty, the default folder is used.
    BakeReason(const pipeline::Shot& shot, const std::string& shot_path,
               const std::string& cache_folder);

    /// "simulated the shot again: its physics has changed (events[0].strike.speed)"
    [[nodiscard]] std::string text(pipeline::BakeOrigin origin) const;

    /// Saves this shot as the record for the next run. Failures are ignored.
    void save_record() const;

  private:
    const pipeline::Shot& shot_;
    std::string path_;  // of the record
    std::string hash_;
    std::string last_hash_;  // empty: no record exists
    std::string last_text_;  // the resolved shot
};

}  // namespace carom::cli
