#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"
#include "sim/timeline/bake_format.h"
#include "sim/timeline/bake_structs.h"
#include "sim/timeline/rotation_segment.h"

namespace carom::sim {

namespace {

namespace fb = carom::bake_format;

constexpr flatbuffers::uoffset_t kDeepest = 4;  // Content, Track, Warning or Asset, their strings
constexpr flatbuffers::uoffset_t kMaxTables = kMaxTracks + kMaxAssets + kMaxWarnings + 1;

Hash128 from_format(const fb::Hash& hash) {
    return {hash.high(), hash.low()};
}

/// In a valid file no two parts share bytes. In a forged file many tracks might share one list of
/// keys, which would take a thousand times the memory when read.
class ByteBudget {
  public:
    explicit ByteBudget(std::size_t bytes) : left_(bytes) {}

    void spend(std::size_t count, std::size_t size) {
        if (count > left_ / size) {
            throw Error("its parts overlap");
        }
        left_ -= count * size;
    }
    /// A list of structs. FlatBuffers' verifier does not check the alignment of their doubles.
    template <class T>
    const flatbuffers::Vector<const T*>& list(const flatbuffers::Vector<const T*>& vector) {
        spend(vector.size(), sizeof(T));
        if (vector.size() > 0 &&
            reinterpret_cast<std::uintptr_t>(vector.Data()) % alignof(T) != 0) {
            throw Error("a list is not aligned to eight bytes");
        }
        return vector;
    }
    std::string text(const flatbuffers::String& string) {
        spend(string.size(), 1);
        return string.str();
    }

  private:
    std::size_t left_;
};

/// The names that structs refer to by index.
class Names {
  public:
    Names(const fb::Content& content, ByteBudget& budget) {
        for (const flatbuffers::String* name : *content.names()) {
            names_.push_back(budget.text(*name));
            if (names_.back().size() > kLongestName) {
                throw Error(fmt::format("a name is longer than {} bytes", kLongestName));
            }
        }
    }
    [[nodiscard]] const std::string& at(std::uint32_t index, const char* user) const {
        if (index >= names_.size()) {
            throw Error(user + std::string(" refers to a name that does not exist"));
        }
        return names_[index];
    }

  private:
    std::vector<std::string> names_;
};

/// Reads the fields of one kind of struct.
class FieldReader {
  public:
    /// `user`: the element that refers to names, for messages: "an event".
    FieldReader(const Names& names, const char* user) : names_(names), user_(user) {}

    void read(double stored, double& value) const { value = stored; }
    void read(const fb::Vec3& v, Vec3& value) const { value = {v.x(), v.y(), v.z()}; }
    void read(const fb::Quat& q, Quat& value) const { value = {q.w(), q.x(), q.y(), q.z()}; }
    void read(std::uint32_t index, std::string& name) const { name = names_.at(index, user_); }
    void read(fb::EventKind stored, EventKind& kind) const {
        if (stored > fb::EventKind::MAX) {
            throw Error("an event is of an unknown kind");
        }
        kind = static_cast<EventKind>(stored);
    }

  private:
    const Names& names_;
    const char* user_;
};

template <class Value, class Struct, std::size_t... kIndex>
Value value_of(const Struct& stored, const FieldReader& reader,
               std::index_sequence<kIndex...> /*fields*/) {
    Value value;
    (reader.read(stored.template get_field<kIndex>(), value.*kMember<Value, Struct, kIndex>), ...);
    return value;
}

template <class Value, class Struct>
std::vector<Value> read_list(const flatbuffers::Vector<const Struct*>& list,
                             const FieldReader& reader, ByteBudget& budget) {
    std::vector<Value> values;
    values.reserve(budget.list(list).size());
    for (const Struct* element : list) {
        values.push_back(value_of<Value>(
            *element, reader, std::make_index_sequence<Struct::Traits::fields_number>{}));
    }
    return values;
}

std::vector<Track> read_tracks(const fb::Content& content, const Names& names, ByteBudget& budget) {
    std::vector<Track> tracks;
    std::uint64_t substeps_in_all = 0;
    for (const fb::Track* track : *content.tracks()) {
        std::vector<Key> keys = read_list<Key>(*track->keys(), FieldReader(names, "a key"), budget);
        substeps_in_all += rotation_substeps(keys);
        if (substeps_in_all > kMaxSubsteps) {
            throw Error("its objects turn more than 1e6 rad about changing axes");
        }
        std::string name = budget.text(*track->name());
        if (name.size() > kLongestName) {
            throw Error(fmt::format("the name of a track is longer than {} bytes", kLongestName));
        }
        tracks.emplace_back(std::move(name), std::move(keys));
    }
    return tracks;
}

std::vector<EnergySample> read_energy(const fb::Content& content, const FieldReader& reader,
                                      ByteBudget& budget) {
    auto samples = read_list<EnergySample>(*content.energy(), reader, budget);
    if (const auto* work = content.energy_work()) {
        if (work->size() != samples.size()) {
            throw Error(fmt::format("it has the work of {} energy samples, but {} samples",
                                    work->size(), samples.size()));
        }
        for (std::uint32_t i = 0; i < work->size(); ++i) {
            samples[i].work = work->Get(i);
        }
    }
    return samples;
}

std::vector<Diagnostic> read_warnings(const fb::Content& content, ByteBudget& budget) {
    std::vector<Diagnostic> warnings;
    for (const fb::Warning* warning : *content.warnings()) {
        if (warning->subject() > fb::SubjectKind::MAX) {
            throw Error("a warning is about a subject of an unknown kind");
        }
        warnings.push_back({{static_cast<Subject::Kind>(warning->subject()),
                             budget.text(*warning->name()), warning->event()},
                            budget.text(*warning->field()),
                            budget.text(*warning->sentence()),
                            Severity::warning});
    }
    return warnings;
}

std::vector<Asset> read_assets(const fb::Content& content, ByteBudget& budget) {
    std::vector<Asset> assets;
    for (const fb::Asset* asset : *content.assets()) {
        assets.push_back({budget.text(*asset->path()), from_format(*asset->content_hash())});
    }
    return assets;
}

flatbuffers::Verifier verifier_for(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), kDeepest,
            kMaxTables};
}

