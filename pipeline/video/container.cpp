#include "pipeline/video/container.h"

#include <array>
#include <cctype>
#include <filesystem>

#include "pipeline/video/video_format.h"

namespace carom::pipeline {

namespace {

constexpr std::array kContainers{
    Container{".mp4", "mp4", true, false},
    Container{".mov", "mov", true, false},
    Container{".mkv", "matroska", true, true},
};

}  // namespace

std::span<const Container> containers() {
    return kContainers;
}

const Container* find_container(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& letter : extension) {
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    for (const Container& container : kContainers) {
        if (container.extension == extension) {
            return &container;
        }
    }
    return nullptr;
}

std::string list_containers() {
    std::string text;
    for (const Codec codec : {Codec::h264, Codec::ffv1}) {
        text += (text.empty() ? "" : "; ") + to_string(codec) + ":";
        const char* separator = " ";
        for (const Container& container : kContainers) {
            if (container.holds(codec)) {
                text += separator + std::string(container.extension);
                separator = ", ";
            }
        }
    }
    return text;
}

}  // namespace carom::pipeline
