// Writes the sound of a film to files.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "pipeline/cli/commands.h"
#include "pipeline/cli/run_program.h"

namespace carom::cli {

/// A file that takes samples in units of full scale, in blocks of any size. It gets its name when
/// it is finished.
class SoundFile {
  public:
    SoundFile() = default;
    virtual ~SoundFile() = default;
    SoundFile(const SoundFile&) = delete;
    SoundFile& operator=(const SoundFile&) = delete;

    virtual void write(std::span<const double> left, std::span<const double> right) = 0;
    virtual void finish() = 0;
};

/// Opens a file for that many samples of each channel.
using SoundFileMaker =
    std::function<std::unique_ptr<SoundFile>(const std::string& path, std::int64_t samples)>;

/// Runs the command. Throws Error, Stopped.
void write_sound(const SoundCommand& command, CommandContext& context, const SoundFileMaker& make);

/// A .wav file.
[[nodiscard]] std::unique_ptr<SoundFile> make_wav_file(const std::string& path,
                                                       std::int64_t samples);

}  // namespace carom::cli
