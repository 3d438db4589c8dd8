// A job that makes the film of the tiny shot and logs its renderings, for tests that kill it.
#pragma once

#include <string>

namespace carom::testing {

/// Makes the film with a fake renderer that takes 8 ms per picture. The file `log`, which is
/// created immediately, receives a line with the key of every picture when its rendering begins,
/// and `log`.warnings the warnings of the job. `is_shared`: other machines may see the frames late.
/// Throws Error.
void run_logged_job(const std::string& cache, const std::string& video, const std::string& log,
                    bool is_shared = false);

}  // namespace carom::testing