/// The inner buffer, after a check that the envelope around it is complete and unchanged. `bytes`
/// are aligned to eight bytes.
std::span<const std::byte> open_envelope(std::span<const std::byte> bytes) {
    // The header is checked first: it is at the beginning, so a truncated file has it too.
    if (!verifier_for(bytes).VerifyBuffer<fb::EnvelopeHead>(nullptr)) {
        throw Error(bytes.size() < 128 ? "is truncated" : "is damaged: its header cannot be read");
    }
    const fb::Head& head = *flatbuffers::GetRoot<fb::EnvelopeHead>(bytes.data())->head();
    if (head.schema_version() != kSchemaVersion) {
        throw OtherBakeVersion(fmt::format(
            "has version {} of the format, but this carom reads version {}: bake the shot again",
            head.schema_version(), kSchemaVersion));
    }
    if (bytes.size() < head.file_size()) {
        throw Error(
            fmt::format("is truncated: it has {} of {} bytes", bytes.size(), head.file_size()));
    }
    if (bytes.size() > head.file_size()) {
        throw Error(fmt::format("is damaged: it has {} bytes instead of {}", bytes.size(),
                                head.file_size()));
    }
    if (!verifier_for(bytes).VerifyBuffer<fb::Envelope>(nullptr)) {
        throw Error("is damaged: its envelope cannot be read");
    }
    const auto* vector = flatbuffers::GetRoot<fb::Envelope>(bytes.data())->content();
    const std::span content(reinterpret_cast<const std::byte*>(vector->data()), vector->size());
    if (content.size() > kLargestContent) {
        throw Error("is larger than 1 GiB");
    }
    if (hash_bytes(content) != from_format(head.content_hash())) {
        throw Error("is damaged: its content does not match its hash");
    }
    // The hash does not cover padding and offsets: only one way to write them is accepted.
    const std::vector<std::byte> expected = encode_envelope(content);
    if (!std::equal(bytes.begin(), bytes.end(), expected.begin(), expected.end())) {
        throw Error("is damaged: its envelope differs from the one that carom writes");
    }
    return content;
}

bool is_aligned(std::span<const std::byte> bytes) {
    return reinterpret_cast<std::uintptr_t>(bytes.data()) % sizeof(double) == 0;
}

}  // namespace

bool has_bake_identifier(std::span<const std::byte> bytes) {
    return bytes.size() >= 8 && std::memcmp(bytes.data() + 4, fb::EnvelopeIdentifier(), 4) == 0;
}

Bake decode_content(std::span<const std::byte> content) {
    if (!verifier_for(content).VerifyBuffer<fb::Content>(nullptr)) {
        throw Error("its content cannot be read");
    }
    const fb::Content& root = *flatbuffers::GetRoot<fb::Content>(content.data());
    ByteBudget budget(content.size());
    Bake bake;
    bake.physics_hash = from_format(*root.physics_hash());
    bake.timeline.start_time = root.start_time();
    bake.timeline.end_time = root.end_time();
    const Names names(root, budget);
    const auto reader = [&names](const char* user) { return FieldReader(names, user); };
    bake.timeline.tracks = read_tracks(root, names, budget);
    bake.timeline.events = read_list<Event>(*root.events(), reader("an event"), budget);
    bake.timeline.energy = read_energy(root, reader("an energy sample"), budget);
    bake.timeline.lasting_contacts =
        read_list<LastingContact>(*root.lasting_contacts(), reader("a lasting contact"), budget);
    bake.timeline.put_backs =
        read_list<PutBack>(*root.put_backs(), reader("a ball put back"), budget);
    bake.timeline.warnings = read_warnings(root, budget);
    bake.shot_text = budget.text(*root.shot_text());
    bake.assets = read_assets(root, budget);
    if (const auto problem = find_problem(bake)) {
        throw Error(*problem);
    }
    return bake;
}

Bake decode_bake(std::span<const std::byte> bytes, const std::string& origin) {
    if (!has_bake_identifier(bytes)) {
        throw Error("'" + origin + "' is not a carom bake");
    }
    std::vector<std::byte> copy;
    if (!is_aligned(bytes)) {
        copy.assign(bytes.begin(), bytes.end());
        bytes = copy;
    }
    std::span<const std::byte> content;
    try {
        content = open_envelope(bytes);
    } catch (const OtherBakeVersion& error) {
        throw OtherBakeVersion("'" + origin + "' " + error.what());
    } catch (const Error& error) {
        throw Error("'" + origin + "' " + error.what());
    }
    try {
        return decode_content(content);
    } catch (const Error& error) {
        throw Error("'" + origin + "' is damaged: " + error.what());
    }
}

}  // namespace carom::sim
