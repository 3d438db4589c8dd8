#include "pipeline/video/audio_file.h"

#include <array>
#include <string_view>
#include <utility>

#include "core/assert.h"
#include "core/error.h"
#include "pipeline/video/audio_codec_info.h"
#include "pipeline/video/output_container.h"
#include "pipeline/video/pending_file.h"
#include "pipeline/video/picture_kind.h"
#include "pipeline/video/sound_stream.h"

namespace carom::pipeline {

namespace {

struct AudioFileKind {
    std::string_view extension;
    std::string_view muxer;  // the container's name in libavformat
    AudioCodec codec{};
};

constexpr std::array kKinds{
    AudioFileKind{".flac", "flac", AudioCodec::flac},
    AudioFileKind{".m4a", "ipod", AudioCodec::aac},
    AudioFileKind{".opus", "opus", AudioCodec::opus},
    AudioFileKind{".mka", "matroska", AudioCodec::flac},
};

const AudioFileKind* find_kind(const std::string& path) {
    const std::string extension = extension_of(path);
    for (const AudioFileKind& kind : kKinds) {
        if (kind.extension == extension) {
            return &kind;
        }
    }
    return nullptr;
}

double bit_rate_of(const AudioFileKind& kind, const std::optional<double>& wanted) {
    OutputSettings output;
    output.audio_bit_rate = wanted;
    return audio_bit_rate_of(output, kind.codec);
}

}  // namespace

std::string check_audio_path(const std::string& path) {
    if (find_kind(path) != nullptr) {
        return {};
    }
    std::string extensions;
    for (const AudioFileKind& kind : kKinds) {
        extensions += (extensions.empty() ? "" : ", ") + std::string(kind.extension);
    }
    return "'" + path + "' is not a known type of sound file; the file extensions are " +
           extensions;
}

// Members are destroyed from the last to the first: the container closes its file before the
// pending file removes it.
struct AudioFileWriter::State {
    State(const AudioFileKind& kind, const std::string& path, double bit_rate,
          const std::map<std::string, std::string>& metadata)
        : file(path),
          container(open_container(file, std::string(kind.muxer), metadata)),
          sound(*container, kind.codec, bit_rate, path) {
        write_header(*container, path);
    }

    PendingFile file;
    AvPtr<AVFormatContext> container;
    SoundStream sound;
};

AudioFileWriter::AudioFileWriter(const std::string& path, std::optional<double> bit_rate,
                                 const std::map<std::string, std::string>& metadata) {
    const AudioFileKind* kind = find_kind(path);
    if (kind == nullptr) {
        throw Error(check_audio_path(path));
    }
    if (bit_rate && !is_audio_bit_rate(*bit_rate)) {
        throw Error("cannot write '" + path + "': the bit rate must be from 32 to 512 kbit/s");
    }
    capture_av_log();
    state_ = std::make_unique<State>(*kind, path, bit_rate_of(*kind, bit_rate), metadata);
}

AudioFileWriter::~AudioFileWriter() = default;

void AudioFileWriter::write(std::span<const double> left, std::span<const double> right) {
    CAROM_ASSERT(state_ != nullptr);
    state_->sound.add(left, right);
}

void AudioFileWriter::finish() {
    CAROM_ASSERT(state_ != nullptr);
    const std::unique_ptr<State> state = std::move(state_);
    if (state->sound.samples() == 0) {
        throw Error("cannot write '" + state->file.target() + "': the sound has no samples");
    }
    state->sound.finish();
    close_container(*state->container, state->file);
}

}  // namespace carom::pipeline
