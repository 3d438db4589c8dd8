#include "pipeline/studio/shot_root.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "pipeline/sequence/load_sequence.h"
#include "pipeline/studio/paths.h"

namespace carom::studio {

namespace fs = std::filesystem;

namespace {

/// The last folder that both paths have in common. They are absolute.
fs::path common_folder(const fs::path& folder, const fs::path& file) {
    fs::path common;
    auto a = folder.begin();
    auto b = file.begin();
    for (; a != folder.end() && b != file.end() && *a == *b; ++a, ++b) {
        common /= *a;
    }
    return common;
}

bool may_be_root(const fs::path& folder) {
    const char* home = std::getenv("HOME");
    const std::string home_folder = home == nullptr ? "" : whole_path(home);
    const bool holds_home = home_folder == folder || is_below(home_folder, folder.string());
    struct stat status {};
    return std::distance(folder.begin(), folder.end()) > 2 && !holds_home &&
           ::stat(folder.c_str(), &status) == 0 && status.st_uid == ::geteuid();
}

/// The files that exist and are refused because they are outside the root.
std::vector<std::string> files_outside(const std::string& shot,
                                       const pipeline::LoadOptions& options) {
    std::vector<std::string> files = pipeline::is_sequence_file(shot)
                                         ? pipeline::load_sequence(shot, options).missing
                                         : pipeline::load_shot(shot, options).missing;
    std::erase_if(files, [&](const std::string& file) {
        return is_below(file, options.root) || !is_there(file);
    });
    return files;
}

}  // namespace

std::string shot_root(const std::string& shot, const std::string& folder,
                      const pipeline::LoadOptions& options) {
    constexpr int kMostRounds = 16;  // of files that name others further outside
    pipeline::LoadOptions within = options;
    within.root = folder;
    within.most_asset_bytes = 1;  // no mesh or image is read for this
    for (int round = 0; round < kMostRounds; ++round) {
        const std::string before = within.root;
        for (const std::string& file : files_outside(shot, within)) {
            const fs::path wider = common_folder(within.root, file);
            if (may_be_root(wider)) {
                within.root = wider.string();
            }
        }
        if (within.root == before) {
            break;
        }
    }
    return within.root;
}

}  // namespace carom::studio
