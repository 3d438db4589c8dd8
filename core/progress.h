// Progress reports and cancellation of long work.
#pragma once

#include <functional>
#include <stop_token>

namespace carom {

/// Called with the completed fraction in [0, 1], which never decreases and ends at 1 unless the
/// work stops early. May be called from any thread, but only one call at a time. May be empty.
using ProgressCallback = std::function<void(double)>;

/// The last argument of every long function. Soon after `stop` is triggered the function throws
/// `Stopped`.
struct WorkContext {
    ProgressCallback progress{};
    std::stop_token stop{};
};

}  // namespace carom
