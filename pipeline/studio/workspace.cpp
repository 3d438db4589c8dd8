#include "pipeline/studio/workspace.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include <sys/stat.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "pipeline/config/parse_yaml.h"
#include "pipeline/config/text.h"
#include "pipeline/studio/paths.h"
#include "pipeline/studio/text_hash.h"

namespace carom::studio {

namespace fs = std::filesystem;
using pipeline::config::quote;

namespace {

/// The name of the file with that number, among the first entries of a folder; empty if there is
/// none.
std::string name_of_node(const fs::path& folder, std::uint64_t device, std::uint64_t node) {
    constexpr int kMostEntries = 10'000;
    std::error_code code;
    fs::directory_iterator entry(folder, code);
    for (int i = 0; !code && entry != fs::directory_iterator() && i < kMostEntries; ++i) {
        struct stat status {};
        if (::lstat(entry->path().c_str(), &status) == 0 && status.st_ino == node &&
            status.st_dev == device) {
            return entry->path().filename().string();
        }
        entry.increment(code);
    }
    return "";
}

}  // namespace

Workspace::Workspace(const std::string& shot, const std::string& root)
    : shot_(whole_path(shot)),
      root_(whole_path(root.empty() ? fs::path(shot_).parent_path().string() : root)),
      texts_(std::make_shared<const pipeline::config::OpenTexts>()) {
    std::string text;
    if (!pipeline::config::read_text_file(shot_, pipeline::config::YamlLimits{}.bytes, text)) {
        throw Error("the file " + quote(shot) + " " + text);
    }
    disk_[shot_] = read(shot_);
    files_.push_back({shot_, fs::path(shot_).filename().string()});
}

Workspace::DiskFile Workspace::read(const std::string& path) {
    DiskFile file;
    if (!pipeline::config::read_text_file(path, pipeline::config::YamlLimits{}.bytes, file.text)) {
        return {.problem = std::move(file.text)};
    }
    file.hash = hash_of(file.text);
    note_node(path, file);
    return file;
}

void Workspace::note_node(const std::string& path, DiskFile& file) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) {
        file.device = status.st_dev;
        file.node = status.st_ino;
    }
}

DiskChanged Workspace::gone(const std::string& file, const DiskFile& before, const DiskFile& now) {
    std::error_code code;
    if (fs::symlink_status(file, code).type() != fs::file_type::not_found) {
        return {file, "", "", now.problem, false};
    }
    const std::string name =
        before.node == 0 ? ""
                         : name_of_node(fs::path(file).parent_path(), before.device, before.node);
    return {file, "", "", name.empty() ? "was deleted" : "was renamed to " + quote(name), false};
}

bool Workspace::set_files(const std::vector<pipeline::ReadFile>& files) {
    if (files.empty() || files == files_) {
        return false;
    }
    const bool is_other = !std::ranges::equal(files, files_, {}, &pipeline::ReadFile::path,
                                              &pipeline::ReadFile::path);
    files_ = files;
    for (const pipeline::ReadFile& file : files_) {
        if (!disk_.contains(file.path)) {
            disk_[file.path] = read(file.path);
        }
    }
    return is_other;
}

Files Workspace::files() const {
    Files message;
    message.v = version_;
    for (const pipeline::ReadFile& file : files_) {
        const auto known = disk_.find(file.path);
        const DiskFile disk = known == disk_.end() ? DiskFile{} : known->second;
        const auto open = texts_->find(file.path);
        OpenFile entry;
        entry.file = file.path;
        const fs::path name = fs::path(file.path).lexically_relative(fs::path(shot_).parent_path());
        entry.name =
            is_below(file.path, root_) ? name.string() : fs::path(file.path).filename().string();
        entry.text = open == texts_->end() ? disk.text : open->second;
        entry.hash = disk.hash;
        entry.writable = is_writable(file.path, root_);
        entry.changed = entry.text != disk.text;
        message.files.push_back(std::move(entry));
    }
    return message;
}

bool Workspace::is_known(const std::string& file) const {
    return std::ranges::find(files_, file, &pipeline::ReadFile::path) != files_.end();
}

void Workspace::require_writable(const std::string& file) const {
    if (!is_known(file)) {
        throw Error(quote(file) + " is not a file of this shot");
    }
    if (!is_writable(file, root_)) {
        throw Error(quote(file) + " cannot be changed, because it is not below " + quote(root_) +
                    " or belongs to carom");
    }
}

std::int64_t Workspace::next_version(std::int64_t v) {
    version_ = std::max(version_ + 1, v);
    return version_;
}

void Workspace::change_text(const std::string& file, const std::optional<std::string>& text) {
    auto texts = std::make_shared<pipeline::config::OpenTexts>(*texts_);
    if (text) {
        (*texts)[file] = *text;
    } else {
        texts->erase(file);
    }
    texts_ = std::move(texts);
}

std::int64_t Workspace::set_text(std::int64_t v, const std::string& file, const std::string& text) {
    require_writable(file);
    const DiskFile& disk = disk_[file];
    const bool is_as_on_disk = !disk.hash.empty() && text == disk.text;
    change_text(file, is_as_on_disk ? std::nullopt : std::optional(text));
    return next_version(v);
}

std::int64_t Workspace::revert(std::int64_t v, const std::string& file) {
    require_writable(file);
    change_text(file, std::nullopt);
    disk_[file] = read(file);
    return next_version(v);
}

