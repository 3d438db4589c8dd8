#include "pipeline/export/timeline_csv.h"

#include <cmath>
#include <cstdint>

#include "pipeline/export/csv_text.h"
#include "sim/timeline/error.h"

namespace carom::pipeline {

namespace {

constexpr const char* kStateColumns = "object,time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";
constexpr const char* kEventColumns =
    "time,kind,a,b,x,y,z,nx,ny,nz,normal_impulse,tangential_impulse";

constexpr double kHighestRate = 1e6;  // Hz
constexpr double kMostRows = 1e7;     // about 2 GB of text

void add_row(CsvText& csv, const std::string& object, double time, const MotionState& state) {
    csv.add(object).add(time).add(state.position).add(state.orientation);
    csv.add(state.velocity).add(state.angular_velocity).end_row();
}

/// How many times start + n / rate lie in [start, end], the end included despite rounding.
double sample_count(const sim::Timeline& timeline, double rate) {
    constexpr double kShareOfAStep = 1e-9;
    const double steps = (timeline.end_time - timeline.start_time) * rate;
    return std::floor(steps + kShareOfAStep) + 1;
}

}  // namespace

std::string keys_to_csv(const sim::Timeline& timeline) {
    CsvText csv(kStateColumns);
    for (const sim::Track& track : timeline.tracks) {
        for (const sim::Key& key : track.keys()) {
            add_row(csv, track.name(), key.time,
                    {key.position, key.orientation, key.velocity_in, key.angular_velocity_in});
            if (key.is_break()) {
                add_row(
                    csv, track.name(), key.time,
                    {key.position, key.orientation, key.velocity_out, key.angular_velocity_out});
            }
        }
    }
    return csv.finish();
}

std::string samples_to_csv(const sim::Timeline& timeline, double rate) {
    if (!(rate > 0 && rate <= kHighestRate)) {
        throw Error("the rate of an export must be above 0 and at most 1e6 samples/s");
    }
    const double samples = sample_count(timeline, rate);
    if (samples * static_cast<double>(timeline.tracks.size()) > kMostRows) {
        throw Error("the table would have more than ten million rows; take a lower rate");
    }
    const auto count = static_cast<std::int64_t>(samples);
    CsvText csv(kStateColumns);
    for (const sim::Track& track : timeline.tracks) {
        for (std::int64_t n = 0; n < count; ++n) {
            const double time = timeline.start_time + static_cast<double>(n) / rate;
            add_row(csv, track.name(), time, track.sample(time));
        }
    }
    return csv.finish();
}

std::string events_to_csv(const sim::Timeline& timeline) {
    CsvText csv(kEventColumns);
    for (const sim::Event& event : timeline.events) {
        csv.add(event.time).add(sim::to_string(event.kind)).add(event.a).add(event.b);
        csv.add(event.place).add(event.normal);
        csv.add(event.normal_impulse).add(event.tangential_impulse).end_row();
    }
    return csv.finish();
}

}  // namespace carom::pipeline
