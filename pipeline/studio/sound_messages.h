// What the server says of the film's sound. messages.h says how the messages are sent.
#pragma once

#include <cstdint>
#include <string>

namespace carom::studio {

/// The sound of the film, of the newest version that was still for a moment. Sent when its first
/// piece is there, and with each further one. A sound with another address is another one; that of
/// an older version stays until then.
///
/// A piece is GET at `address` + "0.pcm", "1.pcm" ... : 16-bit numbers, little-endian, a left and a
/// right one for each sample; 32767 is full scale.
struct SoundState {
    static constexpr const char* kName = "sound";
    std::int64_t v = 0;
    std::string reason{};      // a sentence why there is no sound; empty: there is one
    std::string address{};     // "/sound/3/"
    int rate = 0;              // samples per second
    std::int64_t samples = 0;  // of each channel, of the whole film
    std::int64_t piece = 0;    // of each piece; the last one may be shorter
    std::int64_t ready = 0;    // from the film's start, in the pieces that can be got
};

}  // namespace carom::studio
