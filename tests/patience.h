// How long tests wait for what has to come.
#pragma once

#include <chrono>

namespace carom {

/// What has not come by then never will. It decides no result: sanitizers make programs up to ten
/// times slower.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr std::chrono::seconds kPatience{1000};
#else
inline constexpr std::chrono::seconds kPatience{100};
#endif

}  // namespace carom
