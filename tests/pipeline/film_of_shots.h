// Tells films of several shots among the examples from shots.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace carom::testing {

/// Whether the file has the key `film`.
inline bool is_film_of_shots(const std::filesystem::path& path) {
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return text.find("\nfilm:") != std::string::npos;
}

}  // namespace carom::testing
