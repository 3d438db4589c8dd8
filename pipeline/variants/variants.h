// Many variants of a shot, simulated in parallel without touching disk.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "sim/trials.h"

namespace carom::pipeline {

/// How work of many parts is done.
struct PartsWork {
    int threads = 0;  // 0: one per processor
    WorkContext context{};
};

/// Calls part(i) for every i < count, in any order and from several threads. If parts throw, the
/// exception of the first of them in order of `i` is thrown, whatever the threads do, and later
/// parts may be left out. Throws Stopped soon after a stop is requested.
void do_parts(std::size_t count, const std::function<void(std::size_t)>& part,
              const PartsWork& work = {});

/// One variant of the shot of Trials.
struct ShotVariant {
    std::vector<sim::ForceEvent> events;
    sim::TrialLimits limits{};  // its `stop` is that of the work
};

/// The variant with that number. It is called once for each, in any order, from several threads.
using VariantOf = std::function<ShotVariant(std::size_t)>;

/// The outcomes of variants 0 to count - 1, in order: the same with any number of threads. Empty
/// for a variant that takes more steps than its limit. Throws as do_parts.
[[nodiscard]] std::vector<std::optional<sim::Outcome>> run_variants(const sim::Trials& trials,
                                                                    std::size_t count,
                                                                    const VariantOf& variant_of,
                                                                    const PartsWork& work = {});

}  // namespace carom::pipeline
