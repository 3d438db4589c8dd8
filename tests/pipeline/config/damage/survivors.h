// The kinds of damage that no check can find, because the damaged shot is valid, too.
#pragma once

#include <string>
#include <vector>

#include "tests/pipeline/config/damage/damage.h"
#include "tests/pipeline/config/damage/difference.h"

namespace carom::testing {

/// The known kinds; survivors.txt has the reason for each of them.
[[nodiscard]] std::vector<std::string> survivor_kinds();

/// Whether the damage joined a line to the comment above it. Then problems may be reported anywhere
/// where that line is missing.
[[nodiscard]] bool joins_comment(const Damage& damage);

/// The kind of a damage with these differences; empty if a check should have found it.
[[nodiscard]] std::string survivor_kind(const std::vector<Difference>& differences,
                                        const Damage& damage);

}  // namespace carom::testing
