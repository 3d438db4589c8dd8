// Reads the sound of a file with libav's demuxer and decoder, independently of the code under test.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace carom::testing {

/// Samples that were decoded together, with the time that the file gives them.
struct DecodedBlock {
    double time = 0;  // s, of the first sample
    std::vector<double> left;
    std::vector<double> right;
};

/// A packet as the file has it.
struct PacketPlace {
    bool is_sound = false;
    double time = 0;  // s, of decoding
};

struct DecodedSound {
    bool has_sound = false;
    std::string codec;
    int rate = 0;  // Hz
    int channels = 0;
    int bits = 0;               // per sample, of lossless codecs
    double duration = 0;        // s, of the container
    double sound_duration = 0;  // s, of the sound's stream; 0: the file does not say
    std::vector<DecodedBlock> blocks;
    std::vector<double> picture_times;  // s, in order of presentation
    std::vector<PacketPlace> packets;   // in the order of the file

    [[nodiscard]] std::int64_t samples() const;
    /// All samples of the left or right channel, one block after the other.
    [[nodiscard]] std::vector<double> channel(bool is_right) const;
    /// The energy-weighted mean time, in s, of what is heard in both channels within 5 ms of
    /// `time`; -1 if that is silence.
    [[nodiscard]] double click_near(double time) const;
};

/// Throws std::runtime_error.
[[nodiscard]] DecodedSound decode_sound(const std::string& path);

}  // namespace carom::testing
