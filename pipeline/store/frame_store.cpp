#include "pipeline/store/frame_store.h"

#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/assert.h"
#include "core/error.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/frame_checksum.h"
#include "render/film/packed_film.h"

namespace carom::pipeline {
namespace {

std::uint64_t size_of_file(const std::string& path) {
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    return file.is_open() && ::fstat(file.get(), &status) == 0
               ? static_cast<std::uint64_t>(status.st_size)
               : 0;
}

std::string undecodable(const Error& error) {
    return std::string("it cannot be decoded: ") + error.what();
}

}  // namespace

FrameStore::FrameStore(std::string folder, DamageObserver on_damage, ClaimTimes times,
                       StoreAccess access)
    : folder_(std::move(folder)),
      access_(access),
      on_damage_(std::move(on_damage)),
      claims_(std::make_unique<Claims>(folder_ + "/locks", times)) {
    if (access_ == StoreAccess::only_read) {
        return;
    }
    try {
        create_folder(folder_);
    } catch (const Error& error) {
        throw CacheUnusable(error.what());
    }
    remove_leftovers(folder_, times);
}

std::string FrameStore::path_of(const Hash128& key) const {
    return file_of(key, ".exr");
}

std::string FrameStore::file_of(const Hash128& key, const char* extension) const {
    return file_about(key, folder_, extension);
}

bool FrameStore::contains(const Hash128& key) const {
    return ::access(path_of(key).c_str(), R_OK) == 0;
}

std::uint64_t FrameStore::size_bytes(const Hash128& key) const {
    return size_of_file(path_of(key));
}

std::uint64_t FrameStore::noisy_size_bytes(const Hash128& key) const {
    return size_of_file(file_of(key, kNoisyExtension));
}

CheckedContents FrameStore::checked(const std::string& path, const Hash128& key) const {
    try {
        return read_checked(path, key);
    } catch (const Error&) {
        if (access_ != StoreAccess::only_read) {
            throw;
        }
        return {FrameFileState::missing};
    }
}

bool FrameStore::is_intact(const Hash128& key) const {
    return checked(path_of(key), key).state == FrameFileState::intact;
}

void FrameStore::remove_if_damaged(const Hash128& key) const {
    const std::string path = path_of(key);
    if (checked(path, key).state == FrameFileState::damaged) {
        discard(path, describe_damage(path, key));
    }
}

void FrameStore::discard(const std::string& path, const std::string& damage) const {
    if (on_damage_) {
        on_damage_(path, damage);
    }
    if (access_ != StoreAccess::only_read) {
        ::unlink(path.c_str());
    }
}

void FrameStore::mark_used(const Hash128& key) const {
    if (access_ != StoreAccess::only_read) {
        pipeline::mark_used(path_of(key));
    }
}

template <class Decode>
std::optional<render::Film> FrameStore::decoded(const std::string& path, const Hash128& key,
                                                FrameFileState state, const Decode& decode) const {
    switch (state) {
        case FrameFileState::missing:
        case FrameFileState::unreadable:
            return std::nullopt;
        case FrameFileState::damaged:
            discard(path, describe_damage(path, key));
            return std::nullopt;
        case FrameFileState::intact:
            break;
    }
    try {
        return decode();
    } catch (const Error& error) {
        discard(path, undecodable(error));
        return std::nullopt;
    }
}

std::optional<render::Film> FrameStore::read(const Hash128& key) const {
    const std::string path = path_of(key);
    return decoded(path, key, checked(path, key).state, [&] { return render::read_exr(path); });
}

std::optional<render::Film> FrameStore::read_noisy(const Hash128& key) const {
    const std::string path = file_of(key, kNoisyExtension);
    const CheckedContents contents = checked(path, key);
    return decoded(path, key, contents.state, [&] { return render::unpack_film(contents.bytes); });
}

void FrameStore::write(const Hash128& key, const render::Film& film,
                       const render::ImageMetadata& metadata) const {
    CAROM_ASSERT(access_ != StoreAccess::only_read);
    PartialFile partial = begin_file(key);
    render::write_exr(film, partial.path(), metadata);
    append_checksum(partial.path(), key);
    partial.rename_to(path_of(key));
}

void FrameStore::write_noisy(const Hash128& key, const render::Film& film) const {
    CAROM_ASSERT(access_ != StoreAccess::only_read);
    PartialFile partial = begin_file(key);
    write_with_checksum(partial.path(), render::pack_film(film, partial.path()), key);
    partial.rename_to(file_of(key, kNoisyExtension));
}

PartialFile FrameStore::begin_file(const Hash128& key) const {
    return PartialFile(folder_ + "/partial", key.to_string());
}

std::optional<Claim> FrameStore::claim(const Hash128& key) const {
    CAROM_ASSERT(access_ != StoreAccess::only_read);
    try {
        return claims_->claim(key.to_string());
    } catch (const Error& error) {
        throw CacheUnusable(error.what());
    }
}

}  // namespace carom::pipeline
