#include "pipeline/video/sound_length.h"

#include "core/assert.h"
#include "pipeline/camera/wide_rational.h"
#include "pipeline/video/sound_source.h"

namespace carom::pipeline {

std::int64_t first_sample(std::int64_t frame, const Rational& fps) {
    CAROM_ASSERT(frame >= 0);
    const WideRational samples =
        WideRational(Rational(frame)) * WideRational(Rational(kSoundRate)) / WideRational(fps);
    return (samples + WideRational(Rational(1, 2))).floor();
}

}  // namespace carom::pipeline
