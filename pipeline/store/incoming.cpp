#include "pipeline/store/incoming.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/core.h>
#include <stdlib.h>

#include "pipeline/store/cache_folder.h"
#include "pipeline/store/file_descriptor.h"

namespace carom::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::hours kOldAfter{24};

/// Of a file, or the newest of a folder and all in it.
fs::file_time_type last_change(const fs::path& path) {
    std::error_code ignored;
    fs::file_time_type newest = fs::last_write_time(path, ignored);
    for (const auto& entry : fs::recursive_directory_iterator(path, ignored)) {
        newest = std::max(newest, entry.last_write_time(ignored));
    }
    return newest;
}

void remove_if_old(const fs::path& path) {
    std::error_code ignored;
    if (fs::file_time_type::clock::now() - last_change(path) > kOldAfter) {
        fs::remove_all(path, ignored);
    }
}

}  // namespace

std::string make_incoming_folder(const std::string& cache_folder) {
    try {
        create_folder(cache_folder + "/incoming");
    } catch (const Error& error) {
        throw CacheUnusable(error.what());
    }
    std::string folder = cache_folder + "/incoming/XXXXXX";
    if (::mkdtemp(folder.data()) == nullptr) {
        throw CacheUnusable(system_problem(folder, "the folder cannot be created"));
    }
    return folder;
}

void remove_old_arrivals(const std::string& cache_folder) {
    std::error_code ignored;
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(cache_folder + "/incoming", ignored)) {
        paths.push_back(entry.path());
    }
    for (const char* folder : {"/frames", "/bakes"}) {
        for (const auto& entry : fs::recursive_directory_iterator(cache_folder + folder, ignored)) {
            if (entry.path().filename().string().starts_with(".")) {
                paths.push_back(entry.path());
            }
        }
    }
    for (const fs::path& path : paths) {
        remove_if_old(path);
    }
}

}  // namespace carom::pipeline
