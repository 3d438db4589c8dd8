// A farm of workers that share the frames of a film through files of a common store, simulated
// event by event. docs/farm.md shows what it says about farms of 10 to 10,000 workers.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/farm_requests.h"
#include "bench/farm_store.h"

namespace carom::bench {

/// How a worker finds frames that nobody has claimed.
enum class Search {
    walk,  // looks at every frame of the film in turn, its own share first; when it waits, at every
           // claim that is left; before all this it reads the claims once, to find leftovers
    list,  // reads the list of claims and frames; when it waits, also a few claims of its choice
};

struct FarmSettings {
    StoreKind kind = StoreKind::files;
    int workers = 10;
    double budget = 600;             // s after which a task starts no frame
    double time_limit = 0;           // s after which a task is stopped and hands over; 0 = never
    double next_task_delay = 5;      // s from the end of a task to the start of the next
    double requeue_delay = 120;      // s from the loss of a node to the start of its task elsewhere
    double starts_per_second = 500;  // how quickly the scheduler starts tasks
    double load_seconds = 1;         // what a task does before it looks for a frame
    double load_requests = 100;      // files that it reads for that: program, shot, bake, pictures
    double load_bytes = 8e6;         // their size
    double lost_nodes_per_hour = 0;  // share of the nodes
    double slow_nodes = 0;           // share of the nodes
    double slow_factor = 20;         // how much longer a slow node renders
    double heartbeat = 5;            // s
    double note_seconds = 1;         // between two notes of a worker about itself; 0 = never
    double expiry = 30;              // s without a heartbeat after which a claim is dead
    double poll = 1;                 // s between two looks of a worker that waits
    double longest_poll = 1;         // each wait is twice the one before, up to this, s
    double backup_after = 0;         // a waiting worker renders a frame, too, that nobody began
                                     // for this many times the median frame time; 0 = never
    int watched_claims = 4;          // claims that a waiting worker reads with Search::list
    Search search = Search::walk;
    double frame_bytes = 5.4e6;
    double give_up_after = 12 * 3600;  // s
    std::uint64_t seed = 1;
    StoreSettings store;
};

struct FarmResult {
    double finished = 0;          // s after the submission when the last frame is stored
    double last_first_claim = 0;  // s when the last frame is claimed for the first time
    double tasks = 0;             // started
    double worker_seconds = 0;    // time of all tasks
    double wait_seconds = 0;      // of all tasks: for answers without which they cannot go on
    double lists = 0;             // requests of an object store
    double heads = 0;
    double gets = 0;  // or all requests of a file system
    double puts = 0;
    double peak_reads = 0;  // in the busiest second; all requests of a file system
    double peak_writes = 0;
    double peak_bytes = 0;
    double peak_claims = 0;
    double slowest_request = 0;  // s
    double unfinished = 0;       // frames when the run was given up
    double vain_claims = 0;      // that others had made a moment before
    double frames_again = 0;     // renderings of a frame beyond the first, also unfinished ones
    double lost_tasks = 0;
};

/// Renders a film whose frames take `frame_seconds` on a node that is not slow.
[[nodiscard]] FarmResult simulate_farm(const FarmSettings& settings,
                                       const std::vector<double>& frame_seconds);

}  // namespace carom::bench
