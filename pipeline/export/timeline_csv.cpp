#include "pipeline/export/timeline_csv.h"

#include "pipeline/export/csv_text.h"
#include "pipeline/export/sample_times.h"

namespace carom::pipeline {

namespace {

constexpr const char* kStateColumns = "object,time,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";
constexpr const char* kEventColumns =
    "time,kind,a,b,x,y,z,nx,ny,nz,normal_impulse,tangential_impulse,vector_x,vector_y,vector_z";
constexpr const char* kContactColumns = "from,to,a,b,normal_force,slip";

void add_row(CsvText& csv, const std::string& object, double time, const MotionState& state) {
    csv.add(object).add(time).add(state.position).add(state.orientation);
    csv.add(state.velocity).add(state.angular_velocity).end_row();
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
    const std::vector<double> times = sample_times(timeline, rate);
    CsvText csv(kStateColumns);
    for (const sim::Track& track : timeline.tracks) {
        for (const double time : times) {
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
        csv.add(event.normal_impulse).add(event.tangential_impulse).add(event.vector).end_row();
    }
    return csv.finish();
}

std::string contacts_to_csv(const sim::Timeline& timeline) {
    CsvText csv(kContactColumns);
    for (const sim::LastingContact& contact : timeline.lasting_contacts) {
        csv.add(contact.from).add(contact.to).add(contact.a).add(contact.b);
        csv.add(contact.normal_force).add(contact.slip).end_row();
    }
    return csv.finish();
}

}  // namespace carom::pipeline
