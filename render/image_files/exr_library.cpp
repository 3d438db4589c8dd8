#include "render/image_files/exr_library.h"

#include <algorithm>
#include <thread>

#include <ImfThreading.h>

namespace carom::render {
namespace {

/// A block of a file is 16 rows, so that more threads would have little to do.
constexpr unsigned kMostThreads = 8;

}  // namespace

void use_exr_threads() {
    static const int threads = [] {
        const int wanted =
            static_cast<int>(std::min(std::thread::hardware_concurrency(), kMostThreads));
        Imf::setGlobalThreadCount(wanted > 1 ? wanted : 0);
        return wanted;
    }();
    static_cast<void>(threads);
}

std::string exr_reason(std::string library_text) {
    while (!library_text.empty() && (library_text.back() == '\n' || library_text.back() == ' ')) {
        library_text.pop_back();
    }
    std::replace(library_text.begin(), library_text.end(), '\n', ' ');
    return library_text.empty() ? "no reason given" : library_text;
}

}  // namespace carom::render
