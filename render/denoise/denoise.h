// Takes the noise of sampling out of a picture that was rendered as two halves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/progress.h"

namespace carom::render {

/// Incremented whenever denoised pixels change for the same inputs.
inline constexpr int kDenoiserRevision = 6;

/// Numbers of a picture, row by row from the top left: floats, of which every `step`th belongs to
/// this plane, or the bits of half floats. Borrowed.
struct PlaneView {
    const float* first = nullptr;
    std::ptrdiff_t step = 1;
    const std::uint16_t* halves = nullptr;

    [[nodiscard]] bool empty() const { return first == nullptr && halves == nullptr; }
};

/// A channel of colour in both halves: A = mean + difference, B = mean - difference.
struct ColourPlanes {
    PlaneView mean;
    PlaneView difference;
};

/// A channel of a feature, which is something that the camera sees at its rays' first hits (albedo,
/// normal, light). In half A it is exact + error + difference, in half B exact + error -
/// difference: means over the very samples that made the colour.
struct FeaturePlanes {
    PlaneView exact;  // the same mean over more camera rays, and over both halves' samples
    PlaneView error;
    PlaneView difference;
};

/// What is known of a noisy picture. Numbers that are not finite count as 0.
struct DenoiseInput {
    static constexpr std::size_t kMostFeatures = 9;

    int width = 0;  // pixels
    int height = 0;
    ColourPlanes colour[3];
    std::vector<FeaturePlanes> features;  // in threes, such as a colour; at most kMostFeatures
    /// The weight of the halves' samples in the exact features, [0, 1]; empty if they do
    /// not contain them.
    PlaneView share_of_samples;
    /// Variance of the mean luminance, right up to a factor that changes slowly over the picture;
    /// empty if it is not known.
    PlaneView variance;
};

struct DenoiseShape {
    int width = 0;  // pixels
    int height = 0;
    std::size_t features = 0;  // in threes, such as a colour; at most kMostFeatures
    bool has_variance = false;
    bool has_share = false;
};

/// Hands out what is known of a noisy picture row by row, so that it need not all be in memory in
/// this form. Any thread may ask for any row, also several times. Numbers that are not finite count
/// as 0.
class DenoiseSource {
  public:
    virtual ~DenoiseSource() = default;

    /// Where to write the row's numbers; `variance` is null if there is none.
    struct ColourRows {
        float* mean[3];
        float* difference[3];
        float* variance;
    };
    struct FeatureRows {
        float* exact[DenoiseInput::kMostFeatures];
        float* error[DenoiseInput::kMostFeatures];
        float* difference[DenoiseInput::kMostFeatures];
        float* share;
    };
    [[nodiscard]] virtual DenoiseShape shape() const = 0;
    virtual void colours(int y, const ColourRows& rows) const = 0;
    virtual void features(int y, const FeatureRows& rows) const = 0;
};

/// From planes.
class PlaneSource final : public DenoiseSource {
  public:
    explicit PlaneSource(DenoiseInput input) : input_(std::move(input)) {}

    [[nodiscard]] DenoiseShape shape() const override;
    void colours(int y, const ColourRows& rows) const override;
    void features(int y, const FeatureRows& rows) const override;

  private:
    void read(const PlaneView& view, int y, float* row) const;

    DenoiseInput input_;
};

struct DenoisedPicture {
    std::vector<float> rgb;  // width * height * 3, row by row from the top left, >= 0
    /// The estimated mean over the channels of (x - r)^2 / (r^2 + 0.01), where r is the picture
    /// without noise, averaged over 11x11 pixels. It is noisy itself, but right on average, except
    /// that it is not taken to be less than 6 % of the noisy picture's. What is predicted from one
    /// half is compared with the other half, whose noise is independent; for that it is predicted
    /// from features that do not contain the other half's samples.
    std::vector<float> error;
};

/// First-order regression on features (Bitterli, Rousselle, Moon, Iglesias-Guitian, Adler,
/// Mitchell, Jarosz and Novak 2016, "Nonlinearly weighted first-order regression for denoising
/// Monte Carlo renderings"): around each pixel, a linear function of the features is fitted to the
/// colours of half A, weighted by the likeness of patches in half B (non-local means), and the
/// other way round. It is fitted against the features of the half's own samples and evaluated at
/// the exact ones, so that what lens, shutter and pixel filter did to these samples is taken out: a
/// control variate. Where the estimated error of the noisy picture is lower, or the filter moved
/// colours farther than their noise explains, that one stays.
///
/// Rows are shared by the threads of the caller's arena. The bits depend neither on threads nor on
/// the processor. Besides the result it takes about 40 kB of memory for each column of a picture,
/// of 1920 columns if it has fewer. Throws Stopped.
[[nodiscard]] DenoisedPicture denoise(const DenoiseInput& input, const WorkContext& context = {});

/// DenoisedPicture::error alone, in 23 kB a column. Throws Stopped.
[[nodiscard]] std::vector<float> error_after_denoising(const DenoiseSource& source,
                                                       const WorkContext& context = {});

}  // namespace carom::render
