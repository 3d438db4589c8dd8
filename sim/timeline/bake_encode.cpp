#include <algorithm>
#include <map>

#include "core/error.h"
#include "sim/timeline/bake_format.h"
#include "sim/timeline/bake_structs.h"

namespace carom::sim {

namespace {

namespace fb = carom::bake_format;
using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

fb::Hash to_format(const Hash128& hash) {
    return {hash.high, hash.low};
}

/// A list of distinct names, numbered in the order of their first use.
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

// Conversions of the fields of structs to the types of the file.
double to_format(double value, NameTable& /*names*/) {
    return value;
}
fb::Vec3 to_format(const Vec3& v, NameTable& /*names*/) {
    return {v.x, v.y, v.z};
}
fb::Quat to_format(const Quat& q, NameTable& /*names*/) {
    return {q.r, q.v.x, q.v.y, q.v.z};
}
fb::EventKind to_format(EventKind kind, NameTable& /*names*/) {
    return static_cast<fb::EventKind>(kind);
}
std::uint32_t to_format(const std::string& name, NameTable& names) {
    return names.index_of(name);
}

template <class Struct, class T, std::size_t... kIndex>
Struct struct_of(const T& value, NameTable& names, std::index_sequence<kIndex...> /*fields*/) {
    return {to_format(value.*kMember<T, Struct, kIndex>, names)...};
}

template <class Struct, class List>
std::vector<Struct> structs_of(const List& values, NameTable& names) {
    std::vector<Struct> structs;
    structs.reserve(values.size());
    for (const auto& value : values) {
        structs.push_back(struct_of<Struct>(
            value, names, std::make_index_sequence<Struct::Traits::fields_number>{}));
    }
    return structs;
}

static_assert(static_cast<int>(Subject::Kind::object) == static_cast<int>(fb::SubjectKind::MAX) &&
                  static_cast<int>(Subject::Kind::event) ==
                      static_cast<int>(fb::SubjectKind::event),
              "bake.fbs and diagnostic.h list the same subjects in the same order");
static_assert(static_cast<int>(EventKind::removed) == static_cast<int>(fb::EventKind::MAX) &&
                  static_cast<int>(EventKind::force) == static_cast<int>(fb::EventKind::force),
              "bake.fbs and event.h list the same kinds in the same order");

auto write_tracks(FlatBufferBuilder& builder, const std::vector<Track>& tracks, NameTable& names) {
    std::vector<Offset<fb::Track>> offsets;
    offsets.reserve(tracks.size());
    for (const Track& track : tracks) {
        const auto keys = structs_of<fb::Key>(track.keys(), names);
        const auto name_offset = builder.CreateString(track.name());
        const auto keys_offset = builder.CreateVectorOfStructs(keys);
        offsets.push_back(fb::CreateTrack(builder, name_offset, keys_offset));
    }
    return builder.CreateVector(offsets);
}

auto write_warnings(FlatBufferBuilder& builder, const std::vector<Diagnostic>& warnings) {
    std::vector<Offset<fb::Warning>> offsets;
    offsets.reserve(warnings.size());
    for (const auto& [subject, field, sentence, severity] : warnings) {  // none is an error
        const auto& [kind, name, index] = subject;
        const auto name_offset = builder.CreateString(name);
        const auto field_offset = builder.CreateString(field);
        const auto sentence_offset = builder.CreateString(sentence);
        offsets.push_back(fb::CreateWarning(builder, static_cast<fb::SubjectKind>(kind),
                                            name_offset, index, field_offset, sentence_offset));
    }
    return builder.CreateVector(offsets);
}

auto write_assets(FlatBufferBuilder& builder, const std::vector<Asset>& assets) {
    std::vector<Offset<fb::Asset>> offsets;
    offsets.reserve(assets.size());
    for (const auto& [path, content_hash] : assets) {
        const fb::Hash hash = to_format(content_hash);
        const auto path_offset = builder.CreateString(path);
        offsets.push_back(fb::CreateAsset(builder, path_offset, &hash));
    }
    return builder.CreateVector(offsets);
}

// An upper bound of the builder's size, which must not exceed 2 GiB.
std::size_t estimated_size(const Bake& bake) {
    std::size_t size = 4096 + bake.shot_text.size();
    for (const Track& track : bake.timeline.tracks) {
        size += 64 + track.name().size() + track.keys().size() * sizeof(fb::Key);
    }
    for (const Event& event : bake.timeline.events) {
        size += 32 + event.a.size() + event.b.size() + sizeof(fb::Event);
    }
    size += bake.timeline.energy.size() * (sizeof(fb::EnergySample) + sizeof(double));
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

Offset<flatbuffers::Vector<double>> write_work(FlatBufferBuilder& builder,
                                               const std::vector<EnergySample>& energy) {
    std::vector<double> work;
    work.reserve(energy.size());
    for (const EnergySample& sample : energy) {
        work.push_back(sample.work);
    }
    const bool is_any = std::ranges::any_of(work, [](double value) { return value != 0; });
    return is_any ? builder.CreateVector(work) : Offset<flatbuffers::Vector<double>>();
}

std::vector<std::byte> bytes_of(const FlatBufferBuilder& builder) {
    const auto* begin = reinterpret_cast<const std::byte*>(builder.GetBufferPointer());
    return {begin, begin + builder.GetSize()};
}

}  // namespace

std::vector<std::byte> encode_content(const Bake& bake) {
    const auto& [timeline, physics_hash, shot_text, assets] = bake;
    const auto& [start_time, end_time, tracks, events, energy, lasting_contacts, put_backs,
                 warnings] = timeline;
    FlatBufferBuilder builder;
    NameTable names;
    const auto event_structs = structs_of<fb::Event>(events, names);
    const auto energy_structs = structs_of<fb::EnergySample>(energy, names);
    const auto contact_structs = structs_of<fb::LastingContact>(lasting_contacts, names);
    const auto put_back_structs = structs_of<fb::PutBack>(put_backs, names);
    // In separate statements, since the evaluation order of a call's arguments is unspecified.
    const auto tracks_offset = write_tracks(builder, tracks, names);
    const auto names_offset = builder.CreateVectorOfStrings(names.names());
    const auto events_offset = builder.CreateVectorOfStructs(event_structs);
    const auto energy_offset = builder.CreateVectorOfStructs(energy_structs);
    const auto contacts_offset = builder.CreateVectorOfStructs(contact_structs);
    const auto put_backs_offset = builder.CreateVectorOfStructs(put_back_structs);
    const auto warnings_offset = write_warnings(builder, warnings);
    const auto text_offset = builder.CreateString(shot_text);
    const auto assets_offset = write_assets(builder, assets);
    const auto work_offset = write_work(builder, energy);
    const fb::Hash hash = to_format(physics_hash);
    builder.Finish(fb::CreateContent(builder, &hash, start_time, end_time, tracks_offset,
                                     names_offset, events_offset, energy_offset, contacts_offset,
                                     put_backs_offset, warnings_offset, text_offset, assets_offset,
                                     work_offset));
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
