// The sound of the frames that a job writes.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/camera/rational.h"
#include "pipeline/video/output_settings.h"
#include "pipeline/video/sound_source.h"
#include "sound/mix/added_sound.h"

namespace carom::pipeline {

/// What a film's sound is made with.
struct SoundContext {
    sound::AddedSound music;  // to be mixed with it; empty: none
    /// Called while the sound is made, on the thread that encodes. May be empty.
    std::function<void(const std::string& message)> on_warning{};
};

/// Makes the sound of a whole film, which begins with frame 0. Called when the first sample is
/// needed, on the thread that encodes, and once for each file that is written.
using SoundMaker = std::function<std::unique_ptr<SoundSource>(const SoundContext& context)>;

/// A film as its sound needs it.
struct SoundedFilm {
    std::int64_t frames = 0;  // of the whole film
    Rational fps{24};
};

/// What `make` makes, with its warnings passed on; empty if `make` is.
[[nodiscard]] SoundMaker with_warnings(SoundMaker make,
                                       std::function<void(const std::string& message)> on_warning);

/// The sound of the whole film: what `make` makes, with the music of `output`. Null if there is
/// neither, or if `output` wants no sound. `make` may be empty. Opens the music. Throws Error.
[[nodiscard]] std::unique_ptr<SoundSource> sound_of_film(const SoundMaker& make,
                                                         const OutputSettings& output,
                                                         const SoundedFilm& film);

/// The sound of a film that consists of these frames alone, which must be ascending: of each its
/// own part, so that what begins in a frame is heard when the frame is shown. Null as in
/// sound_of_film, and if the frames leave out others one by one (lacks_sound). Throws Error.
[[nodiscard]] std::unique_ptr<SoundSource> sound_of_frames(const SoundMaker& make,
                                                           const OutputSettings& output,
                                                           const SoundedFilm& film,
                                                           const std::vector<std::int64_t>& frames);

/// About how many bytes the sound of these frames takes in the file; 0 as where sound_of_frames
/// gives none.
[[nodiscard]] double sound_bytes(const SoundMaker& make, const OutputSettings& output,
                                 const std::string& path, const SoundedFilm& film,
                                 const std::vector<std::int64_t>& frames);

/// Whether more than half of the frames do not follow their predecessors. The sound of every tenth
/// frame, for example, would be a buzz.
[[nodiscard]] bool lacks_sound(const std::vector<std::int64_t>& frames);

/// Empty, or a sentence for the user that says why a film of these frames is silent although there
/// is a sound.
[[nodiscard]] std::string silence_note(const SoundMaker& make, const OutputSettings& output,
                                       const std::string& path,
                                       const std::vector<std::int64_t>& frames);

}  // namespace carom::pipeline
