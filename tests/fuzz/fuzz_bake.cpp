// Fuzzes the bake reader. Any bytes must give a bake or an Error. An accepted bake can be written,
// read back unchanged, and sampled at any time with finite values.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "core/error.h"
#include "core/finite.h"
#include "sim/timeline/bake_format.h"

namespace {

using namespace carom;
using namespace carom::sim;

void require(bool condition, const char* what) {
    if (condition) {
        return;
    }
    std::fprintf(stderr, "an accepted bake: %s\n", what);
    std::abort();
}

void sample(const Track& track, double time) {
    const MotionState state = track.sample(time);
    require(is_finite(state.position) && is_finite(state.velocity), "position and velocity");
    require(is_finite(state.angular_velocity), "angular velocity");
    require(std::abs(state.orientation.length() - 1) < 1e-5, "orientation");
}

/// Whether segments follow each other: a jump is between two neighbouring numbers.
bool is_next(double end, double start) {
    return start == end || start == time_after_jump(end);
}

void use(const Bake& bake) {
    require(decode_bake(encode_bake(bake), "again") == bake, "reads back differently");
    for (const Track& track : bake.timeline.tracks) {
        const double first = track.keys().front().time;
        const double last = track.keys().back().time;
        for (const double fraction : {-0.1, 0.0, 0.137, 0.5, 0.863, 1.0, 1.1}) {
            sample(track, first + fraction * (last - first));
        }
        const double middle = first + 0.6 * (last - first);
        double time = first;
        for (const PathSegment& segment : track.segments(first, middle)) {
            require(is_next(time, segment.start) && is_finite(segment.p1), "segments");
            time = segment.end;
        }
        require(is_next(time, middle), "segments' end");
        const Bounds bounds = track.position_bounds(first, middle);
        require(is_finite(bounds.low) && is_finite(bounds.high), "bounds");
    }
}

void read(std::span<const std::byte> bytes) {
    try {
        use(decode_bake(bytes, "input"));
    } catch (const Error&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
    // Reads the bytes as a file, and as the content of a file with a correct hash, since the reader
    // rejects all others early.
    read(bytes);
    read(encode_envelope(bytes));
    return 0;
}
