// How a session starts carom as a program beside itself, for films and documents.
#pragma once

#include <string>
#include <vector>

namespace carom::studio {

struct ProgramOptions {
    std::string program{};  // carom
    std::vector<std::string> overrides{};
    std::string quality{};       // of requests without one
    std::string output{};        // folder of what is written; empty: that of the shot
    std::string cache_folder{};  // empty: the usual one
};

}  // namespace carom::studio
