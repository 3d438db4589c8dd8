// The keys of the section `output`.
#include <fmt/core.h>

#include "pipeline/config/sections/sections.h"
#include "pipeline/config/text.h"
#include "pipeline/config/value_types.h"
#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/codec_info.h"
#include "pipeline/video/encoder_presets.h"

namespace carom::pipeline::config {

namespace {

/// "8 Mbit/s", "500 kbit/s", or a plain number of bits per second.
ValueType<double> bit_rate() {
    ValueType<double> type;
    type.info.kind = TypeInfo::Kind::text;
    type.info.noun = "a bit rate";
    type.read = [](Reader& reader, const Node& node) -> std::optional<double> {
        std::string text = node.is_scalar() ? node.text : std::string();
        double factor = 1;
        for (const auto& [unit, value] :
             {std::pair<std::string_view, double>{"Mbit/s", 1e6}, {"kbit/s", 1e3}, {"bit/s", 1}}) {
            if (text.ends_with(unit)) {
                text.resize(text.size() - unit.size());
                factor = value;
                break;
            }
        }
        while (text.ends_with(' ')) {
            text.pop_back();
        }
        const auto number = parse_quantity(text);
        const auto* quantity = std::get_if<Quantity>(&number);
        if (quantity == nullptr || quantity->has_unit) {
            reader.wrong_type(node, "a bit rate such as 8 Mbit/s, 500 kbit/s or 8e6");
            return std::nullopt;
        }
        return factor * quantity->value;
    };
    return type;
}

const MapSpec<MusicSettings>& music_spec() {
    static const MapSpec<MusicSettings> spec = [] {
        MapSpec<MusicSettings> s("music", "A file that is mixed with the film's sound.");
        s.key("file", &MusicSettings::file, file(FileKind::music),
              "a file with sound: .flac, .wav, .mp3, .m4a, .ogg and others; more than two channels "
              "are mixed to two")
            .required();
        s.key("gain", &MusicSettings::gain, quantity(Dimension::level, between(-60, 20)),
              "how much louder it is made beside the film's sound");
        s.key("fade", &MusicSettings::fade, time(at_least(0)),
              "time over which it fades out at the end of the film");
        return s;
    }();
    return spec;
}

/// The name of a file alone, or a map.
ValueType<MusicSettings> music() {
    const auto name = convert<MusicSettings>(file(FileKind::music), [](std::string path) {
        MusicSettings settings;
        settings.file = std::move(path);
        return settings;
    });
    return any_of<MusicSettings>({{is_scalar, name}, {is_map, record(music_spec())}});
}

const MapSpec<Hdr10Settings>& hdr10_spec() {
    static const MapSpec<Hdr10Settings> spec = [] {
        MapSpec<Hdr10Settings> s("hdr10",
                                 "A film for displays with high dynamic range: PQ, BT.2020.");
        s.key("peak", &Hdr10Settings::peak, number(between(400, 10000)),
              "luminance of the brightest white in cd/m^2; highlights are compressed to stay below "
              "it");
        s.key("white", &Hdr10Settings::white, number(above_up_to(0, 10000)),
              "luminance of scene light 1 in cd/m^2");
        return s;
    }();
    return spec;
}

const MapSpec<OcioSettings>& ocio_spec() {
    static const MapSpec<OcioSettings> spec = [] {
        MapSpec<OcioSettings> s("ocio", "Names in an OpenColorIO configuration.");
        s.key("display", &OcioSettings::display, text("a name"),
              "display. The default is that of the configuration");
        s.key("view", &OcioSettings::view, text("a name"),
              "view. The default is that of the display");
        s.key("colour_space", &OcioSettings::colour_space, text("a name"),
              "name of linear Rec.709, the colour space of the film. The default is the role "
              "scene_linear");
        return s;
    }();
    return spec;
}

const MapSpec<DenoiseSettings>& denoise_spec() {
    static const MapSpec<DenoiseSettings> spec = [] {
        MapSpec<DenoiseSettings> s("denoise", "The noise of sampling is filtered out.");
        s.key("strength", &DenoiseSettings::strength, number(between(0, 1)),
              "how much of the filtered picture is shown; the rest is the noisy one");
        return s;
    }();
    return spec;
}

/// `true` is the full strength, `false` none.
ValueType<DenoiseSettings> denoise() {
    const auto word = convert<DenoiseSettings>(
        boolean(), [](bool is_on) { return DenoiseSettings{is_on ? 1.0 : 0.0}; });
    return any_of<DenoiseSettings>({{is_scalar, word}, {is_map, record(denoise_spec())}});
}

const MapSpec<GlowSettings>& glow_spec() {
    static const MapSpec<GlowSettings> spec = [] {
        MapSpec<GlowSettings> s("glow", "Light that lens and eye scatter around bright points.");
        s.key("strength", &GlowSettings::strength, number(between(0, 1)),
              "fraction of all light that is scattered: 0.05 looks like a light haze");
        s.key("radius", &GlowSettings::radius, number(above_up_to(0, 1)),
              "radius of the widest part, in picture heights");
        s.key("halation", &GlowSettings::halation, number(between(0, 10)),
              "red halo of film around what is brighter than white: 1 is ordinary film");
        return s;
    }();
    return spec;
}

const MapSpec<GradeSettings>& grade_spec() {
    static const MapSpec<GradeSettings> spec = [] {
        MapSpec<GradeSettings> s(
            "grade",
            "A colourist's change of the light before the view, as ASC CDL has "
            "it: a number, or one for each of red, green and blue.");
        s.key("slope", &GradeSettings::slope, colour(between(0, 16)),
              "factor on the logarithm of light: the contrast, around black");
        s.key("offset", &GradeSettings::offset, colour(between(-1, 1)),
              "what is added to it: 0.057 is one stop");
        s.key("power", &GradeSettings::power, colour(above_up_to(0, 16)),
              "exponent: above 1 the middle tones become darker");
        s.key("saturation", &GradeSettings::saturation, number(between(0, 4)),
              "how far colours are from grey; 0: black and white");
        s.key(
            "white_balance", &GradeSettings::white_balance, number(between(1667, 25000)),
            "temperature in kelvin of the light that shall look white: 2700 for light bulbs, 6500 "
            "for a cloudy day. It comes before the rest");
        return s;
    }();
    return spec;
}

ValueType<OverlayItem> overlay_item() {
    ValueType<OverlayItem> item =
        choice<OverlayItem>({{"frame", OverlayItem::frame},
                             {"scene_time", OverlayItem::scene_time},
                             {"playback_speed", OverlayItem::playback_speed}});
    item.read = [read = item.read](Reader& reader, const Node& node) -> std::optional<OverlayItem> {
        if (node.is_scalar() && node.text == "speed") {
            reader.error(node.place, {"'speed' is now called 'playback_speed', because it is the "
                                      "speed of the film, not of a ball",
                                      "playback_speed"});
            return std::nullopt;
        }
        return read(reader, node);
    };
    return item;
}

ValueType<std::vector<OverlayItem>> overlay_items() {
    return list_of(overlay_item(), 1, 3);
}

const MapSpec<OverlaySettings>& overlay_spec() {
    static const MapSpec<OverlaySettings> spec = [] {
        MapSpec<OverlaySettings> s("overlay", "Text that is written into the picture.");
        s.key("show", &OverlaySettings::show, overlay_items(), "values to show, one per line")
            .required();
        s.key("corner", &OverlaySettings::corner,
              choice<Corner>({{"top_left", Corner::top_left},
                              {"top_right", Corner::top_right},
                              {"bottom_left", Corner::bottom_left},
                              {"bottom_right", Corner::bottom_right}}),
              "corner of the picture");
        s.key("size", &OverlaySettings::size, number(between(0.01, 0.5)),
              "height of a line, in picture heights");
        return s;
    }();
    return spec;
}

ValueType<OverlaySettings> overlay() {
    const auto items = convert<OverlaySettings>(overlay_items(), [](std::vector<OverlayItem> show) {
        OverlaySettings settings;
        settings.show = std::move(show);
        return settings;
    });
    return any_of<OverlaySettings>({{is_list, items}, {is_map, record(overlay_spec())}});
}

}  // namespace

const MapSpec<OutputSettings>& output_spec() {
    static const MapSpec<OutputSettings> spec = [] {
        MapSpec<OutputSettings> s("output", "How the frames become a film.");
        std::vector<std::pair<std::string, Codec>> names;
        for (const CodecInfo& codec : codecs()) {
            names.emplace_back(codec.name, codec.codec);
        }
        s.key("codec", &OutputSettings::codec, choice<Codec>(names),
              "codec of the video. The default depends on the file's extension: vp9 for .webm, "
              "mjpeg for .avi, h264 for others (hevc with `hdr10`)");
        s.key("crf", &OutputSettings::crf, number(between(0, 63)),
              "constant rate factor: a lower value gives better quality and a larger file. Up to "
              "51 for h264 (default 18, which looks lossless) and hevc (default 20), up to 63 for "
              "av1 and vp9 (default 24)");
        s.key("bit_rate", &OutputSettings::bit_rate, bit_rate(),
              "mean bit rate, instead of a crf: 8 Mbit/s, 500 kbit/s, 8e6");
        s.key("bits", &OutputSettings::bits, integer(8, 10),
              "bits per channel, 8 or 10. The default is 8, or 10 with `hdr10`. prores always has "
              "10, ffv1 16, mjpeg and uncompressed 8");
        std::vector<std::pair<std::string, AudioCodec>> audio_names;
        for (const AudioCodecInfo& codec : audio_codecs()) {
            audio_names.emplace_back(codec.name, codec.codec);
        }
        audio_names.emplace_back("none", AudioCodec::none);
        s.key(
            "audio", &OutputSettings::audio, choice<AudioCodec>(audio_names),
            "codec of the sound; `none` writes a silent film. The default depends on the file: "
            "aac in .mp4 and .mov (pcm with prores), flac in .mkv, opus in .webm, pcm in .avi. "
            "Picture sequences have their sound in a .wav file beside them, unless this is `none`");
        s.key("audio_bit_rate", &OutputSettings::audio_bit_rate, bit_rate(),
              "bit rate of both channels of the sound together, from 32 to 512 kbit/s. The default "
              "is 256 kbit/s for aac and 192 kbit/s for opus; flac and pcm are lossless");
        s.key("music", &OutputSettings::music, music(),
              "a file that is mixed with the film's sound, from the first frame on: its name, or a "
              "map with gain and fade. Loudness and true peak are those of the mix");
        std::vector<std::pair<std::string, std::string>> presets;
        presets.reserve(kEncoderPresets.size());
        for (const EncoderPreset& preset : kEncoderPresets) {
            presets.emplace_back(preset.name, preset.name);
        }
        s.key("preset", &OutputSettings::preset, choice<std::string>(presets),
              "how much time the encoder spends to make the file smaller");
        s.key("threads", &OutputSettings::threads, integer(1, 64),
              "threads of the encoder; the file's bytes depend on this number");
        s.key("view", &OutputSettings::view,
              choice<ViewTransform>({{"srgb", ViewTransform::srgb},
                                     {"filmic", ViewTransform::filmic},
                                     {"agx", ViewTransform::agx},
                                     {"ocio", ViewTransform::ocio},
                                     {"raw", ViewTransform::raw}}),
              "view transform from scene light to the values of a display. `ocio` uses the "
              "OpenColorIO configuration that the environment variable OCIO names; `raw` writes "
              "the numbers as they are");
        s.key("ocio", &OutputSettings::ocio, record(ocio_spec()),
              "display, view and colour space for `view: ocio`");
        s.key("denoise", &OutputSettings::denoise, denoise(),
              "whether the noise of sampling is filtered out of the finished frames: true, or how "
              "strongly. The samples of a frame are then taken in two halves");
        s.key("glow", &OutputSettings::glow, record(glow_spec()),
              "light that lens and eye scatter around bright points");
        s.key("grade", &OutputSettings::grade, record(grade_spec()),
              "a change of colours and contrast before the view");
        s.key("grain", &OutputSettings::grain, number(between(0, 20)),
              "grain of photographic film: 1 is a fine-grained 35 mm film, 3 a fast one");
        s.check([](Reader& reader, const Node& node, OutputSettings& output) {
            const Entry* ocio = node.find("ocio");
            if (ocio != nullptr && output.view != ViewTransform::ocio) {
                reader.error(ocio->value.place, "'ocio' can only be used with 'view: ocio'");
            }
        });
        s.key("hdr10", &OutputSettings::hdr10, record(hdr10_spec()),
              "output for displays with high dynamic range, instead of the view: 10-bit hevc");
        s.key("overlay", &OutputSettings::overlay, overlay(),
              "values written into a corner of the film, one per line: `frame` (number), "
              "`scene_time`, `playback_speed`; or a map with position and size");
        s.key("title", &OutputSettings::title, text("a title"),
              "title in the file's metadata. The default is the shot's name");
        s.key("poster", &OutputSettings::poster, time(at_least(0)),
              "video time of the frame that is the film's cover picture: embedded in an .mp4, "
              "written as NAME-poster.jpg for other files");
        s.at_most_one_of({"crf", "bit_rate"});
        s.key("exposure", &OutputSettings::exposure, number(between(-32, 32)), "exposure in stops");
        return s;
    }();
    return spec;
}

}  // namespace carom::pipeline::config
