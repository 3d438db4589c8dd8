// The option --tier of commands that render.
#pragma once

#include <optional>
#include <string>

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

}  // namespace carom::cli
