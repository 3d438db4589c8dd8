// The option --tier of commands that render.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "pipeline/cli/terminal/console.h"
#include "render/acceleration/vector_tier.h"

namespace carom::cli {

/// While it exists, frames are rendered with the tier that the user chose, or with the best that
/// the machine has.
class ChosenTier {
  public:
    /// `option`: "avx2" ..., or empty. Throws InputError if the machine lacks it.
    explicit ChosenTier(const std::string& option);

  private:
    std::optional<render::TierLimit> limit_;
};

/// The tier of the frames of which a film is made: the one that the user chose, or else the one of
/// which most are `stored`. Reports one that is not this machine's.
[[nodiscard]] std::string tier_to_mux(const std::string& option, Console& console,
                                      const std::function<std::string()>& stored);

}  // namespace carom::cli
