#include "pipeline/cli/farm/spare_files.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/hash.h"
#include "pipeline/store/file_descriptor.h"
#include "sim/timeline/bake_file.h"

namespace carom::cli {
namespace {

namespace fs = std::filesystem;
using farm::FarmJob;

std::string spare_folder(const FarmJob& job) {
    return job.folder + "/spare";
}

/// The files in a folder and below it, relative to it; none if there is no such folder.
std::vector<std::string> files_below(const std::string& folder) {
    std::vector<std::string> files;
    std::error_code failure;
    for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
         entry.increment(failure)) {
        if (fs::is_regular_file(entry->symlink_status(failure))) {
            files.push_back(entry->path().lexically_relative(folder).string());
        }
    }
    if (failure && failure != std::errc::no_such_file_or_directory) {
        throw Error("'" + folder + "' cannot be read: " + failure.message());
    }
    return files;
}

/// The job's own files, relative to its folder.
std::vector<std::string> own_files(const FarmJob& job) {
    if (!job.is_sequence) {
        return {job.name + ".bake"};
    }
    std::vector<std::string> files{job.name + ".yaml"};
    for (const fs::directory_entry& part : fs::directory_iterator(job.folder)) {
        const std::string folder = part.path().filename().string();
        if (!folder.starts_with(farm::kPartFolder)) {
            continue;
        }
        for (const fs::directory_entry& entry : fs::directory_iterator(part.path())) {
            if (entry.path().extension() == ".bake") {
                files.push_back(folder + "/" + entry.path().filename().string());
            }
        }
    }
    return files;
}

bool is_part_folder(const std::string& name) {
    const std::string prefix = farm::kPartFolder;
    return name.starts_with(prefix) && name.size() > prefix.size() &&
           name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
}

/// Whether a job has such a file of its own, which is named relative to its folder.
bool is_of_job(const FarmJob& job, const fs::path& file) {
    if (!job.is_sequence) {
        return file == job.name + ".bake";
    }
    return file == job.name + ".yaml" ||
           (file.extension() == ".bake" && is_part_folder(file.parent_path().string()));
}

/// Whether the file, or the folder in the job's in which it lies, is a link.
bool is_linked(const FarmJob& job, const fs::path& file) {
    std::error_code ignored;
    const fs::path folder = job.folder;
    return fs::is_symlink(folder / file, ignored) ||
           (file.has_parent_path() && fs::is_symlink(folder / file.parent_path(), ignored));
}

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(file), {}};
    if (!file) {
        throw Error("'" + path + "' cannot be read");
    }
    return content;
}

void copy(const std::string& from, const std::string& to) {
    const std::string content = content_of(from);
    pipeline::create_folder(fs::path(to).parent_path().string());
    write_file_atomically(to, std::as_bytes(std::span(content)));
}

bool is_intact(const std::string& path) {
    if (!path.ends_with(".bake")) {
        return true;  // the reader of the film finds out
    }
    try {
        (void)sim::read_bake(path);
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

void write_spare_files(const FarmJob& job) {
    for (const std::string& file : own_files(job)) {
        copy(job.folder + "/" + file, spare_folder(job) + "/" + file);
    }
}

OwnFiles restore_files(const FarmJob& job) {
    std::error_code ignored;
    if (fs::is_symlink(spare_folder(job), ignored)) {
        return OwnFiles::damaged;
    }
    std::vector<std::string> files = files_below(spare_folder(job));
    std::erase_if(files, [&](const std::string& file) {
        return !is_of_job(job, file) || is_linked(job, file);
    });
    OwnFiles result = OwnFiles::intact;
    for (const std::string& file : files) {
        const std::string own = job.folder + "/" + file;
        const std::string spare = spare_folder(job) + "/" + file;
        const Hash128 hash = hash_file(spare);  // throws if the store cannot be read now
        const bool is_there = fs::is_regular_file(own);
        const bool is_same = is_there && hash_file(own) == hash;
        if (is_intact(spare)) {
            if (!is_same) {
                copy(spare, own);
                result = OwnFiles::restored;
            }
        } else if (is_same || !is_there || !is_intact(own)) {
            return OwnFiles::damaged;
        }
    }
    return files.empty() ? OwnFiles::damaged : result;
}

}  // namespace carom::cli
