// Damages that no check can find, because what they leave is right, too.
#pragma once

#include <string>
#include <vector>

#include "tests/pipeline/config/damage/damage.h"
#include "tests/pipeline/config/damage/meaning.h"

namespace carom::testing {

/// The kinds that survivors() knows; survivors.txt says why each of them is let be.
[[nodiscard]] std::vector<std::string> survivor_kinds();

/// Whether the damage joined a line to the comment above it. Then problems are reported where that
/// line is missed, which may be anywhere.
[[nodiscard]] bool joins_comment(const Damage& damage);

/// The kind of a damage that changed a shot in this way; empty if it should have been found.
[[nodiscard]] std::string survivor_kind(const std::vector<Difference>& differences,
                                        const Damage& damage);

}  // namespace carom::testing
