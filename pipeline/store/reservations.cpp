#include "pipeline/store/reservations.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <system_error>
#include <thread>

#include <fmt/core.h>
#include <unistd.h>

#include "core/error.h"
#include "core/text.h"
#include "pipeline/store/cache_entry.h"
#include "pipeline/store/cache_maintenance.h"
#include "pipeline/store/claims.h"
#include "pipeline/store/pins.h"
#include "pipeline/store/wait_notice.h"

namespace carom::pipeline {
namespace {

constexpr std::chrono::milliseconds kPollInterval{50};
constexpr std::size_t kMostNamed = 3;

bool exists(const std::string& path) {
    return ::access(path.c_str(), F_OK) == 0;
}

Reservation reservation_of(const std::string& cache_folder, const LivePin& pin,
                           std::set<Hash128>& counted) {
    Reservation reservation{pin.name, pin.text.owner, 0, 0};
    if (pin.text.bytes_each == 0) {
        return reservation;
    }
    for (const Hash128& key : pin.text.keys) {
        if (!counted.contains(key) && !exists(frame_file(cache_folder, key)) &&
            !exists(bake_file(cache_folder, key))) {
            counted.insert(key);
            ++reservation.files;
            reservation.bytes += pin.text.bytes_each;
        }
    }
    return reservation;
}

/// "farm job a-1 (200 MB) and process 3 on n7 (100 MB)", the largest first.
std::string names_of(std::vector<Reservation> others) {
    std::ranges::sort(others, std::ranges::greater(), &Reservation::bytes);
    std::vector<std::string> names;
    std::uint64_t rest = 0;
    for (const Reservation& other : others) {
        if (names.size() < kMostNamed) {
            names.push_back(fmt::format("{} ({})", other.owner, size_text(other.bytes)));
        } else {
            rest += other.bytes;
        }
    }
    if (rest > 0) {
        names.push_back(fmt::format("{} more ({})", others.size() - kMostNamed, size_text(rest)));
    }
    return enumerate(names, "and");
}

void require_room(const RoomRequest& request) {
    const std::optional<std::uint64_t> available =
        request.free ? request.free : free_bytes(request.cache_folder);
    std::vector<Reservation> others = list_reservations(request.cache_folder, request.pin);
    Reservation own;
    std::uint64_t reserved = 0;
    std::erase_if(others, [&](const Reservation& each) {
        if (each.pin == request.pin) {
            own = each;
        }
        return each.pin == request.pin;
    });
    for (const Reservation& other : others) {
        reserved += other.bytes;
    }
    if (!available || own.bytes == 0) {
        return;
    }
    const double room = static_cast<double>(*available) + static_cast<double>(request.removable) -
                        static_cast<double>(reserved);
    if (room >= request.least_part * static_cast<double>(own.bytes)) {
        return;
    }
    std::string text = fmt::format(
        "the cache '{}' has too little space: {} of this job need about {}, and {} are left",
        request.cache_folder, counted(own.files, "missing file"), size_text(own.bytes),
        size_text(*available));
    if (request.removable > 0) {
        text += "; " + size_text(request.removable) + " of the cache can be removed";
    }
    if (!others.empty()) {
        text += "; " + size_text(reserved) + " are reserved by " + names_of(others);
    }
    throw NoRoom(text);
}

/// Waits while another process asks for room.
Claim take_turn(Claims& claims, const RoomRequest& request, const std::stop_token& stop) {
    constexpr const char* kName = "room";
    WaitNotice wait;
    while (!stop.stop_requested()) {
        try {
            if (std::optional<Claim> turn = claims.claim(kName)) {
                return std::move(*turn);
            }
            const std::optional<std::string> waited = wait.due();
            if (waited && request.on_wait) {
                request.on_wait(fmt::format("waiting for {} to reserve room in the cache '{}': {}",
                                            *waited, request.cache_folder, claims.holder(kName)));
            }
        } catch (const Error& error) {
            throw CacheUnusable(error.what());
        }
        std::this_thread::sleep_for(kPollInterval);
    }
    throw Stopped();
}

}  // namespace

std::vector<Reservation> list_reservations(const std::string& cache_folder,
                                           const std::string& first) {
    std::vector<LivePin> pins = live_pins(cache_folder);
    std::stable_partition(pins.begin(), pins.end(),
                          [&](const LivePin& pin) { return pin.name == first; });
    std::set<Hash128> counted;
    std::vector<Reservation> reservations;
    for (const LivePin& pin : pins) {
        if (pin.is_fresh) {
            Reservation reservation = reservation_of(cache_folder, pin, counted);
            if (reservation.bytes > 0) {
                reservations.push_back(std::move(reservation));
            }
        }
    }
    std::ranges::sort(reservations, {}, &Reservation::pin);
    return reservations;
}

std::optional<std::uint64_t> free_bytes(const std::string& folder) {
    std::error_code failure;
    const std::filesystem::space_info space = std::filesystem::space(folder, failure);
    return failure ? std::nullopt : std::optional<std::uint64_t>(space.available);
}

void reserve_room(const RoomRequest& request, const std::function<void()>& write_pin,
                  const std::stop_token& stop) {
    Claims claims(request.cache_folder + "/locks");
    const Claim turn = take_turn(claims, request, stop);
    // Own changes of the folder also make a network file system look at it anew.
    write_pin();
    require_room(request);
}

}  // namespace carom::pipeline
