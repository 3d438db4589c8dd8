#include "core/hash.h"

#include <bit>
#include <cmath>
#include <new>
#include <vector>

#include <fmt/core.h>
#include <xxhash.h>

#include "core/assert.h"
#include "core/file_reader.h"

namespace carom {

namespace {

static_assert(std::endian::native == std::endian::little,
              "the byte stream is little endian; swap bytes in feed() on other machines");

// Precedes each value, so that values of different types never produce the same bytes.
enum class Tag : std::uint8_t {
    boolean = 1,
    signed_integer,
    unsigned_integer,
    float64,
    float32,
    text,
    vec2,
    vec3,
    quaternion,
    matrix,
    hash,
    bytes
};

Hash128 from_xxhash(const XXH128_hash_t& hash) {
    return {hash.high64, hash.low64};
}

class XxhashState {
  public:
    XxhashState() : state_(XXH3_createState(), &XXH3_freeState) {
        if (!state_) {
            throw std::bad_alloc();
        }
        XXH3_128bits_reset(state_.get());
    }

    void feed(const void* bytes, std::size_t size) {
        XXH3_128bits_update(state_.get(), bytes, size);
    }
    [[nodiscard]] Hash128 digest() const { return from_xxhash(XXH3_128bits_digest(state_.get())); }

  private:
    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

}  // namespace

std::string Hash128::to_string() const {
    return fmt::format("{:016x}{:016x}", high, low);
}

struct Hasher::State : XxhashState {
    using XxhashState::feed;
    void feed(Tag tag) { feed(&tag, sizeof tag); }
    void feed(std::uint64_t value) { feed(&value, sizeof value); }
    void feed(double value) {
        CAROM_ASSERT(!std::isnan(value));
        feed(std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value));
    }
};

Hasher::Hasher() : state_(std::make_unique<State>()) {}
Hasher::~Hasher() = default;

Hasher& Hasher::add(bool value) {
    const std::uint8_t byte = value ? 1 : 0;
    state_->feed(Tag::boolean);
    state_->feed(&byte, 1);
    return *this;
}

Hasher& Hasher::add(std::int64_t value) {
    state_->feed(Tag::signed_integer);
    state_->feed(std::bit_cast<std::uint64_t>(value));
    return *this;
}

Hasher& Hasher::add(std::uint64_t value) {
    state_->feed(Tag::unsigned_integer);
    state_->feed(value);
    return *this;
}

Hasher& Hasher::add(double value) {
    state_->feed(Tag::float64);
    state_->feed(value);
    return *this;
}

Hasher& Hasher::add(float value) {
    CAROM_ASSERT(!std::isnan(value));
    const float canonical = value == 0 ? 0.0F : value;
    state_->feed(Tag::float32);
    state_->feed(&canonical, sizeof canonical);
    return *this;
}

Hasher& Hasher::add(std::string_view text) {
    state_->feed(Tag::text);
    state_->feed(std::uint64_t{text.size()});
    state_->feed(text.data(), text.size());
    return *this;
}

Hasher& Hasher::add(const Vec2& value) {
    state_->feed(Tag::vec2);
    state_->feed(value.x);
    state_->feed(value.y);
    return *this;
}

Hasher& Hasher::add(const Vec3& value) {
    state_->feed(Tag::vec3);
    state_->feed(value.x);
    state_->feed(value.y);
    state_->feed(value.z);
    return *this;
}

Hasher& Hasher::add(const Quat& value) {
    state_->feed(Tag::quaternion);
    state_->feed(value.r);
    state_->feed(value.v.x);
    state_->feed(value.v.y);
    state_->feed(value.v.z);
    return *this;
}

Hasher& Hasher::add(const Mat44& value) {
    state_->feed(Tag::matrix);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            state_->feed(value[row][column]);
        }
    }
    return *this;
}

Hasher& Hasher::add(const Hash128& value) {
    state_->feed(Tag::hash);
    state_->feed(value.high);
    state_->feed(value.low);
    return *this;
}

Hasher& Hasher::add_bytes(std::span<const std::byte> bytes) {
    state_->feed(Tag::bytes);
    state_->feed(std::uint64_t{bytes.size()});
    state_->feed(bytes.data(), bytes.size());
    return *this;
}

Hash128 Hasher::finish() const {
    return state_->digest();
}

Hash128 hash_bytes(std::span<const std::byte> bytes) {
    return from_xxhash(XXH3_128bits(bytes.data(), bytes.size()));
}

Hash128 hash_file(const std::string& path) {
    FileReader file(path);
    XxhashState state;
    std::vector<std::byte> chunk(std::size_t{1} << 18);
    for (;;) {
        const std::size_t size = file.read(chunk);
        state.feed(chunk.data(), size);
        if (size < chunk.size()) {
            return state.digest();
        }
    }
}

}  // namespace carom
