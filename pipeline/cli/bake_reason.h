// Why a shot is simulated, or not.
#pragma once

#include <string>

#include "pipeline/job/film_job.h"
#include "pipeline/shot/shot.h"

namespace carom::cli {

/// What the physics of a shot's file was the last time, kept in the cache beside the bakes.
class BakeReason {
  public:
    /// `cache_folder` empty: the usual one.
    BakeReason(const pipeline::Shot& shot, const std::string& shot_path,
               const std::string& cache_folder);

    /// "simulated the shot again: its physics has changed (events[0].strike.speed)"
    [[nodiscard]] std::string text(pipeline::BakeOrigin origin) const;

    /// Next time this is the last time. What cannot be written is not remembered.
    void remember() const;

  private:
    const pipeline::Shot& shot_;
    std::string path_;  // of the record
    std::string hash_;
    std::string last_hash_;  // empty: there is no record
    std::string last_text_;  // the resolved shot
};

}  // namespace carom::cli
