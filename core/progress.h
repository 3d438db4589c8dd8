// How long work reports back and is told to stop.
#pragma once

#include <functional>
#include <stop_token>

namespace carom {

/// Called with the share done, in [0, 1], never decreasing and ending at 1 unless the work stops
/// early. May be called from any thread, one call at a time. Empty means nobody listens.
using ProgressCallback = std::function<void(double)>;

/// What every long function takes as its last argument. When `stop` is triggered the function
/// throws `Stopped` soon.
struct WorkContext {
    ProgressCallback progress{};
    std::stop_token stop{};
};

}  // namespace carom