std::variant<Saved, DiskChanged> Workspace::save(const Save& request) {
    const bool is_new = !is_known(request.file);
    const fs::path path(request.file);
    if (is_new && (!path.is_absolute() || whole_path(request.file) != request.file ||
                   !is_writable(request.file, root_) || path.extension() != ".yaml")) {
        throw Error(quote(request.file) +
                    " cannot be written: new files have to be .yaml files below " + quote(root_));
    }
    if (!is_new) {
        require_writable(request.file);
        if (whole_path(request.file) != request.file) {
            throw Error(quote(request.file) + " cannot be written: it has become a link");
        }
    }
    const DiskFile disk = read(request.file);
    if (disk.hash != request.base_hash && !request.force) {
        const DiskFile before = std::exchange(disk_[request.file], disk);
        DiskChanged answer = disk.hash.empty() ? gone(request.file, before, disk)
                                               : DiskChanged{request.file, disk.text, disk.hash};
        answer.refused = true;
        return answer;
    }
    write_file_atomically(request.file, std::as_bytes(std::span(request.text)));
    DiskFile& written = disk_[request.file] = {request.text, hash_of(request.text)};
    note_node(request.file, written);
    missing_.erase(request.file);
    const auto open = texts_->find(request.file);
    if (open != texts_->end() && open->second == request.text) {
        change_text(request.file, std::nullopt);
    }
    return Saved{request.file, written.hash};
}

bool Workspace::replace(Assets& stamps, Assets now) {
    for (auto& [path, stamp] : now) {
        if (const auto known = stamps.find(path); known != stamps.end()) {
            stamp = known->second;
        }
    }
    const bool is_other = !std::ranges::equal(now, stamps, {}, &Assets::value_type::first,
                                              &Assets::value_type::first);
    stamps = std::move(now);
    return is_other;
}

bool Workspace::set_assets(std::vector<std::string> paths) {
    Assets now;
    for (std::string& path : paths) {
        const Stamp stamp = stamp_of(path);
        now.emplace(std::move(path), stamp);
    }
    return replace(assets_, std::move(now));
}

bool Workspace::set_missing(const std::vector<std::string>& paths) {
    Assets now;
    for (const std::string& path : paths) {
        now[path] = {};  // also if it exists by now: the next look finds that
    }
    return replace(sought_, std::move(now));
}

std::vector<std::string> Workspace::watched() const {
    std::vector<std::string> paths;
    for (const pipeline::ReadFile& file : files_) {
        paths.push_back(file.path);
    }
    for (const Assets* stamps : {&assets_, &sought_}) {
        for (const auto& [path, stamp] : *stamps) {
            paths.push_back(path);
        }
    }
    return paths;
}

Workspace::Stamp Workspace::stamp_of(const std::string& path) {
    std::error_code code;
    const auto time = fs::last_write_time(path, code);
    const std::uintmax_t size = code ? 0 : fs::file_size(path, code);
    return code ? Stamp{} : Stamp{time.time_since_epoch().count(), size};
}

Workspace::DiskChanges Workspace::look_at_disk() {
    DiskChanges changes;
    for (const pipeline::ReadFile& file : files_) {
        take_from_disk(file.path, changes);
    }
    for (Assets* stamps : {&assets_, &sought_}) {
        for (auto& [path, stamp] : *stamps) {
            const Stamp now = stamp_of(path);
            changes.assets = changes.assets || now != stamp;
            stamp = now;
        }
    }
    if (changes.reloaded) {
        static_cast<void>(next_version(0));
    }
    return changes;
}

void Workspace::take_from_disk(const std::string& file, DiskChanges& changes) {
    DiskFile now = read(file);
    DiskFile& known = disk_[file];
    if (now.hash == known.hash) {
        known = std::move(now);  // which may be another file with the same text
        missing_.erase(file);
        return;
    }
    const auto open = texts_->find(file);
    if (now.hash.empty()) {
        if (missing_.insert(file).second) {
            changes.missing = true;  // an editor may be about to replace it
            return;
        }
        if (open == texts_->end()) {
            change_text(file, known.text);
        }
        changes.conflicting.push_back(gone(file, known, now));
        known = std::move(now);
        return;
    }
    missing_.erase(file);
    known = std::move(now);
    if (open == texts_->end()) {
        changes.reloaded = true;
    } else if (open->second == known.text) {
        change_text(file, std::nullopt);
        changes.reloaded = true;
    } else {
        changes.conflicting.push_back({file, known.text, known.hash});
    }
}

std::vector<RecoveredText> Workspace::unsaved() const {
    std::vector<RecoveredText> texts;
    for (const auto& [file, text] : *texts_) {
        const auto known = disk_.find(file);
        const DiskFile disk = known == disk_.end() ? DiskFile{} : known->second;
        if (text != disk.text || disk.hash.empty()) {
            texts.push_back({file, text, disk.hash, disk.hash});
        }
    }
    return texts;
}

std::vector<RecoveredText> Workspace::recoverable(std::vector<RecoveredText> texts) const {
    std::erase_if(texts, [&](RecoveredText& one) {
        const DiskFile disk = read(one.file);
        one.hash = disk.hash;
        return !is_writable(one.file, root_) || (one.text == disk.text && !disk.hash.empty());
    });
    return texts;
}

std::vector<RecoveredText> Workspace::unreachable(std::vector<RecoveredText> texts) const {
    std::erase_if(texts, [&](const RecoveredText& one) { return is_writable(one.file, root_); });
    return texts;
}

bool Workspace::recover(const std::vector<RecoveredText>& texts) {
    bool has_one = false;
    for (const RecoveredText& one : texts) {
        if (is_writable(one.file, root_)) {
            change_text(one.file, one.text);
            has_one = true;
        }
    }
    if (has_one) {
        static_cast<void>(next_version(0));
    }
    return has_one;
}

}  // namespace carom::studio
