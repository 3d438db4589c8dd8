// Hashes descriptions by the lists of their fields (core/fields.h).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/fields.h"
#include "core/hash.h"

namespace carom {

namespace detail {

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;
template <class T>
inline constexpr bool kIsVariant = false;
template <class... T>
inline constexpr bool kIsVariant<std::variant<T...>> = true;
template <class T>
inline constexpr bool kIsSharedPointer = false;
template <class T>
inline constexpr bool kIsSharedPointer<std::shared_ptr<T>> = true;
template <class T>
inline constexpr bool kIsArray = false;
template <class T, std::size_t kSize>
inline constexpr bool kIsArray<std::array<T, kSize>> = true;
template <class T>
inline constexpr bool kIsPair = false;
template <class A, class B>
inline constexpr bool kIsPair<std::pair<A, B>> = true;

/// A list or map, but not a text.
template <class T>
concept Sequence = std::ranges::sized_range<const T> && !std::convertible_to<T, std::string_view>;

}  // namespace detail

/// How the file of a path is hashed: by what it holds, or by its path, its time and its size, which
/// needs no reading.
enum class FileHash { contents, stamp };

class FieldHasher : public Hasher {
  public:
    explicit FieldHasher(FileHash files = FileHash::contents) : file_hash_(files) {}

    /// Optional values are preceded by a flag that says whether they are present, variants by the
    /// index of their alternative, sequences by their length. Enumerators are hashed as integers,
    /// classes that are not plain structs by hashed_part(value), and all other types by
    /// Hasher::add.
    template <class T>
    FieldHasher& add_value(const T& value) {
        if constexpr (Described<T>) {
            for_each_field(value, [this](const auto& field, const auto& member) {
                this->add_field(field, member);
            });
        } else if constexpr (std::is_enum_v<T>) {
            add(static_cast<std::int64_t>(value));
        } else if constexpr (detail::kIsOptional<T>) {
            add(value.has_value());
            add_if_given(value);
        } else if constexpr (detail::kIsVariant<T>) {
            add(std::uint64_t{value.index()});
            std::visit([this](const auto& alternative) { this->add_value(alternative); }, value);
        } else if constexpr (detail::kIsSharedPointer<T>) {
            add_if_given(value);
        } else if constexpr (std::is_same_v<T, std::monostate>) {
            // Its variant's index says all.
        } else if constexpr (detail::kIsPair<T>) {
            add_value(value.first);
            add_value(value.second);
        } else if constexpr (detail::Sequence<T>) {
            add_sequence(value);
        } else if constexpr (requires { hashed_part(value); }) {
            add_value(hashed_part(value));
        } else {
            add(value);
        }
        return *this;
    }

  private:
    template <class Field, class T>
    void add_field(const Field& /*field*/, const T& value) {
        if constexpr (Field::kRole == FieldRole::value) {
            add_value(value);
        } else if constexpr (Field::kRole == FieldRole::value_if_given) {
            add_if_given(value);
        } else if constexpr (Field::kRole == FieldRole::file) {
            add_file(value);
        }
    }

    template <class Pointer>
    void add_if_given(const Pointer& value) {
        if (value) {
            add_value(*value);
        }
    }

    template <class T>
    void add_sequence(const T& values) {
        if constexpr (!detail::kIsArray<T>) {
            add(std::uint64_t{values.size()});
        }
        for (const auto& value : values) {
            add_value(value);
        }
    }

    // Contents are hashed without the path; each file is read once.
    void add_file(const std::string& path) {
        add(!path.empty());
        if (path.empty()) {
            return;
        }
        if (file_hash_ == FileHash::stamp) {
            add_stamp(path);
            return;
        }
        const auto known = files_.find(path);
        add(known != files_.end() ? known->second
                                  : files_.emplace(path, hash_file(path)).first->second);
    }

    void add_stamp(const std::string& path) {
        std::error_code code;
        const auto time = std::filesystem::last_write_time(path, code);
        add(path).add(code ? std::int64_t{0} : std::int64_t{time.time_since_epoch().count()});
        const std::uintmax_t size = std::filesystem::file_size(path, code);
        add(code ? std::uint64_t{0} : std::uint64_t{size});
    }

    FileHash file_hash_;
    std::map<std::string, Hash128> files_;
};

}  // namespace carom
