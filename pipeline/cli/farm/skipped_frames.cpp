#include "pipeline/cli/farm/skipped_frames.h"

#include <algorithm>

#include <fmt/core.h>

#include "pipeline/farm/wishes.h"
#include "pipeline/job/frame_range.h"

namespace carom::cli {

std::vector<std::int64_t> take_skipped(const farm::FarmJob& job,
                                       std::vector<std::int64_t>& missing) {
    if (missing.empty()) {
        return {};
    }
    const farm::Wishes wishes = farm::read_wishes(job);
    const auto first =
        std::stable_partition(missing.begin(), missing.end(),
                              [&](std::int64_t frame) { return !wishes.skipped.contains(frame); });
    std::vector<std::int64_t> skipped(first, missing.end());
    missing.erase(first, missing.end());
    return skipped;
}

std::string skipped_text(const std::vector<std::int64_t>& skipped) {
    if (skipped.empty()) {
        return "";
    }
    return skipped.size() == 1
               ? fmt::format("frame {} was skipped; another one of its shot is shown, or black",
                             skipped.front())
               : fmt::format(
                     "the frames {} were skipped; others of their shots are shown, or black",
                     pipeline::frames_text(skipped));
}

}  // namespace carom::cli
