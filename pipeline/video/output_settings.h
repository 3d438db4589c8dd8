// Settings for the file that is made of the finished frames.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/vectors.h"

namespace carom::pipeline {

/// ocio: the view of the OpenColorIO configuration that the environment variable OCIO names; raw:
/// no conversion, for pictures that were computed in display values.
enum class ViewTransform { srgb, filmic, agx, ocio, raw };
enum class Codec { h264, hevc, av1, vp9, prores, ffv1, mjpeg, uncompressed };
/// Of the sound. none: the film has no sound.
enum class AudioCodec { aac, opus, flac, pcm, none };

/// Names from an OpenColorIO configuration; an empty name selects its default
/// (render/film/ocio_view.h).
struct OcioSettings {
    std::string display;
    std::string view;
    std::string colour_space;
};

/// See glow.h.
struct GlowSettings {
    double strength = 0;   // fraction of all light that is scattered, [0, 1]; 0: none
    double radius = 0.04;  // of the widest part of the glow, in picture heights, (0, 1]
    double halation = 0;   // red halo of film around bright light, [0, 10]; 1: ordinary film

    [[nodiscard]] bool is_seen() const { return strength > 0 || halation > 0; }
};

/// See grade.h; by channel.
struct GradeSettings {
    Vec3 slope{1, 1, 1};                    // [0, 16]
    Vec3 offset{0, 0, 0};                   // of the encoded light, [-1, 1]
    Vec3 power{1, 1, 1};                    // (0, 16]
    double saturation = 1;                  // [0, 4]
    std::optional<double> white_balance{};  // K, of the light that shall look white, [1667, 25000]
};

/// See render/denoise/denoise.h.
struct DenoiseSettings {
    double strength = 0;  // the rest is the picture as it was rendered, [0, 1]; 0: off
};

/// A film for displays of high dynamic range: PQ on BT.2020 primaries (see hdr_view.h).
struct Hdr10Settings {
    double peak = 1000;  // cd/m^2 of the brightest white in the file, [400, 10000]
    double white = 203;  // cd/m^2 of scene light 1, (0, peak]; ITU-R BT.2408's diffuse white
};

/// A file that is played under the film's sound, from the film's first frame on.
struct MusicSettings {
    std::string file;  // with sound in a format that libavformat reads
    double gain = 0;   // dB, [-60, 20]
    double fade = 0;   // s, over which it fades out at the end of the film, >= 0
};

/// What is printed in a corner of the picture.
enum class OverlayItem { frame, scene_time, playback_speed };
enum class Corner { top_left, top_right, bottom_left, bottom_right };

struct OverlaySettings {
    std::vector<OverlayItem> show;  // one line each; empty: no overlay
    Corner corner = Corner::bottom_left;
    double size = 0.045;  // of a line, in picture heights, [0.01, 0.5]
};

struct OutputSettings {
    std::optional<Codec> codec;      // none: follows from the file's extension (codec_for)
    std::optional<double> crf;       // none: the codec's own (codec_info.h)
    std::optional<double> bit_rate;  // bit/s, instead of a crf
    std::optional<int> bits;         // 8 or 10 per channel; none: the codec's own
    std::string preset =
        "medium";     // of the encoder; see encoder_presets.h for encoders without presets
    int threads = 2;  // of the encoder; x264's output depends on it
    ViewTransform view = ViewTransform::filmic;
    OcioSettings ocio;        // used only with the view ocio
    double exposure = 0;      // stops
    DenoiseSettings denoise;  // of the linear film, before the glow
    GlowSettings glow;        // added to the linear film, before the view
    GradeSettings grade;      // of the linear film, after glow and exposure
    double grain = 0;         // strength of film's grain in the display picture, [0, 20]; grain.h
    OverlaySettings overlay;  // drawn on the display picture, after the view
    std::optional<Hdr10Settings> hdr10;
    std::optional<AudioCodec> audio;       // none: follows from the file (audio_codec_for)
    std::optional<double> audio_bit_rate;  // bit/s; none: the codec's own (audio_codec_info.h)
    std::optional<MusicSettings> music;
    std::string title;             // empty: the shot's name
    std::optional<double> poster;  // video time (s) of the frame that stands for the film
};

}  // namespace carom::pipeline
