// Which vector instructions frames are rendered with. The last bits of a frame depend on its tier:
// processors below AVX2 follow one path at a time, which adds up light in another order than paths
// in step. Where rays hit is the same in every tier (analytic_kernels_test compares the bits).
// Wider vectors than those of AVX2 give the same bits as AVX2, so they are no tier.
#pragma once

#include <array>
#include <string_view>

namespace carom::render {

/// The tiers as users write them, from the best to the one that every processor has.
inline constexpr std::array<std::string_view, 4> kTierOptions{"avx2", "sse4", "ssse3", "scalar"};

/// The tier's name in keys and records, as of simd_tier(): "AVX2" for "avx2". Empty if there is no
/// such tier.
[[nodiscard]] std::string_view tier_named(std::string_view option);

/// Whether this machine's processor has the instructions of a tier ("AVX2").
[[nodiscard]] bool machine_has_tier(std::string_view tier);

/// The tier with which this process renders: the best that the machine has, unless a TierLimit
/// exists. Part of a frame's key.
[[nodiscard]] std::string_view simd_tier();

/// Lets the whole process render with a tier, as far as bits depend on it, while the object exists.
/// To be made before anything is prepared, and not twice at the same time.
class TierLimit {
  public:
    /// The machine must have the tier.
    explicit TierLimit(std::string_view tier);
    ~TierLimit();
    TierLimit(const TierLimit&) = delete;
    TierLimit& operator=(const TierLimit&) = delete;
};

}  // namespace carom::render
