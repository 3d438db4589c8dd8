#include "bench/farm_requests.h"

namespace carom::bench {
namespace {

Demand files(double count) {
    return Demand::of(Verb::get, count);
}

ActionCosts costs_of_files() {
    return {
        .look = files(1),
        // open and read the claim; open the one of the next number, which does not exist
        .read_claim = files(3),
        // open the claim, which does not exist; create, lock, write and commit a draft; link and
        // remove it; open and read the claim
        .claim = files(9),
        // write, commit
        .beat = files(2),
        // look for the old one; create, write, commit, rename; open the folder; and look whether
        // there are wishes
        .note = files(7),
        // open and read
        .read_leftover = files(2),
        // create and lock; open, write and commit the checksum; rename, unlock; write, commit,
        // unlock and remove the claim; open, write and commit the diary of frames; and the frame's
        // writes and commit, of up to 1 MiB each, which is the most that Linux' NFS client sends at
        // once
        .publish = files(15),
        .bytes_per_request = 1 << 20U,
        .list_page = files(1),
        .names_per_page = 200,  // a guess: names in one answer to the question for a list
    };
}

// One object for each frame, and one for each claim, whose content is the counter and the worker's
// note. Claims are made with If-None-Match, renewed and taken over with If-Match, so that they have
// no drafts and no numbers, and nobody has to read them again.
ActionCosts costs_of_objects() {
    const Demand put = Demand::of(Verb::put, 1);
    return {
        .look = Demand::of(Verb::head, 1),
        .read_claim = Demand::of(Verb::get, 1),
        .claim = put,
        .beat = put,
        .note = put,
        .read_leftover = {},  // there are no locks, and so no leftovers
        .publish = 2 * put,   // the frame, and that its claim is finished
        .list_page = Demand::of(Verb::list, 1),
        .names_per_page = 1000,  // the most that ListObjectsV2 of S3 returns
    };
}

}  // namespace

const ActionCosts& costs_of(StoreKind kind) {
    static const ActionCosts of_files = costs_of_files();
    static const ActionCosts of_objects = costs_of_objects();
    return kind == StoreKind::files ? of_files : of_objects;
}

}  // namespace carom::bench
