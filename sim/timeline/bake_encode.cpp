#include <algorithm>
#include <map>

#include "bake_generated.h"
#include "core/error.h"
#include "sim/timeline/bake_format.h"

namespace carom::sim {

namespace {

namespace fb = carom::bake_format;
using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

fb::Hash to_format(const Hash128& hash) {
    return {hash.high, hash.low};
}
fb::Vec3 to_format(const Vec3& v) {
    return {v.x, v.y, v.z};
}
fb::Quat to_format(const Quat& q) {
    return {q.r, q.v.x, q.v.y, q.v.z};
}

fb::Key to_format(const Key& key) {
    return {key.time,
            to_format(key.position),
            to_format(key.orientation),
            to_format(key.velocity_in),
            to_format(key.angular_velocity_in),
            to_format(key.velocity_out),
            to_format(key.angular_velocity_out)};
}

/// Each name once, numbered in the order of its first use.
class NameTable {
  public:
    std::uint32_t index_of(const std::string& name) {
        const auto [place, is_new] =
            indices_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
        if (is_new) {
            names_.push_back(name);
        }
        return place->second;
    }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  private:
    std::map<std::string, std::uint32_t> indices_;
    std::vector<std::string> names_;
};

fb::Event to_format(const Event& event, NameTable& names) {
    const std::uint32_t a = names.index_of(event.a);
    const std::uint32_t b = names.index_of(event.b);
    return {static_cast<fb::EventKind>(event.kind),
            a,
            b,
            event.time,
            event.end_time,
            to_format(event.place),
            to_format(event.normal),
            event.normal_impulse,
            event.tangential_impulse,
            to_format(event.vector)};
}

fb::LastingContact to_format(const LastingContact& contact, NameTable& names) {
    const std::uint32_t a = names.index_of(contact.a);
    const std::uint32_t b = names.index_of(contact.b);
    return {a, b, contact.from, contact.to, contact.normal_force, contact.slip};
}

fb::PutBack to_format(const PutBack& put_back, NameTable& names) {
    return {names.index_of(put_back.ball), put_back.time, to_format(put_back.from),
            to_format(put_back.to)};
}

/// The structs of a list whose elements refer to names.
template <class Struct, class Value>
std::vector<Struct> structs_of(const std::vector<Value>& values, NameTable& names) {
    std::vector<Struct> structs;
    structs.reserve(values.size());
    for (const Value& value : values) {
        structs.push_back(to_format(value, names));
    }
    return structs;
}

static_assert(static_cast<int>(Subject::Kind::object) == static_cast<int>(fb::SubjectKind::MAX) &&
                  static_cast<int>(Subject::Kind::event) ==
                      static_cast<int>(fb::SubjectKind::event),
              "bake.fbs and diagnostic.h list the same subjects in the same order");
static_assert(static_cast<int>(EventKind::strike) == static_cast<int>(fb::EventKind::MAX) &&
                  static_cast<int>(EventKind::force) == static_cast<int>(fb::EventKind::force),
              "bake.fbs and event.h list the same kinds in the same order");

Offset<fb::Track> write_track(FlatBufferBuilder& builder, const Track& track) {
    std::vector<fb::Key> keys;
    keys.reserve(track.keys().size());
    for (const Key& key : track.keys()) {
        keys.push_back(to_format(key));
    }
    const auto name_offset = builder.CreateString(track.name());
    const auto keys_offset = builder.CreateVectorOfStructs(keys);
    return fb::CreateTrack(builder, name_offset, keys_offset);
}

auto write_tracks(FlatBufferBuilder& builder, const std::vector<Track>& tracks) {
    std::vector<Offset<fb::Track>> offsets;
    offsets.reserve(tracks.size());
    for (const Track& track : tracks) {
        offsets.push_back(write_track(builder, track));
    }
    return builder.CreateVector(offsets);
}

auto write_energy(FlatBufferBuilder& builder, const std::vector<EnergySample>& energy) {
    std::vector<fb::EnergySample> samples;
    samples.reserve(energy.size());
    for (const EnergySample& sample : energy) {
        samples.emplace_back(sample.time, sample.kinetic, sample.potential);
    }
    return builder.CreateVectorOfStructs(samples);
}

auto write_warnings(FlatBufferBuilder& builder, const std::vector<Diagnostic>& warnings) {
    std::vector<Offset<fb::Warning>> offsets;
    offsets.reserve(warnings.size());
    for (const Diagnostic& warning : warnings) {
        const auto name = builder.CreateString(warning.subject.name);
        const auto field = builder.CreateString(warning.field);
        const auto sentence = builder.CreateString(warning.sentence);
        offsets.push_back(fb::CreateWarning(builder,
                                            static_cast<fb::SubjectKind>(warning.subject.kind),
                                            name, warning.subject.index, field, sentence));
    }
    return builder.CreateVector(offsets);
}

auto write_assets(FlatBufferBuilder& builder, const std::vector<Asset>& assets) {
    std::vector<Offset<fb::Asset>> offsets;
    offsets.reserve(assets.size());
    for (const Asset& asset : assets) {
        const fb::Hash hash = to_format(asset.content_hash);
        const auto path = builder.CreateString(asset.path);
        offsets.push_back(fb::CreateAsset(builder, path, &hash));
    }
    return builder.CreateVector(offsets);
}

// Not less than what the builder will need, which must not pass 2 GiB.
std::size_t estimated_size(const Bake& bake) {
    std::size_t size = 4096 + bake.shot_text.size();
    for (const Track& track : bake.timeline.tracks) {
        size += 64 + track.name().size() + track.keys().size() * sizeof(fb::Key);
    }
    for (const Event& event : bake.timeline.events) {
        size += 32 + event.a.size() + event.b.size() + sizeof(fb::Event);
    }
    size += bake.timeline.energy.size() * sizeof(fb::EnergySample);
    for (const LastingContact& contact : bake.timeline.lasting_contacts) {
        size += 32 + contact.a.size() + contact.b.size() + sizeof(fb::LastingContact);
    }
    for (const PutBack& put_back : bake.timeline.put_backs) {
        size += 16 + put_back.ball.size() + sizeof(fb::PutBack);
    }
    for (const Diagnostic& warning : bake.timeline.warnings) {
        size += 96 + warning.subject.name.size() + warning.field.size() + warning.sentence.size();
    }
    for (const Asset& asset : bake.assets) {
        size += 64 + asset.path.size();
    }
    return size;
}

std::vector<std::byte> bytes_of(const FlatBufferBuilder& builder) {
    const auto* begin = reinterpret_cast<const std::byte*>(builder.GetBufferPointer());
    return {begin, begin + builder.GetSize()};
}

}  // namespace

std::vector<std::byte> encode_content(const Bake& bake) {
    const Timeline& timeline = bake.timeline;
    FlatBufferBuilder builder;
    NameTable names;
    const auto events = structs_of<fb::Event>(timeline.events, names);
    const auto contacts = structs_of<fb::LastingContact>(timeline.lasting_contacts, names);
    const auto put_backs = structs_of<fb::PutBack>(timeline.put_backs, names);
    // One after another: the order of a call's arguments is the compiler's to choose.
    const auto tracks_offset = write_tracks(builder, timeline.tracks);
    const auto names_offset = builder.CreateVectorOfStrings(names.names());
    const auto events_offset = builder.CreateVectorOfStructs(events);
    const auto energy_offset = write_energy(builder, timeline.energy);
    const auto contacts_offset = builder.CreateVectorOfStructs(contacts);
    const auto put_backs_offset = builder.CreateVectorOfStructs(put_backs);
    const auto warnings_offset = write_warnings(builder, timeline.warnings);
    const auto text_offset = builder.CreateString(bake.shot_text);
    const auto assets_offset = write_assets(builder, bake.assets);
    const fb::Hash physics_hash = to_format(bake.physics_hash);
    builder.Finish(fb::CreateContent(builder, &physics_hash, timeline.start_time, timeline.end_time,
                                     tracks_offset, names_offset, events_offset, energy_offset,
                                     contacts_offset, put_backs_offset, warnings_offset,
                                     text_offset, assets_offset));
    return bytes_of(builder);
}

std::vector<std::byte> encode_envelope(std::span<const std::byte> content) {
    FlatBufferBuilder builder(content.size() + 256);
    builder.ForceVectorAlignment(content.size(), 1, sizeof(double));
    const auto offset =
        builder.CreateVector(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
    const fb::Head head(kSchemaVersion, 0, 0, to_format(hash_bytes(content)));
    builder.Finish(fb::CreateEnvelope(builder, &head, offset), fb::EnvelopeIdentifier());
    auto* envelope = flatbuffers::GetMutableRoot<fb::Envelope>(builder.GetBufferPointer());
    envelope->mutable_head()->mutate_file_size(builder.GetSize());
    return bytes_of(builder);
}

std::vector<std::byte> encode_bake(const Bake& bake) {
    if (const auto problem = find_problem(bake)) {
        throw Error("the bake cannot be written: " + *problem);
    }
    if (estimated_size(bake) > kLargestContent) {
        throw Error("the bake cannot be written: it is larger than 1 GiB");
    }
    return encode_envelope(encode_content(bake));
}

}  // namespace carom::sim
