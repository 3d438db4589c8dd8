// Opens the files that a shot names, and finds what is wrong in them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "pipeline/config/named_file.h"

namespace carom::pipeline {

struct FileCheckOptions {
    /// Files are read whole as long as they have so many bytes together, the smallest first; of all
    /// others only the headers are read.
    std::uintmax_t most_bytes = std::uintmax_t{64} * 1'000'000;
    /// Throws Error if the file has no sound that can be played. Empty: music is not opened.
    std::function<void(const std::string& path)> try_music{};
};

struct FileReport {
    std::vector<Problem> problems;            // each of them once, in the order of the files
    std::vector<NamedFile> read_by_header{};  // each file once
};

/// Remembers what was found in files that have not changed since. For one thread at a time.
class FileChecker {
  public:
    [[nodiscard]] FileReport check(std::span<const NamedFile> files,
                                   const FileCheckOptions& options = {});

  private:
    /// What was found in a file.
    struct Finding {
        std::vector<std::string> problems;
        std::vector<std::string> warnings;
        std::size_t pixels = 0;       // of a picture that was read whole
        std::size_t clamped = 0;      // of these, with a value that light cannot have
        std::size_t transparent = 0;  // of these
    };
    /// How a file is read, and the state in which it was.
    using Reading =
        std::tuple<std::string, FileKind, bool, std::uintmax_t, std::filesystem::file_time_type>;

    const Finding& finding(const NamedFile& file, std::uintmax_t size, bool is_whole,
                           const FileCheckOptions& options);
    static Finding examine(const NamedFile& file, bool is_whole, const FileCheckOptions& options);
    static std::vector<std::string> warnings_of(const NamedFile& file, const Finding& found);
    static void examine_mesh(const std::string& path, bool is_whole, Finding& finding);
    static void examine_picture(const std::string& path, bool is_whole, Finding& finding);

    std::map<Reading, Finding> known_;
};

}  // namespace carom::pipeline
