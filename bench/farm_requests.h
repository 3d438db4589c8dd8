// What the actions of a simulated farm's worker ask of its store.
#pragma once

#include <array>
#include <cstddef>
#include <numeric>

namespace carom::bench {

enum class StoreKind {
    files,    // a network file system, as carom uses it
    objects,  // an object store with conditional writes, as docs/farm.md plans it
};

/// Requests of an object store. Those of a file system are all counted as `get`.
enum class Verb { list, head, get, put };
inline constexpr std::size_t kVerbs = 4;

/// Requests, one after another, and then bytes.
struct Demand {
    std::array<double, kVerbs> requests{};
    double bytes = 0;

    [[nodiscard]] static Demand of(Verb verb, double count) {
        Demand demand;
        demand.requests[static_cast<std::size_t>(verb)] = count;
        return demand;
    }
    [[nodiscard]] double writes() const { return requests[static_cast<std::size_t>(Verb::put)]; }
    [[nodiscard]] double reads() const {
        return std::accumulate(requests.begin(), requests.end(), 0.0) - writes();
    }

    Demand& operator+=(const Demand& other) {
        for (std::size_t verb = 0; verb < kVerbs; ++verb) {
            requests[verb] += other.requests[verb];
        }
        bytes += other.bytes;
        return *this;
    }
    friend Demand operator+(Demand a, const Demand& b) { return a += b; }
    friend Demand operator*(double times, Demand demand) {
        for (double& count : demand.requests) {
            count *= times;
        }
        demand.bytes *= times;
        return demand;
    }
};

struct ActionCosts {
    Demand look;           // whether a frame is there
    Demand read_claim;     // to see its counter
    Demand claim;          // an open frame
    Demand beat;           // counts up a claim's counter
    Demand note;           // of a worker about itself
    Demand read_leftover;  // of a claim that is there when a task starts
    Demand publish;        // a frame, and that its claim is finished, without the frame's bytes
    /// A request more for each so many of the frame's bytes; 0: none.
    double bytes_per_request = 0;
    Demand list_page;  // a part of the list of frames and of that of claims
    double names_per_page = 0;
};

/// Files: requests that an NFS client sends, counted from the calls of pipeline/store and
/// pipeline/farm. To open a file is one more than its reads and writes; a commit is what fsync()
/// and the closing of a written file send. Objects: what the plan in docs/farm.md needs.
[[nodiscard]] const ActionCosts& costs_of(StoreKind kind);

}  // namespace carom::bench
