// The tiny shot's film as a job that tests kill.
#pragma once

#include <string>

namespace carom::testing {

/// Makes the film with a fake renderer that takes 8 ms per picture. `log`, made at once, gets a
/// line with the key of every picture when its rendering begins, `log`.warnings
/// what the job warns of. Throws Error.
void run_logged_job(const std::string& cache, const std::string& video, const std::string& log);

}  // namespace carom::testing
