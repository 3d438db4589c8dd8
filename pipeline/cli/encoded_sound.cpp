#include "pipeline/cli/encoded_sound.h"

#include "pipeline/video/audio_file.h"

namespace carom::cli {

namespace {

class EncodedSoundFile final : public SoundFile {
  public:
    explicit EncodedSoundFile(const std::string& path) : file_(path) {}
    void write(std::span<const double> left, std::span<const double> right) override {
        file_.write(left, right);
    }
    void finish() override { file_.finish(); }

  private:
    pipeline::AudioFileWriter file_;
};

}  // namespace

void write_encoded_sound(const SoundCommand& command, CommandContext& context) {
    const std::string problem = pipeline::check_audio_path(command.output);
    if (!problem.empty()) {
        throw InputError(problem + ", and .wav");
    }
    write_sound(command, context, [](const std::string& path, std::int64_t /*samples*/) {
        return std::make_unique<EncodedSoundFile>(path);
    });
}

}  // namespace carom::cli
